#include "shapetonSegmentQuality.h"

#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"
#include "shapetonSurfaceLocator.h"

#include "itkLinearInterpolateImageFunction.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
/** Label of tagged fluid in a LumenMask. */
constexpr unsigned char fluidLabel = 2;

constexpr double inLumen = 2.0; // mm from the wall, beyond the blur of a scan

/** The segment of each face. */
std::vector<int>
SegmentsOfFaces(const SurfaceMesh & wall)
{
  const SurfaceArray * const array = FindSurfaceArray(wall.cellArrays, "segment");
  if (!array)
  {
    throw InputError("the wall lacks the cell array \"segment\"; use segments.vtp of ColonLandmarks");
  }
  std::vector<int> segments;
  for (Eigen::Index f = 0; f < array->values.rows(); ++f)
  {
    segments.push_back(static_cast<int>(std::lround(array->values(f, 0))));
  }
  return segments;
}

/** Sums over the wall of a segment. */
struct WallSums
{
  double area{ 0.0 };
  double submerged{ 0.0 };
  double fluidArea{ 0.0 };
  double fluidSum{ 0.0 }; ///< HU mm^2
  double residueArea{ 0.0 };
  double seamArea{ 0.0 };
};

using SumsOfSegments = std::array<WallSums, NumberOfColonSegments + 1>;

unsigned char
LabelAt(const LumenMask * lumen, const Eigen::Vector3d & point)
{
  LumenMask::IndexType index;
  const bool           isInside = lumen->TransformPhysicalPointToIndex(itk::Point<double, 3>(point.data()), index);
  return isInside ? lumen->GetPixel(index) : 0;
}

bool
IsNearFluid(const LumenMask * lumen, const Eigen::Vector3d & point)
{
  constexpr double near = 4.0; // mm: beyond the depth of residue and the blur of a scan
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double way : { -near, near })
    {
      if (LabelAt(lumen, point + way * Eigen::Vector3d::Unit(axis)) == fluidLabel)
      {
        return true;
      }
    }
  }
  return false;
}

/** A face, seen from the lumen. */
struct FaceFront
{
  Eigen::Vector3d middle;
  Eigen::Vector3d inwards;
  double          area;
};

FaceFront
FrontOf(const SurfaceMesh & wall, int face)
{
  const auto            corner = [&](int k) -> Eigen::Vector3d { return wall.V.row(wall.F(face, k)); };
  const Eigen::Vector3d cross = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  return { (corner(0) + corner(1) + corner(2)) / 3.0, -cross.stableNormalized(), 0.5 * cross.norm() };
}

bool
IsSubmerged(const LumenMask * lumen, const FaceFront & front)
{
  return LabelAt(lumen, front.middle + inLumen * front.inwards) == fluidLabel;
}

/** Whether there is tagged matter behind a wall that is under gas. */
bool
IsCoated(const LumenMask * lumen, const AttenuationAt & original, const FaceFront & front)
{
  constexpr double tagged = 300.0;            // HU, as for candidates: see TissueLikelihood()
  constexpr double deepest = 2.0, step = 0.5; // mm
  for (double depth = step; depth <= deepest; depth += step)
  {
    if (original(front.middle - depth * front.inwards) > tagged)
    {
      return !IsSubmerged(lumen, front) && !IsNearFluid(lumen, front.middle);
    }
  }
  return false;
}

/** Whether there is tagged matter behind a wall that is under fluid: contrast that is too weak for the fluid of the
 * lumen, or bowel that touches. Folds are left out, since lumen is behind them. */
bool
IsAboveWeakFluid(const LumenMask * lumen, const AttenuationAt & original, const FaceFront & front)
{
  constexpr double weak = 200.0;                           // HU: soft tissue of 50 HU and 3 times a noise of 50 HU
  constexpr double first = 1.0, deepest = 3.0, step = 0.5; // mm; the blur of a pool ends before the last one
  if (!IsSubmerged(lumen, front))
  {
    return false;
  }
  for (double depth = first; depth <= deepest; depth += step)
  {
    const Eigen::Vector3d place = front.middle - depth * front.inwards;
    if (LabelAt(lumen, place) != 0 || !(original(place) > weak))
    {
      return false;
    }
  }
  return true;
}

