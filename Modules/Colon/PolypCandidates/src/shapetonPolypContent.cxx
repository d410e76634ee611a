#include "shapetonPolypContent.h"

#include "shapetonCandidateList.h"
#include "shapetonMappedImage.h"
#include "shapetonQuantiles.h"

#include "itkLinearInterpolateImageFunction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shapeton
{
namespace
{
/** Label of tagged fluid in the lumen image. */
constexpr unsigned char fluidLabel = 2;

double
Step(double value, double middle, double width)
{
  return 1.0 / (1.0 + std::exp(-(value - middle) / width));
}

/** Label at a position in the lumen image; 0 outside. */
class LumenAt
{
public:
  explicit LumenAt(const PolypLumenImage * lumen) : m_Lumen(lumen) {}

  unsigned char
  operator()(const Eigen::Vector3d & point) const
  {
    PolypLumenImage::IndexType index;
    const bool isInside = m_Lumen->TransformPhysicalPointToIndex(itk::Point<double, 3>(point.data()), index);
    return isInside ? m_Lumen->GetPixel(index) : 0;
  }

  /** Distance (mm) up to which there is no lumen in any of 26 directions; at most 3, in steps of 0.6. */
  double
  Clearance(const Eigen::Vector3d & point) const
  {
    return std::max(0, this->StepsTo(point, [](unsigned char label) { return label != 0; }) - 1) * step;
  }

  /** Whether fluid is within 3 mm. */
  bool
  IsNearFluid(const Eigen::Vector3d & point) const
  {
    return this->StepsTo(point, [](unsigned char label) { return label == fluidLabel; }) <= steps;
  }

private:
  static constexpr double step = 0.6; // mm
  static constexpr int    steps = 5;  ///< 3 mm in total

  /** Number of steps to the nearest such label in 26 directions; steps + 1 if there is none. */
  template <typename TIsIt>
  int
  StepsTo(const Eigen::Vector3d & point, const TIsIt & isIt) const
  {
    for (int i = 0; i <= steps; ++i)
    {
      for (int direction = 0; direction < 27; ++direction)
      {
        const Eigen::Vector3d way(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
        if (isIt((*this)(point + i * step * way.stableNormalized())))
        {
          return i;
        }
      }
    }
    return steps + 1;
  }

  const PolypLumenImage * m_Lumen;
};

/** A sample inside a head: distance to the lumen (mm), and HU. */
struct InnerPoint
{
  double clearance;
  double hounsfield;
};

/** Distance (mm) from the surface of a head to its center. */
double
DepthOf(const PolypCandidate & candidate)
{
  constexpr double least = 1.5, greatest = 6.0; // mm; chosen: beyond the blur, not behind the wall
  return std::clamp(0.5 * candidate.leastDiameter, least, greatest);
}

Eigen::Vector3d
MiddleOf(const SurfaceMesh & wall, const PolypCandidate & candidate)
{
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int vertex : candidate.vertices)
  {
    middle += wall.V.row(vertex).transpose() / static_cast<double>(candidate.vertices.size());
  }
  return middle - DepthOf(candidate) * candidate.axis;
}

/** Samples on the lines from the vertices of a head to its center. */
std::vector<InnerPoint>
InnerPointsOf(const SurfaceMesh &                                                       wall,
              const PolypCandidate &                                                    candidate,
              const itk::LinearInterpolateImageFunction<itk::Image<float, 3>, double> & ct,
              const LumenAt &                                                           lumen)
{
  const double            depth = DepthOf(candidate);
  const Eigen::Vector3d   middle = MiddleOf(wall, candidate);
  std::vector<InnerPoint> points;
  for (const int vertex : candidate.vertices)
  {
    const Eigen::Vector3d surface = wall.V.row(vertex).transpose();
    const Eigen::Vector3d way = (middle - surface).stableNormalized();
    for (double below = 1.0; below <= std::min(depth, (middle - surface).norm()); below += 0.5)
    {
      const Eigen::Vector3d       point = surface + below * way;
      const itk::Point<double, 3> place(point.data());
      if (ct.IsInsideBuffer(place))
      {
        points.push_back({ lumen.Clearance(point), ct.Evaluate(place) });
      }
    }
  }
  return points;
}

constexpr long fewest = 5; // samples that are enough for a median

/** Distance (mm) from the lumen up to which it affects a value: half a voxel of 0.8 mm and the blur of a scan, or a
 * voxel if that is larger. */
double
ReachOfLumen(const itk::Image<float, 3> * ct)
{
  constexpr double blur = 1.2; // mm
  const auto       spacing = ct->GetSpacing();
  return std::max({ blur, spacing[0], spacing[1], spacing[2] });
}

/** Number of samples at least this far from the lumen. */
long
NumberAway(const std::vector<InnerPoint> & points, double distance)
{
  return std::count_if(
    points.begin(), points.end(), [=](const InnerPoint & point) { return point.clearance >= distance; });
}

/** Sorted HU of the samples at least this far from the lumen, or of the deepest quarter if these are too few. */
std::vector<double>
ValuesAwayFromLumen(std::vector<InnerPoint> points, double distance)
{
  std::stable_sort(
    points.begin(), points.end(), [](const InnerPoint & a, const InnerPoint & b) { return a.clearance > b.clearance; });
  const long away = NumberAway(points, distance);
  points.resize(away >= fewest ? static_cast<std::size_t>(away) : (points.size() + 3) / 4);
  std::vector<double> values;
  for (const InnerPoint & point : points)
  {
    values.push_back(point.hounsfield);
  }
  std::sort(values.begin(), values.end());
  return values;
}

double
Quantile(const std::vector<double> & sorted, double share)
{
  return sorted.empty() ? std::numeric_limits<double>::quiet_NaN() : SortedQuantile(sorted, share);
}

double
MeanOf(const std::vector<double> & values)
{
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/** Sorted HU inside a head where the lumen does not affect them, and below the film of contrast medium, if there is
 * one. */
std::vector<double>
ValuesInside(const std::vector<InnerPoint> & points, double reach)
{
  constexpr double          film = 0.6; // mm of contrast
  const std::vector<double> inside = ValuesAwayFromLumen(points, reach);
  if (TissueOf(Quantile(inside, 0.5)) != PolypTissue::Tagged)
  {
    return inside;
  }
  const std::vector<double> core = ValuesAwayFromLumen(points, reach + film);
  return TissueOf(Quantile(core, 0.5)) == PolypTissue::Soft ? core : inside;
}

void
MeasureAttenuation(const std::vector<InnerPoint> & points, double reach, PolypCandidate & candidate)
{
  const std::vector<double> values = ValuesInside(points, reach);
  constexpr double          low = 0.05, high = 0.95; // quantiles of the report
  constexpr double          leastOfFat = -200.0;     // HU: fat of -100 HU and twice a noise of 50 HU
  candidate.attenuation = Quantile(values, 0.5);
  candidate.lowAttenuation = Quantile(values, low);
  candidate.highAttenuation = Quantile(values, high);
  candidate.meanAttenuation = MeanOf(values);
  candidate.tissue = TissueOf(candidate.attenuation);
  candidate.lookalike = candidate.tissue == PolypTissue::Gas      ? PolypLookalike::Gas
                        : candidate.tissue == PolypTissue::Tagged ? PolypLookalike::Tagged
                                                                  : PolypLookalike::None;
  if (candidate.lookalike == PolypLookalike::None && NumberAway(points, reach) < fewest)
  {
    candidate.tissue = PolypTissue::Unknown; // a mixture with gas or fluid
  }
  else if (candidate.lookalike == PolypLookalike::None && candidate.lowAttenuation < leastOfFat)
  {
    candidate.tissue = PolypTissue::WithGas;
  }
}

/** Fraction of the vertices of a head covered by fluid. */
double
SubmergedShare(const SurfaceMesh & wall, const PolypCandidate & candidate, const LumenAt & lumen)
{
  constexpr double      before = 1.5; // mm; chosen: beyond the blur
  const Eigen::Vector3d middle = MiddleOf(wall, candidate);
  int                   wet = 0;
  for (const int vertex : candidate.vertices)
  {
    const Eigen::Vector3d surface = wall.V.row(vertex).transpose();
    wet += lumen(surface + before * (surface - middle).stableNormalized()) == fluidLabel ? 1 : 0;
  }
  return static_cast<double>(wet) / static_cast<double>(candidate.vertices.size());
}

/** Fraction of the vertices of a head that have contrast on or directly below the surface and are not near fluid. */
double
FilmShare(const SurfaceMesh &                                                       wall,
          const PolypCandidate &                                                    candidate,
          const itk::LinearInterpolateImageFunction<itk::Image<float, 3>, double> & ct,
          const LumenAt &                                                           lumen)
{
  constexpr double      above = 1.0, below = 1.5, step = 0.5; // mm
  constexpr double      leastOfFilm = 250.0;                  // HU: soft tissue of 50 HU and 4 times a noise of 50 HU
  const Eigen::Vector3d middle = MiddleOf(wall, candidate);
  int                   coated = 0;
  for (const int vertex : candidate.vertices)
  {
    const Eigen::Vector3d surface = wall.V.row(vertex).transpose();
    const Eigen::Vector3d outwards = (surface - middle).stableNormalized();
    double                greatest = -std::numeric_limits<double>::infinity();
    for (double height = -below; height <= above; height += step)
    {
      const Eigen::Vector3d       point = surface + height * outwards;
      const itk::Point<double, 3> place(point.data());
      greatest = ct.IsInsideBuffer(place) ? std::max(greatest, ct.Evaluate(place)) : greatest;
    }
    coated += greatest >= leastOfFilm && !lumen.IsNearFluid(surface) ? 1 : 0;
  }
  return static_cast<double>(coated) / static_cast<double>(candidate.vertices.size());
}

constexpr double LeastUnder = 0.9;    // fraction of the surface: all but its blurred border
constexpr double LeastAtLevel = 0.15; // more than the rim of a head beside fluid

bool
IsAtLevel(const PolypCandidate & candidate)
{
  return candidate.submergedShare > LeastAtLevel && candidate.submergedShare <= LeastUnder;
}

/** Whether a head at a level is a mixture of gas and fluid that cleansing turned into a wafer like tissue: it changed
 * most of the head. */
bool
IsWafer(const PolypCandidate & candidate)
{
  // HU. Seams change by 180 (a real scan) and 370 to 380 (a real scan and a phantom), polyps at levels by 4 to 16, and
  // small polyps all under fluid by up to 130, half of which is left at a level.
  constexpr double leastChange = 120.0;
  return IsAtLevel(candidate) && candidate.uncleansedAttenuation - candidate.meanAttenuation >= leastChange;
}

std::string
RemarkOn(const PolypCandidate & candidate)
{
  constexpr double leastCoated = 0.01; // fraction of the surface; a drop at a tip in a real scan has 0.016

  if (candidate.tissue == PolypTissue::Gas)
  {
    return "gas: a bubble or a film";
  }
  if (candidate.tissue == PolypTissue::Tagged)
  {
    return "tagged: stool or residue";
  }
  if (candidate.tissue == PolypTissue::WithGas)
  {
    return "gas inside, as in stool";
  }
  if (candidate.submergedShare > LeastUnder)
  {
    return "under tagged fluid";
  }
  if (IsAtLevel(candidate))
  {
    return "at a fluid level: cleansing made part of its surface";
  }
  return candidate.filmShare >= leastCoated ? "contrast on its surface" : "";
}
} // namespace

double
TissueLikelihood(double hounsfield, double submergedShare)
{
  // In HU: the middles and widths of the steps from a bubble to a polyp, next to gas and under fluid, and from a polyp
  // to tagged stool. On phantoms, bubbles under fluid have -307 to -124 HU, polyp heads at least -102 HU.
  constexpr double besideGas = -300.0, widthBesideGas = 35.0;
  constexpr double underFluid = -130.0, widthUnderFluid = 20.0;
  constexpr double tagged = 225.0, widthOfTagged = 25.0;
  constexpr double ofTagged = 0.25; // likelihood
  if (!std::isfinite(hounsfield))
  {
    return 1.0;
  }
  const double wet = std::isfinite(submergedShare) ? submergedShare : 0.0;
  return Step(hounsfield,
              besideGas + wet * (underFluid - besideGas),
              widthBesideGas - (widthBesideGas - widthUnderFluid) * wet) *
         (1.0 - (1.0 - ofTagged) * Step(hounsfield, tagged, widthOfTagged));
}

void
MeasureContent(const SurfaceMesh &           wall,
               const itk::Image<float, 3> *  ct,
               const PolypLumenImage *       lumen,
               std::vector<PolypCandidate> & candidates)
{
  const auto interpolator = itk::LinearInterpolateImageFunction<itk::Image<float, 3>, double>::New();
  interpolator->SetInputImage(ct);
  const LumenAt lumenAt(lumen);
  const double  reach = ReachOfLumen(ct);
  for (PolypCandidate & candidate : candidates)
  {
    MeasureAttenuation(InnerPointsOf(wall, candidate, *interpolator, lumenAt), reach, candidate);
    candidate.submergedShare = SubmergedShare(wall, candidate, lumenAt);
    candidate.filmShare = FilmShare(wall, candidate, *interpolator, lumenAt);
    candidate.remark = RemarkOn(candidate);
    candidate.score = candidate.shapeScore * TissueLikelihood(candidate.attenuation, candidate.submergedShare);
  }
  Rank(candidates);
}

void
NoteResidue(const SurfaceMesh &           wall,
            const itk::Image<float, 3> *  original,
            const PolypLumenImage *       lumen,
            std::vector<PolypCandidate> & candidates)
{
  constexpr double leastOfFluid = 300.0; // HU; blur raises heads under fluid to less than 150 HU
  const auto       interpolator = itk::LinearInterpolateImageFunction<itk::Image<float, 3>, double>::New();
  interpolator->SetInputImage(original);
  const LumenAt lumenAt(lumen);
  for (PolypCandidate & candidate : candidates)
  {
    const std::vector<double> before =
      ValuesInside(InnerPointsOf(wall, candidate, *interpolator, lumenAt), ReachOfLumen(original));
    candidate.uncleansedAttenuation = MeanOf(before);
    const bool isResidue = Quantile(before, 0.5) >= leastOfFluid || IsWafer(candidate);
    if (candidate.lookalike == PolypLookalike::None && isResidue)
    {
      candidate.lookalike = PolypLookalike::Residue;
      AddRemark(NameOf(candidate.lookalike), candidate);
    }
  }
}

itk::Image<unsigned short, 3>::Pointer
LabelPolypHeads(const SurfaceMesh & wall, const PolypLumenImage * lumen, const std::vector<PolypCandidate> & candidates)
{
  const auto                          labels = NewImageOn<itk::Image<unsigned short, 3>>(lumen, true);
  const auto &                        spacing = lumen->GetSpacing();
  const double                        step = 0.25 * std::min({ spacing[0], spacing[1], spacing[2] });
  const itk::ImageBase<3>::RegionType region = lumen->GetLargestPossibleRegion();
  const auto                          paint = [&](const Eigen::Vector3d & point, int number) {
    const auto index = lumen->TransformPhysicalPointToIndex(itk::Point<double, 3>(point.data()));
    if (region.IsInside(index) && lumen->GetPixel(index) == 0 && labels->GetPixel(index) == 0)
    {
      labels->SetPixel(index, static_cast<unsigned short>(number));
    }
  };
  for (const PolypCandidate & candidate : candidates)
  {
    const Eigen::Vector3d middle = MiddleOf(wall, candidate);
    for (const int vertex : candidate.vertices)
    {
      const Eigen::Vector3d way = middle - wall.V.row(vertex).transpose();
      const int             steps = static_cast<int>(std::ceil(way.norm() / step));
      for (int i = 0; i <= steps; ++i)
      {
        paint(middle - way * (static_cast<double>(i) / std::max(steps, 1)), candidate.number);
      }
    }
  }
  return labels;
}
} // namespace shapeton
