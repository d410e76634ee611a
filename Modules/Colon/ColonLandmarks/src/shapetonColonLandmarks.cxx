#include "shapetonColonLandmarks.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{

SurfaceArray
IntegerArray(const std::string & name, const std::vector<int> & values)
{
  SurfaceArray array{ name, SurfaceArray::ValueMatrix(values.size(), 1), true };
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array.values(i, 0) = values[i];
  }
  return array;
}

void
SetArray(std::vector<SurfaceArray> & arrays, const SurfaceArray & array)
{
  arrays.erase(
    std::remove_if(arrays.begin(), arrays.end(), [&](const SurfaceArray & a) { return a.name == array.name; }),
    arrays.end());
  arrays.push_back(array);
}
/** The taenia of number numbers[i] becomes taenia i + 1. */
void
Renumber(const std::array<int, 3> & numbers, ColonTaeniae & found)
{
  auto sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  RequireParameter(sorted == (std::array<int, 3>{ { 1, 2, 3 } }), "the taenia numbers must be 1, 2 and 3 in any order");
  const ColonTaeniae before = found;
  for (std::size_t i = 0; i < found.taeniae.size(); ++i)
  {
    found.taeniae[i] = before.taeniae[numbers[i] - 1];
    for (std::size_t m = 0; m < before.markers.size(); ++m)
    {
      found.markers[m].taenia =
        before.markers[m].taenia == numbers[i] ? static_cast<int>(i + 1) : found.markers[m].taenia;
    }
  }
}

/** Adds a remark for each segment that cannot be evaluated completely. */
void
WarnOfHindrances(ColonLandmarks & landmarks)
{
  for (int segment = 1; segment <= NumberOfColonSegments; ++segment)
  {
    const std::optional<ColonAssessability> assessability = AssessabilityOfSegment(landmarks, segment);
    if (!assessability || assessability->Verdict() == "assessable")
    {
      continue;
    }
    std::string why;
    for (const ColonHindrance hindrance : assessability->Hindrances())
    {
      why += (why.empty() ? "" : "; ") + InWords(hindrance) + " (" +
             std::to_string(std::lround(assessability->lengths[static_cast<int>(hindrance)])) + " mm)";
    }
    landmarks.warnings.push_back(
      "the " + NameOfSegment(segment) + " is " +
      (assessability->Verdict() == "partly" ? "partly evaluable, " : "not evaluable: evaluable along ") +
      std::to_string(std::lround(100.0 * assessability->share)) + " % of its length; " + why);
  }
}

void
AddHindrances(const CurveSet & centerline, ColonLandmarks & landmarks)
{
  if (!TellsHindrances(centerline))
  {
    return;
  }
  landmarks.hindered = FindHinderedStretches(centerline);
  landmarks.lengthOfCenterline = PointValues(centerline, "arcLength", "the centerline").maxCoeff();
  WarnOfHindrances(landmarks);
}
} // namespace