/** Whether gas and tagged fluid meet near a face, without tissue in between. */
bool
IsAtSeam(const LumenMask * lumen, const FaceFront & front)
{
  constexpr double      step = 0.5; // mm
  constexpr int         steps = 5;  // 2.5 mm: beyond it, the wall of a phantom is as exact as elsewhere
  const Eigen::Vector3d start = front.middle + inLumen * front.inwards;
  const unsigned char   here = LabelAt(lumen, start);
  for (int way = 0; way < 6 && here != 0; ++way)
  {
    const Eigen::Vector3d stride = (way % 2 == 0 ? step : -step) * Eigen::Vector3d::Unit(way / 2);
    for (int i = 1; i <= steps; ++i)
    {
      const unsigned char there = LabelAt(lumen, start + i * stride);
      if (there == 0)
      {
        break;
      }
      if (there != here)
      {
        return true;
      }
    }
  }
  return false;
}

/** Adds a face to the sums, depending on the lumen in front of it. */
void
AddFace(const SegmentQualityInput & input, const FaceFront & front, WallCover cover, WallSums & sums)
{
  constexpr double inFluid = 3.0, beyond = 4.5; // mm from the wall, beyond the blur of a scan
  sums.area += front.area;
  sums.residueArea += cover == WallCover::Residue ? front.area : 0.0;
  sums.seamArea += cover == WallCover::Seam ? front.area : 0.0;
  if (!IsSubmerged(input.lumen, front))
  {
    return;
  }
  sums.submerged += front.area;
  if (input.attenuation && LabelAt(input.lumen, front.middle + beyond * front.inwards) == fluidLabel)
  {
    const double value = input.attenuation(front.middle + inFluid * front.inwards);
    sums.fluidArea += std::isfinite(value) ? front.area : 0.0;
    sums.fluidSum += std::isfinite(value) ? front.area * value : 0.0;
  }
}

SegmentQuality *
FindRow(std::vector<SegmentQuality> & rows, int segment)
{
  const auto found =
    std::find_if(rows.begin(), rows.end(), [=](const SegmentQuality & row) { return row.extent.label == segment; });
  return found == rows.end() ? nullptr : &*found;
}

/** Assigns places to the segment of the nearest wall. */
class SegmentFinder
{
public:
  SegmentFinder(const SurfaceMesh & wall, const std::vector<int> & segmentOfFace, std::vector<SegmentQuality> & rows)
    : m_Locator(wall.V, wall.F), m_SegmentOfFace(segmentOfFace), m_Rows(rows)
  {}

  /** Null outside the known segments. */
  SegmentQuality *
  RowAt(const Eigen::Vector3d & place) const
  {
    return FindRow(m_Rows, m_SegmentOfFace[static_cast<std::size_t>(m_Locator.FindClosest(place).face)]);
  }

private:
  SurfaceLocator                m_Locator;
  const std::vector<int> &      m_SegmentOfFace;
  std::vector<SegmentQuality> & m_Rows;
};

void
AddWall(const SegmentQualityInput & input, const std::vector<int> & segmentOfFace, std::vector<SegmentQuality> & rows)
{
  SumsOfSegments               sums;
  const std::vector<WallCover> covers = input.attenuation
                                          ? FindWallCovers(*input.wall, input.lumen, input.attenuation)
                                          : std::vector<WallCover>(segmentOfFace.size(), WallCover::None);
  for (std::size_t f = 0; f < segmentOfFace.size(); ++f)
  {
    AddFace(
      input, FrontOf(*input.wall, static_cast<int>(f)), covers[f], sums.at(static_cast<std::size_t>(segmentOfFace[f])));
  }
  for (SegmentQuality & row : rows)
  {
    const WallSums & sum = sums.at(static_cast<std::size_t>(row.extent.label));
    row.submergedShare = sum.area > 0.0 ? sum.submerged / sum.area : std::numeric_limits<double>::quiet_NaN();
    row.fluidAttenuation = sum.fluidSum / sum.fluidArea; // NaN without fluid
    if (input.attenuation)
    {
      row.residueArea = sum.residueArea;
      row.seamArea = sum.seamArea;
    }
  }
}

std::vector<SegmentQuality>
QualityAlongLine(const CurveSet & centerline, const std::vector<ColonSegmentExtent> & segments)
{
  const std::vector<HinderedStretch> stretches = FindHinderedStretches(centerline);
  std::vector<SegmentQuality>        rows;
  for (const ColonSegmentExtent & segment : segments)
  {
    SegmentQuality row;
    row.extent = segment;
    row.distension =
      MeasureDistension(centerline, std::min(segment.end, std::max(segment.begin, AnalCanalLength)), segment.end);
    row.grade = GradeOf(row.distension);
    row.assessability = Assess(stretches, segment.begin, segment.end);
    rows.push_back(row);
  }
  return rows;
}

std::string
Number(double value)
{
  constexpr int digits = 6; // significant, in tables
  return std::isfinite(value) ? CsvTable::Rounded(value, digits) : "";
}
} // namespace

