#include "shapetonColonoscopyPictures.h"

#include "shapetonColonFlexures.h"
#include "shapetonColonLandmarkPictures.h"
#include "shapetonJson.h"
#include "shapetonSegmentQuality.h"
#include "shapetonSurfaceRendering.h"
#include "shapetonFlatPictureSize.h"

namespace shapeton
{
namespace
{
const RGBColor glass = MakeColor(206, 190, 184);
const RGBColor loopColor = MakeColor(24, 26, 32);
const RGBColor flexureColor = MakeColor(250, 214, 80);
const RGBColor endColor = MakeColor(240, 240, 240);
const RGBColor foldColor = MakeColor(20, 130, 60);
const RGBColor residueColor = MakeColor(240, 200, 0);
const RGBColor seamColor = MakeColor(60, 120, 220);

constexpr double opacityOfGlass = 0.3; // chosen by eye
/** Radii of tubes and balls, mm. */
constexpr double radiusOfTaeniae = 1.6;
constexpr double radiusOfLoops = 1.6;
constexpr double radiusOfLine = 1.8;
constexpr double radiusOfBalls = 5.0;

std::string
SideInWords(PatientSide side)
{
  return side == PatientSide::Anterior ? "front" : side == PatientSide::Posterior ? "back" : NameOf(side);
}

/** Label of a curve from a cell array, or the index of the curve if the array is missing. */
int
LabelOf(const CurveSet & curves, const char * array, std::size_t curve)
{
  const SurfaceArray * const labels = FindSurfaceArray(curves.cellArrays, array);
  return labels ? static_cast<int>(labels->values(static_cast<Eigen::Index>(curve), 0)) : static_cast<int>(curve) + 1;
}

SurfaceRenderingOptions
OptionsFor(PatientSide side, const std::string & title)
{
  constexpr unsigned int  width = 1000;
  constexpr unsigned int  height = 820;
  SurfaceRenderingOptions options;
  LookFrom(side, options);
  options.width = width;
  options.height = height;
  options.title = title + ", from the " + SideInWords(side);
  return options;
}

void
AddTaeniae(SurfaceScene & scene, const CurveSet & taeniae)
{
  if (taeniae.curves.empty())
  {
    return;
  }
  CurveActor actor{ &taeniae, radiusOfTaeniae };
  actor.vertexColors.resize(taeniae.V.rows());
  for (std::size_t curve = 0; curve < taeniae.curves.size(); ++curve)
  {
    for (const int vertex : taeniae.curves[curve])
    {
      actor.vertexColors[vertex] = ColorOfTaenia(LabelOf(taeniae, "taenia", curve));
    }
  }
  scene.curves.push_back(actor);
}

void
AddFlexureLoops(SurfaceScene & scene, const CurveSet & flexures)
{
  if (!flexures.curves.empty())
  {
    scene.curves.push_back({ &flexures, radiusOfLoops, loopColor });
  }
}

Eigen::Vector3d
MiddleOf(const CurveSet & curves, std::size_t curve)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int vertex : curves.curves[curve])
  {
    sum += curves.V.row(vertex).transpose();
  }
  return sum / static_cast<double>(curves.curves[curve].size());
}

void
AddFlexureNames(SurfaceScene & scene, const CurveSet & flexures)
{
  for (std::size_t curve = 0; curve < flexures.curves.size(); ++curve)
  {
    scene.markers.push_back(
      { MiddleOf(flexures, curve), radiusOfBalls, flexureColor, NameOfFlexure(LabelOf(flexures, "flexure", curve)) });
  }
}

void
AddEnds(SurfaceScene & scene, const CurveSet & centerline)
{
  const std::vector<int> & line = centerline.curves.front();
  scene.markers.push_back({ centerline.V.row(line.front()), radiusOfBalls, endColor, "anal verge" });
  scene.markers.push_back({ centerline.V.row(line.back()), radiusOfBalls, endColor, "cecum" });
}

void
AddCenterline(SurfaceScene & scene, SurfaceRenderingOptions & options, const CurveSet & centerline)
{
  const SurfaceArray * const distance = FindSurfaceArray(centerline.pointArrays, "arcLength");
  CurveActor                 actor{ &centerline, radiusOfLine };
  if (distance && distance->values.size() > 0)
  {
    options.colorBar = ColorScale{ "distance from the anal verge (cm)", 0.0, distance->values.maxCoeff() };
    options.colorBar->shownPerValue = MillimetersAsCentimeters;
    for (Eigen::Index i = 0; i < centerline.V.rows(); ++i)
    {
      actor.vertexColors.push_back(options.colorBar->ColorOf(distance->values(i, 0)));
    }
  }
  scene.curves.push_back(actor);
}

