#include "shapetonColonAssessability.h"

#include "shapetonColonDistension.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double thickestFold = 5.0; // mm along the line; chosen, see the header
constexpr double leastPool = 150.0;  // mm^2; flat walls had up to 80, see the header
constexpr double nearLevel = 3.0;    // mm; chosen: allows for voxels and blur
constexpr double deepest = 120.0;    // mm from the line to a level; chosen: deeper than any pool
constexpr double besideGap = 15.0;   // mm along the line; the lumen tapers next to a gap

const char * const arrayName = "notAssessable";
const char * const lineName = "the centerline";

/** End index (exclusive) of the run of equal values that starts at `begin`. */
template <typename TValues>
std::size_t
EndOfRun(const TValues & values, std::size_t begin)
{
  std::size_t end = begin;
  while (end < values.size() && values[end] == values[begin])
  {
    ++end;
  }
  return end;
}

/** Start of the interval of a point: halfway to the previous point. */
double
BeginOf(const Eigen::VectorXd & arc, std::size_t point)
{
  const auto i = static_cast<Eigen::Index>(point);
  return i == 0 ? arc[0] : i == arc.size() ? arc[i - 1] : 0.5 * (arc[i - 1] + arc[i]);
}

/** Border between the stretches of a point and of the previous point, halfway between them. A stretch without lumen,
 * however, extends to the adjacent points, which are the ends of the lumen. */
double
BorderBefore(const Eigen::VectorXd & arc, const std::vector<ColonHindrance> & hindrances, std::size_t point)
{
  const auto i = static_cast<Eigen::Index>(point);
  const bool isInside = i > 0 && i < arc.size();
  return isInside && hindrances[point] == ColonHindrance::NoLumen       ? arc[i - 1]
         : isInside && hindrances[point - 1] == ColonHindrance::NoLumen ? arc[i]
                                                                        : BeginOf(arc, point);
}

std::vector<char>
NarrowPoints(const Eigen::VectorXd & arc, const Eigen::VectorXd & radius)
{
  const double      canal = EndOfAnalCanal(arc, radius);
  std::vector<char> isNarrow;
  for (Eigen::Index i = 0; i < radius.size(); ++i)
  {
    isNarrow.push_back(2.0 * radius[i] < LeastDistendedCaliber && arc[i] > canal);
  }
  for (std::size_t begin = 0, end = 0; begin < isNarrow.size(); begin = end)
  {
    end = EndOfRun(isNarrow, begin);
    if (isNarrow[begin] && BeginOf(arc, end) - BeginOf(arc, begin) < thickestFold)
    {
      std::fill(isNarrow.begin() + begin, isNarrow.begin() + end, 0);
    }
  }
  return isNarrow;
}

/** Classifies hindrances from gap and radius. */
std::vector<ColonHindrance>
HindrancesOfShape(const CurveSet & curve)
{
  const Eigen::VectorXd   gap = PointValues(curve, "gap", lineName);
  const std::vector<char> isNarrow =
    NarrowPoints(PointValues(curve, "arcLength", lineName), PointValues(curve, "radius", lineName));
  std::vector<ColonHindrance> hindrances;
  for (std::size_t i = 0; i < isNarrow.size(); ++i)
  {
    hindrances.push_back(gap[static_cast<Eigen::Index>(i)] != 0.0 ? ColonHindrance::NoLumen
                         : isNarrow[i] != 0                       ? ColonHindrance::Narrow
                                                                  : ColonHindrance::None);
  }
  return hindrances;
}

class LumenAround
{
public:
  explicit LumenAround(const ColonLumen & lumen) : m_Lumen(lumen) {}

  /** Whether the image border is no farther away than the wall, and the lumen reaches the border. */
  bool
  IsCutByScan(const Eigen::Vector3d & point, double radius) const
  {
    Labels::IndexType index;
    if (!this->Find(point, index))
    {
      return false;
    }
    const auto region = m_Lumen.labels->GetLargestPossibleRegion();
    const auto spacing = m_Lumen.labels->GetSpacing();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (const itk::IndexValueType border : { region.GetIndex(axis), region.GetUpperIndex()[axis] })
      {
        Labels::IndexType foot = index;
        foot[axis] = border;
        const double distance = std::abs(static_cast<double>(border - index[axis])) * spacing[axis];
        if (distance <= radius + spacing[axis] && m_Lumen.labels->GetPixel(foot) != 0)
        {
          return true;
        }
      }
    }
    return false;
  }

  /** Whether the lumen below the point ends at a large untagged level. */
  bool
  IsOverUntaggedFluid(const Eigen::Vector3d & point) const
  {
    return std::any_of(m_Lumen.levels.begin(), m_Lumen.levels.end(), [&](const ColonLevel & level) {
      return level.isColon && !level.isTagged && level.area >= leastPool && this->EndsAt(level, point);
    });
  }