AttenuationAt
AttenuationOf(const itk::Image<float, 3> * ct)
{
  const auto interpolator = itk::LinearInterpolateImageFunction<itk::Image<float, 3>, double>::New();
  interpolator->SetInputImage(ct);
  return [=](const Eigen::Vector3d & place) {
    const itk::Point<double, 3> point(place.data());
    return interpolator->IsInsideBuffer(point) ? interpolator->Evaluate(point)
                                               : std::numeric_limits<double>::quiet_NaN();
  };
}

std::vector<WallCover>
FindWallCovers(const SurfaceMesh & wall, const LumenMask * lumen, const AttenuationAt & original)
{
  std::vector<WallCover> covers(static_cast<std::size_t>(wall.NumberOfFaces()), WallCover::None);
  ParallelForBlocks(covers.size(), [&](std::size_t face) {
    const FaceFront front = FrontOf(wall, static_cast<int>(face));
    const bool      isCovered = IsCoated(lumen, original, front) || IsAboveWeakFluid(lumen, original, front);
    covers[face] = IsAtSeam(lumen, front) ? WallCover::Seam : isCovered ? WallCover::Residue : WallCover::None;
  });
  return covers;
}

std::string
NameOf(DistensionGrade grade)
{
  // In the order of DistensionGrade.
  constexpr std::array<const char *, 5> names{ { "", "collapsed", "inadequate", "adequate", "optimal" } };
  return names.at(static_cast<std::size_t>(grade));
}

DistensionGrade
GradeOf(const ColonDistension & distension)
{
  constexpr double half = 0.5, most = 0.9;             // of the length, as for ColonAssessability::Verdict()
  constexpr double wide = 2.0 * LeastDistendedCaliber; // mm; chosen: twice the limit of collapse
  return distension.share < half         ? DistensionGrade::Collapsed
         : distension.share < most       ? DistensionGrade::Inadequate
         : distension.meanCaliber < wide ? DistensionGrade::Adequate
                                         : DistensionGrade::Optimal;
}

double
SegmentQuality::EvaluableShare() const
{
  const double seams = std::isfinite(seamArea) ? seamArea : 0.0;
  const double shown = extent.area > 0.0 ? 1.0 - (hiddenArea + seams) / extent.area : 1.0;
  return std::min(assessability.share, std::max(shown, 0.0));
}

std::vector<SegmentQuality>
MeasureSegmentQuality(const SegmentQualityInput & input)
{
  std::vector<SegmentQuality> rows = QualityAlongLine(*input.centerline, input.segments);
  const std::vector<int>      segmentOfFace = SegmentsOfFaces(*input.wall);
  const SegmentFinder         finder(*input.wall, segmentOfFace, rows);
  for (const HiddenWall & hidden : input.hidden)
  {
    if (SegmentQuality * const row = finder.RowAt(hidden.place))
    {
      row->hiddenArea += hidden.area;
      ++row->hiddenParts;
      row->largestHidden = hidden.area > row->largestHidden.area ? hidden : row->largestHidden;
    }
  }
  if (input.lumen)
  {
    AddWall(input, segmentOfFace, rows);
  }
  return rows;
}

CsvTable
TableOfSegmentQuality(const std::vector<SegmentQuality> & segments)
{
  CsvTable table({ "segment",
                   "begin",
                   "end",
                   "distension",
                   "distendedShare",
                   "leastCaliber",
                   "meanCaliber",
                   "largestCaliber",
                   "assessableShare",
                   "evaluableShare",
                   "verdict",
                   "submergedShare",
                   "fluidHU",
                   "residueArea",
                   "seamArea",
                   "untaggedFluid",
                   "hiddenArea",
                   "hiddenParts",
                   "otherAssessableShare",
                   "eitherAssessableShare" });
  for (const SegmentQuality & one : segments)
  {
    const auto untagged = static_cast<std::size_t>(ColonHindrance::UntaggedFluid);
    table.AddRow({ one.extent.name,
                   Number(one.extent.begin),
                   Number(one.extent.end),
                   NameOf(one.grade),
                   Number(one.distension.share),
                   Number(one.distension.leastCaliber),
                   Number(one.distension.meanCaliber),
                   Number(one.distension.largestCaliber),
                   Number(one.assessability.share),
                   Number(one.EvaluableShare()),
                   one.assessability.Verdict(),
                   Number(one.submergedShare),
                   Number(one.fluidAttenuation),
                   Number(one.residueArea),
                   Number(one.seamArea),
                   Number(one.assessability.lengths.at(untagged)),
                   Number(one.hiddenArea),
                   std::to_string(one.hiddenParts),
                   Number(one.otherShare),
                   Number(one.eitherShare) });
  }
  return table;
}
} // namespace shapeton