std::vector<FlatLine>
FlatTaeniae(const CurveSet & taeniae)
{
  std::vector<FlatLine>      lines;
  const SurfaceArray * const uv = FindSurfaceArray(taeniae.pointArrays, "uv");
  for (std::size_t curve = 0; uv && uv->values.cols() == 2 && curve < taeniae.curves.size(); ++curve)
  {
    FlatLine line;
    line.color = ColorOfTaenia(LabelOf(taeniae, "taenia", curve));
    for (const int vertex : taeniae.curves[curve])
    {
      line.places.emplace_back(uv->values.row(vertex));
    }
    lines.push_back(line);
  }
  return lines;
}

FlatOutlines
OutlinesOf(const unsigned short * labels, int columns, int rows, const RGBColor & color)
{
  FlatOutlines outlines{ labels, columns, rows, [=](int) { return color; }, 1 };
  return outlines;
}

} // namespace

std::vector<ColonSegment>
ChartSegmentsOf(const ColonoscopyResults & results)
{
  std::vector<ColonSegment> segments;
  for (const ColonSegmentExtent & segment : results.segments)
  {
    segments.push_back({ segment.name, segment.begin, segment.end });
  }
  return segments;
}

Picture::Pointer
DrawSegments(const ColonoscopyResults & results, PatientSide side)
{
  SurfaceScene            scene;
  SurfaceRenderingOptions options = OptionsFor(side, "Segments, taeniae and flexures");
  SurfaceActor            wall;
  wall.surface = results.labeled.F.rows() > 0 ? &results.labeled : &results.wall;
  if (const SurfaceArray * const segment = FindSurfaceArray(results.labeled.cellArrays, "segment"))
  {
    for (Eigen::Index face = 0; face < segment->values.rows(); ++face)
    {
      wall.faceColors.push_back(ColorOfSegment(static_cast<int>(segment->values(face, 0))));
    }
    for (const ColonSegmentExtent & one : results.segments)
    {
      options.legend.push_back({ ColorOfSegment(one.label), one.name });
    }
  }
  else
  {
    options.title = "Wall, from the " + SideInWords(side);
  }
  scene.surfaces.push_back(wall);
  AddTaeniae(scene, results.taeniae);
  AddFlexureLoops(scene, results.flexures);
  return RenderSurfaces(scene, options);
}

Picture::Pointer
DrawInside(const ColonoscopyResults & results, PatientSide side)
{
  SurfaceScene            scene;
  SurfaceRenderingOptions options = OptionsFor(side, "Centerline and flexures");
  SurfaceActor            wall;
  wall.surface = &results.wall;
  wall.color = glass;
  wall.opacity = opacityOfGlass;
  scene.surfaces.push_back(wall);
  AddCenterline(scene, options, results.centerline);
  AddFlexureLoops(scene, results.flexures);
  AddFlexureNames(scene, results.flexures);
  AddEnds(scene, results.centerline);
  return RenderSurfaces(scene, options);
}

std::vector<unsigned short>
CoverPixels(const ColonoscopyResults & results)
{
  if (!results.original)
  {
    return {};
  }
  const std::vector<WallCover> covers =
    FindWallCovers(results.flat->Surface(), results.lumen, AttenuationOf(results.original));
  const FlatColonGrid &       grid = results.flat->Grid();
  std::vector<unsigned short> ofPixels;
  for (int row = 0; row < grid.Rows(); ++row)
  {
    for (int column = 0; column < grid.Columns(); ++column)
    {
      const int       face = grid.FaceOfPixel(column, row);
      const WallCover cover = face >= 0 ? covers[static_cast<std::size_t>(face)] : WallCover::None;
      ofPixels.push_back(static_cast<unsigned short>(cover));
    }
  }
  return ofPixels;
}

Picture::Pointer
DrawFlat(const ColonoscopyResults & results, const std::vector<unsigned short> & covers, FlatColoring coloring)
{
  FlatColonParts parts;
  parts.flat = results.flat.get();
  parts.centerline = &results.centerline;
  parts.ct = results.ct;
  parts.device = results.device;
  parts.annotations = SegmentAnnotations(results.segments);
  if (results.foldLabels)
  {
    const auto size = results.foldLabels->GetBufferedRegion().GetSize();
    parts.outlines.push_back(OutlinesOf(
      results.foldLabels->GetBufferPointer(), static_cast<int>(size[0]), static_cast<int>(size[1]), foldColor));
  }
  if (!covers.empty())
  {
    const FlatColonGrid & grid = results.flat->Grid();
    const auto            colorOf = [](int cover) {
      return cover == static_cast<int>(WallCover::Seam) ? seamColor : residueColor;
    };
    parts.outlines.push_back({ covers.data(), grid.Columns(), grid.Rows(), colorOf, 1 });
  }
  parts.lines = FlatTaeniae(results.taeniae);
  const double circumference = results.flatStatistics.at("circumference").get<double>();
  return FlatColonPictures(parts, circumference / pixelsAround).Draw(coloring, "", pixelsOfRow);
}
} // namespace shapeton