private:
  using Labels = ColonLumen::LabelImageType;

  bool
  Find(const Eigen::Vector3d & point, Labels::IndexType & index) const
  {
    return m_Lumen.labels->TransformPhysicalPointToIndex(itk::Point<double, 3>(point.data()), index);
  }

  bool
  EndsAt(const ColonLevel & level, const Eigen::Vector3d & point) const
  {
    const Eigen::Vector3d down(m_Lumen.gravity.GetDataPointer());
    const Eigen::Vector3d way = Eigen::Vector3d(level.center.GetDataPointer()) - point;
    const double          depth = way.dot(down);
    const double          aside = (way - depth * down).norm();
    // A pool is at least as wide as a distended lumen.
    return depth >= 0.0 && depth <= deepest && aside <= level.area / LeastDistendedCaliber &&
           std::abs(this->DepthOfLumen(point, down) - depth) <= nearLevel;
  }

  double
  DepthOfLumen(const Eigen::Vector3d & point, const Eigen::Vector3d & down) const
  {
    constexpr double  step = 0.5; // mm; chosen finer than a voxel
    Labels::IndexType index;
    double            depth = 0.0;
    while (depth <= deepest + nearLevel && this->Find(point + depth * down, index) &&
           m_Lumen.labels->GetPixel(index) != 0)
    {
      depth += step;
    }
    return depth;
  }

  const ColonLumen & m_Lumen;
};
/** Finds gaps with cut lumen at both ends: there, the colon continues outside the scan. */
void
MarkGapsOutsideScan(const Eigen::VectorXd & arc, std::vector<ColonHindrance> & hindrances)
{
  const auto isCut = [&](std::size_t from, std::size_t to) {
    return std::any_of(hindrances.begin() + static_cast<std::ptrdiff_t>(from),
                       hindrances.begin() + static_cast<std::ptrdiff_t>(to),
                       [](ColonHindrance hindrance) { return hindrance == ColonHindrance::CutByScan; });
  };
  const auto indexAt = [&](double place) {
    return static_cast<std::size_t>(std::lower_bound(arc.begin(), arc.end(), place) - arc.begin());
  };
  for (std::size_t begin = 0, end = 0; begin < hindrances.size(); begin = end)
  {
    end = EndOfRun(hindrances, begin);
    if (hindrances[begin] == ColonHindrance::NoLumen && begin > 0 && end < hindrances.size() &&
        isCut(indexAt(arc[static_cast<Eigen::Index>(begin)] - besideGap), begin) &&
        isCut(end, indexAt(arc[static_cast<Eigen::Index>(end)] + besideGap)))
    {
      std::fill(hindrances.begin() + static_cast<std::ptrdiff_t>(begin),
                hindrances.begin() + static_cast<std::ptrdiff_t>(end),
                ColonHindrance::CutByScan);
    }
  }
}
} // namespace

std::string
NameOf(ColonHindrance hindrance)
{
  static const char * const names[] = { "none", "noLumen", "cutByScan", "untaggedFluid", "narrow" };
  return names[static_cast<int>(hindrance)];
}

ColonHindrance
HindranceOfName(const std::string & name)
{
  for (int i = 0; i < numberOfColonHindrances; ++i)
  {
    const auto hindrance = static_cast<ColonHindrance>(i);
    if (name == NameOf(hindrance) || (name.empty() && hindrance == ColonHindrance::None))
    {
      return hindrance;
    }
  }
  throw InputError('"' + name + "\" is not the name of a hindrance");
}

ColonHindrance
HindranceOfValue(double value)
{
  return static_cast<ColonHindrance>(std::clamp(static_cast<int>(value), 0, numberOfColonHindrances - 1));
}

std::string
InWords(ColonHindrance hindrance)
{
  static const char * const reasons[] = { "",
                                          "no gas or tagged fluid: collapsed, or filled with untagged matter",
                                          "cut by the border of the scan",
                                          "wall under untagged fluid",
                                          "caliber below 10 mm" };
  return reasons[static_cast<int>(hindrance)];
}

void
MarkHindrances(const ColonLumen & lumen, CurveSet & curve)
{
  std::vector<ColonHindrance> hindrances = HindrancesOfShape(curve);
  const Eigen::VectorXd       radius = PointValues(curve, "radius", lineName);
  const LumenAround           around(lumen);
  for (Eigen::Index i = 0; i < curve.V.rows(); ++i)
  {
    ColonHindrance & hindrance = hindrances[static_cast<std::size_t>(i)];
    if (hindrance != ColonHindrance::NoLumen)
    {
      const Eigen::Vector3d point = curve.V.row(i).transpose();
      hindrance = around.IsCutByScan(point, radius[i]) ? ColonHindrance::CutByScan
                  : around.IsOverUntaggedFluid(point)  ? ColonHindrance::UntaggedFluid
                                                       : hindrance;
    }
  }
  MarkGapsOutsideScan(PointValues(curve, "arcLength", lineName), hindrances);
  SurfaceArray array{ arrayName, SurfaceArray::ValueMatrix(curve.V.rows(), 1), true };
  for (Eigen::Index i = 0; i < curve.V.rows(); ++i)
  {
    array.values(i, 0) = static_cast<double>(hindrances[static_cast<std::size_t>(i)]);
  }
  curve.pointArrays.push_back(std::move(array));
}