ColonLandmarks
FindColonLandmarks(const FlatColon & flat, const CurveSet & centerline, const ColonLandmarkSettings & options)
{
  ColonLandmarks result;
  options.progress("Matching the centerline", 0.0);
  const auto tube = std::make_shared<const ColonWallTube>(flat, centerline);
  result.tube = tube;
  AppendRemarks(result.warnings, tube->Warnings());

  options.progress("Finding flexures", 0.1);
  result.flexures = FindColonFlexures(centerline, options.flexureRule, options.pelvis);
  result.pelvis = options.pelvis;
  AppendRemarks(result.warnings, result.flexures.warnings);
  result.segments =
    FindColonSegments(*tube, centerline, result.flexures, options.progress.Part("Finding segments", 0.1, 0.2));
  AppendRemarks(result.warnings, result.segments.warnings);
  result.valve = IleocecalValveOf(centerline);
  if (result.valve)
  {
    Eigen::Index nearest = 0;
    (tube->Points().rowwise() - result.valve->position.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    result.valveUv = tube->Uv(static_cast<int>(nearest));
  }

  options.progress("Finding folds", 0.2);
  result.folds = FindSurfaceFolds(flat, {}, options.progress.Part("Finding folds", 0.2, 0.4));

  options.progress("Finding taeniae", 0.4);
  ColonTaeniaOptions taeniaOptions;
  taeniaOptions.rule = options.taeniaRule;
  taeniaOptions.markers = options.markers;
  taeniaOptions.progress = options.progress.Part("Finding taeniae", 0.4, 1.0);
  result.taeniae = FindColonTaeniae(flat, *tube, taeniaOptions);
  Renumber(options.taeniaNumbers, result.taeniae);
  result.taeniaNames = NameTaeniae(result.taeniae, centerline, result.segments);
  if (result.flexures.isMirrored)
  {
    result.taeniaNames.names.fill(TaeniaName::Unknown);
    result.taeniaNames.reason = "left and right of the colon are exchanged";
  }
  AppendRemarks(result.warnings, result.taeniae.warnings);
  AddHindrances(centerline, result);
  options.progress("Finding taeniae", 1.0);
  return result;
}

std::optional<ColonAssessability>
AssessabilityOfSegment(const ColonLandmarks & landmarks, int segment)
{
  const auto arcLengthOf = [&](int number) {
    double arcLength = std::numeric_limits<double>::quiet_NaN();
    for (const SegmentBorder & border : landmarks.segments.borders)
    {
      arcLength = border.number == number ? border.arcLength : arcLength;
    }
    return arcLength;
  };
  const double begin = segment == 1 ? 0.0 : arcLengthOf(segment - 1);
  const double end = segment == NumberOfColonSegments ? landmarks.lengthOfCenterline : arcLengthOf(segment);
  return landmarks.hindered && std::isfinite(begin) && std::isfinite(end)
           ? std::optional(Assess(*landmarks.hindered, begin, end))
           : std::nullopt;
}

CurveSet
FlexureCurves(const ColonLandmarks & landmarks)
{
  CurveSet                           curves;
  std::vector<const SegmentBorder *> borders;
  int                                vertices = 0;
  for (const SegmentBorder & border : landmarks.segments.borders)
  {
    if (border.number <= 4)
    {
      borders.push_back(&border);
      vertices += static_cast<int>(border.loop.vertices.size());
    }
  }
  curves.V.resize(vertices, 3);
  SurfaceArray number{ "flexure", SurfaceArray::ValueMatrix(borders.size(), 1), true };
  SurfaceArray arcLength{ "arcLength", SurfaceArray::ValueMatrix(borders.size(), 1), false };
  SurfaceArray confidence{ "confidence", SurfaceArray::ValueMatrix(borders.size(), 1), false };
  int          next = 0;
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    curves.curves.emplace_back();
    for (const int vertex : borders[i]->loop.vertices)
    {
      curves.V.row(next) = landmarks.tube->Points().row(vertex);
      curves.curves.back().push_back(next++);
    }
    curves.curves.back().push_back(curves.curves.back().front());
    number.values(i, 0) = borders[i]->number;
    arcLength.values(i, 0) = borders[i]->arcLength;
    confidence.values(i, 0) = borders[i]->confidence;
  }
  curves.cellArrays = { number, arcLength, confidence };
  return curves;
}

SurfaceMesh
SegmentSurface(const SurfaceMesh & flat, const ColonLandmarks & landmarks)
{
  SurfaceMesh surface = flat;
  SetArray(surface.cellArrays, IntegerArray("segment", landmarks.segments.segmentOfFace));
  return surface;
}

SurfaceMesh
FoldSurface(const SurfaceMesh & flat, const ColonLandmarks & landmarks)
{
  SurfaceMesh surface = flat;
  SetArray(surface.cellArrays, IntegerArray("fold", landmarks.folds.foldOfFace));
  SetArray(surface.pointArrays, { "meanCurvature", landmarks.folds.curvature, false });
  return surface;
}
} // namespace shapeton