bool
TellsHindrances(const CurveSet & curve)
{
  const auto has = [&](const char * name) { return FindSurfaceArray(curve.pointArrays, name) != nullptr; };
  return has("arcLength") && (has(arrayName) || (has("radius") && has("gap")));
}

std::vector<HinderedStretch>
FindHinderedStretches(const CurveSet & curve)
{
  std::vector<ColonHindrance> hindrances;
  if (FindSurfaceArray(curve.pointArrays, arrayName) == nullptr)
  {
    hindrances = HindrancesOfShape(curve);
  }
  else
  {
    for (const double value : PointValues(curve, arrayName, lineName))
    {
      hindrances.push_back(HindranceOfValue(value));
    }
  }
  const Eigen::VectorXd        arc = PointValues(curve, "arcLength", lineName);
  std::vector<HinderedStretch> stretches;
  for (std::size_t begin = 0, end = 0; begin < hindrances.size(); begin = end)
  {
    end = EndOfRun(hindrances, begin);
    if (hindrances[begin] != ColonHindrance::None)
    {
      stretches.push_back(
        { BorderBefore(arc, hindrances, begin), BorderBefore(arc, hindrances, end), hindrances[begin] });
    }
  }
  return stretches;
}

ColonHindrance
HindranceAt(const std::vector<HinderedStretch> & stretches, double arcLength)
{
  for (const HinderedStretch & stretch : stretches)
  {
    if (arcLength >= stretch.begin && arcLength <= stretch.end)
    {
      return stretch.hindrance;
    }
  }
  return ColonHindrance::None;
}

void
MarkHindrances(const std::vector<HinderedStretch> & stretches, CurveSet & curves)
{
  const Eigen::VectorXd arcLength = PointValues(curves, "arcLength", "the curves");
  SurfaceArray          array{ arrayName, SurfaceArray::ValueMatrix(arcLength.size(), 1), true };
  for (Eigen::Index i = 0; i < arcLength.size(); ++i)
  {
    array.values(i, 0) = static_cast<double>(HindranceAt(stretches, arcLength[i]));
  }
  curves.pointArrays.push_back(std::move(array));
}

std::string
ColonAssessability::Verdict() const
{
  // Shares of the length; chosen.
  constexpr double assessable = 0.9;
  constexpr double notAssessable = 0.5;
  return share >= assessable ? "assessable" : share < notAssessable ? "notAssessable" : "partly";
}

ColonAssessability
Assess(const std::vector<HinderedStretch> & stretches, double begin, double end)
{
  ColonAssessability result;
  double             hindered = 0.0;
  for (const HinderedStretch & stretch : stretches)
  {
    const double part = std::max(0.0, std::min(end, stretch.end) - std::max(begin, stretch.begin));
    result.lengths[static_cast<int>(stretch.hindrance)] += part;
    hindered += part;
  }
  result.share = end > begin ? std::clamp(1.0 - hindered / (end - begin), 0.0, 1.0) : 0.0;
  return result;
}

std::vector<ColonHindrance>
ColonAssessability::Hindrances() const
{
  std::vector<ColonHindrance> found;
  for (int i = 1; i < numberOfColonHindrances; ++i)
  {
    if (lengths[i] > 0.0)
    {
      found.push_back(static_cast<ColonHindrance>(i));
    }
  }
  const auto lengthOf = [this](ColonHindrance hindrance) { return lengths[static_cast<int>(hindrance)]; };
  std::stable_sort(
    found.begin(), found.end(), [&](ColonHindrance a, ColonHindrance b) { return lengthOf(a) > lengthOf(b); });
  return found;
}

Json
HindranceToJson(ColonHindrance hindrance)
{
  return { { "reason", NameOf(hindrance) }, { "words", InWords(hindrance) } };
}

Json
AssessabilityToJson(const ColonAssessability & assessability)
{
  Json json;
  json["assessableShare"] = RoundedJson(assessability.share);
  json["verdict"] = assessability.Verdict();
  json["reasons"] = Json::array();
  for (const ColonHindrance hindrance : assessability.Hindrances())
  {
    json["reasons"].push_back(HindranceToJson(hindrance));
    json["reasons"].back()["length"] = RoundedJson(assessability.lengths[static_cast<int>(hindrance)]);
  }
  return json;
}

Json
StretchesToJson(const std::vector<HinderedStretch> & stretches)
{
  Json list = Json::array();
  for (const HinderedStretch & stretch : stretches)
  {
    list.push_back({ { "begin", RoundedJson(stretch.begin) }, { "end", RoundedJson(stretch.end) } });
    list.back().update(HindranceToJson(stretch.hindrance));
  }
  return list;
}
} // namespace shapeton
