#include "itkCentrelineAssembly.h"

#include "itkPlaceInWords.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
/** Narrower places (radius, mm) are told. */
constexpr double narrow = 2.5;
/** The middle of the lumen is taken over so many mm of it to both sides, so that single haustra do not bend the line.
 */
constexpr double slabRadii = 2.5;
/** Chord over arc of that stretch, at least. */
constexpr double straightness = 0.6;

/** Share of lumen (DistanceField::Occupancy) that the line keeps, and below which it is outside. */
constexpr double safelyInside = 0.7;
constexpr double leastInside = 0.55;
/** The line ends so far from the pole of the caecum, mm. */
constexpr double beforePole = 3.0;

/** A stretch of the curve, in the frame of the grid. */
struct Section
{
  CurvePoints         points;
  std::vector<double> radii;
  /** What the curve comes from. */
  std::vector<int> nodes;
  bool             isGap{ false };
  /** Index into the order of pieces; of the piece before a gap. */
  int piece{ 0 };
};

Point<double, 3>
ToPoint(const LumenGrid & grid, const Eigen::Vector3d & position)
{
  const Eigen::Vector3d at = grid.ToPhysical(position);
  Point<double, 3>      point;
  for (int a = 0; a < 3; ++a)
  {
    point[a] = at[a];
  }
  return point;
}

CurvePoints
PositionsOf(const LumenGrid & grid, const std::vector<int> & nodes)
{
  CurvePoints points;
  for (const int node : nodes)
  {
    points.push_back(grid.Position(node));
  }
  return points;
}

/** Of each node the nearest point of a curve within the lumen. */
std::vector<int>
NearestPoints(const LumenNetwork & network, const CurvePoints & points)
{
  std::vector<int> path;
  for (const Eigen::Vector3d & point : points)
  {
    path.push_back(network.grid.NodeOf(point));
  }
  return NearestOnPath(network.grid, network.cells, network.tree, path);
}

/** The lumen across each point of a curve. */
struct Slabs
{
  /** Weighted sums of positions. */
  CurvePoints         sums;
  std::vector<double> weights;
};

/** Nodes count by their distance to the wall, so that haustra weigh little. */
Slabs
SlabsAcross(const LumenNetwork & network, const CurvePoints & points)
{
  const LumenGrid &      grid = network.grid;
  const std::vector<int> nearest = NearestPoints(network, points);
  Slabs                  slabs;
  slabs.sums.assign(points.size(), Eigen::Vector3d::Zero());
  slabs.weights.assign(points.size(), 0.0);
  for (int node = 0; node < grid.NumberOfNodes(); ++node)
  {
    if (nearest[node] >= 0)
    {
      slabs.sums[nearest[node]] += grid.Distance(node) * grid.Position(node);
      slabs.weights[nearest[node]] += grid.Distance(node);
    }
  }
  return slabs;
}

/** The mean of numbers over so many neighbours to both sides. */
double
MeanAround(const std::vector<double> & values, int i, int number)
{
  const int from = std::max(0, i - number);
  const int to = std::min(static_cast<int>(values.size()) - 1, i + number);
  double    sum = 0.0;
  for (int k = from; k <= to; ++k)
  {
    sum += values[k];
  }
  return sum / (to - from + 1);
}

/** The mean of the slabs around each point, over a stretch of some radii of the lumen; both ends stay. */
CurvePoints
SlabMeans(const Slabs & slabs, const CurvePoints & points, const std::vector<double> & radii, double step)
{
  const int   last = static_cast<int>(points.size()) - 1;
  CurvePoints means = points;
  for (int i = 1; i < last; ++i)
  {
    // As far on both sides, or the end would pull.
    const double reach = slabRadii * MeanAround(radii, i, static_cast<int>(20.0 / step));
    int          number = std::min({ static_cast<int>(reach / step), i, last - i });
    // Less in a sharp bend, which the mean would cut.
    while (number > 1 && (points[i + number] - points[i - number]).norm() < straightness * 2.0 * number * step)
    {
      --number;
    }
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double          weight = 0.0;
    for (int k = i - number; k <= i + number; ++k)
    {
      const double share = 1.0 - std::abs(k - i) / (number + 1.0);
      sum += share * slabs.sums[k];
      weight += share * slabs.weights[k];
    }
    means[i] = weight > 0.0 ? Eigen::Vector3d(sum / weight) : points[i];
  }
  return means;
}

/** Each point moved to the middle of the lumen across the curve, both ends kept. The mean goes over a stretch, so that
 * single haustra do not bend the line. */
CurvePoints
MoveToMiddle(const LumenNetwork & network, const DistanceField & field, const CurvePoints & points, double step)
{
  std::vector<double> radii;
  for (const Eigen::Vector3d & point : points)
  {
    radii.push_back(field.At(point));
  }
  const CurvePoints middle = SlabMeans(SlabsAcross(network, points), points, radii, step);
  CurvePoints       moved = points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    // The mean of a bent slab may lie in a wall: back towards the path, as far as needed.
    const double least = std::min(narrow, 0.5 * radii[i]);
    for (double share = 1.0; share > 0.0; share -= 0.125)
    {
      const Eigen::Vector3d place = points[i] + share * (middle[i] - points[i]);
      if (field.At(place) >= least)
      {
        moved[i] = place;
        break;
      }
    }
  }
  return moved;
}

/** At each point the radius of the largest ball inside the lumen whose centre lies across the curve within 2 mm. */
std::vector<double>
RadiiAlong(const LumenNetwork & network, const DistanceField & field, const CurvePoints & points, double step)
{
  const std::vector<int> nearest = NearestPoints(network, points);
  std::vector<double>    widest;
  for (const Eigen::Vector3d & point : points)
  {
    widest.push_back(field.At(point));
  }
  for (int node = 0; node < network.grid.NumberOfNodes(); ++node)
  {
    if (nearest[node] >= 0)
    {
      widest[nearest[node]] = std::max<double>(widest[nearest[node]], network.grid.Distance(node));
    }
  }
  const int           reach = static_cast<int>(2.0 / step);
  std::vector<double> radii;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
  {
    const int from = std::max(0, i - reach);
    const int to = std::min(static_cast<int>(points.size()) - 1, i + reach);
    radii.push_back(*std::max_element(widest.begin() + from, widest.begin() + to + 1));
  }
  return radii;
}

/** The direction at the end of a curve, over its last 10 mm. */
Eigen::Vector3d
EndDirection(const CurvePoints & points, bool atBegin)
{
  const std::size_t     reach = std::min<std::size_t>(points.size() - 1, 10);
  const auto &          tip = atBegin ? points.front() : points.back();
  const auto &          inner = atBegin ? points[reach] : points[points.size() - 1 - reach];
  const Eigen::Vector3d direction = atBegin ? inner - tip : tip - inner;
  return direction.norm() > 0.0 ? Eigen::Vector3d(direction.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

std::size_t
NearestIndex(const CurvePoints & nodes, const Eigen::Vector3d & point)
{
  const auto nearest =
    std::min_element(nodes.begin(), nodes.end(), [&point](const Eigen::Vector3d & a, const Eigen::Vector3d & b) {
      return (a - point).squaredNorm() < (b - point).squaredNorm();
    });
  return nearest - nodes.begin();
}

/** Stretches outside the lumen become those of the path again, which may wind more than the line. */
void
KeepInside(const DistanceField & field, const CurvePoints & nodes, CurvePoints & points)
{
  const auto isBad = [&](std::size_t i) {
    const Eigen::Vector3d halfway = 0.5 * (points[i] + points[std::min(i + 1, points.size() - 1)]);
    return std::min(field.Occupancy(points[i]), field.Occupancy(halfway)) < safelyInside;
  };
  CurvePoints kept;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!isBad(i) || i == 0)
    {
      kept.push_back(points[i]);
      continue;
    }
    const std::size_t from = NearestIndex(nodes, points[i - 1]);
    while (i + 1 < points.size() && isBad(i))
    {
      ++i;
    }
    const std::size_t to = NearestIndex(nodes, points[i]);
    if (from < to)
    {
      kept.insert(kept.end(), nodes.begin() + from + 1, nodes.begin() + to);
    }
    kept.push_back(points[i]);
  }
  points = kept;
}

/** A smooth curve in the middle of the lumen from a path of nodes. */
CurvePoints
ShapeLine(const LumenNetwork &           network,
          const DistanceField &          field,
          const std::vector<int> &       nodes,
          const ColonCentrelineOptions & options)
{
  const auto smooth = [&](const CurvePoints & points) {
    return ResampleCurve(SmoothCurve(ResampleCurve(points, options.step), options.step, options.smoothing, &field),
                         options.step);
  };
  const CurvePoints path = smooth(PositionsOf(network.grid, nodes));
  CurvePoints       points = smooth(MoveToMiddle(network, field, path, options.step));
  KeepInside(field, PositionsOf(network.grid, nodes), points);
  return ResampleCurve(points, options.step);
}

bool
IsVisible(const DistanceField & field, const Eigen::Vector3d & from, const Eigen::Vector3d & to)
{
  const int steps = static_cast<int>((to - from).norm()) + 1;
  for (int i = 1; i < steps; ++i)
  {
    if (field.At(from + (to - from) * i / steps) < 1.0)
    {
      return false;
    }
  }
  return true;
}

/** The place before the wall that lies farthest along a direction and near the axis. */
Eigen::Vector3d
FindPole(const LumenNetwork &    network,
         const DistanceField &   field,
         const Eigen::Vector3d & base,
         const Eigen::Vector3d & along,
         double                  reach)
{
  Eigen::Vector3d pole = base;
  double          most = 0.0;
  for (int node = 0; node < network.grid.NumberOfNodes(); ++node)
  {
    const Eigen::Vector3d way = network.grid.Position(node) - base;
    const double          forward = way.dot(along);
    const double          score = forward - 0.5 * (way - forward * along).norm();
    if (score > most && way.norm() <= reach && network.grid.Distance(node) >= beforePole &&
        IsVisible(field, base, base + way))
    {
      most = score;
      pole = base + way;
    }
  }
  return pole;
}

/** Leads the end of a curve on to the pole of a wide end: the last node of its path lies on the side of the pole as
 * well as at it. */
void
LeadToPole(const LumenNetwork & network, const DistanceField & field, double step, CurvePoints & points)
{
  const auto   count = static_cast<int>(points.size());
  const double radius = field.At(points[std::max(0, count - 1 - static_cast<int>(25.0 / step))]);
  const int    base = count - 1 - static_cast<int>(radius / step);
  const int    before = base - static_cast<int>(20.0 / step);
  if (before < 0 || base == count - 1)
  {
    return;
  }
  const Eigen::Vector3d along = (points[base] - points[before]).normalized();
  const double          reach = 2.5 * std::max(radius, field.At(points[base]));
  const Eigen::Vector3d pole = FindPole(network, field, points[base], along, reach);
  const double          rest = (pole - points[base]).norm();
  if (rest < step)
  {
    return;
  }
  points.resize(base + 1);
  const CurvePoints last = BridgeGap(points[base], along, pole, (pole - points[base]) / rest, step);
  points.insert(points.end(), last.begin(), last.end());
  points.push_back(pole);
}

/** Ends a curve where all of it is safely inside over 10 mm: a path goes on into what is only half a voxel wide. */
void
TrimEnds(const DistanceField & field, double step, CurvePoints & points)
{
  for (int e = 0; e < 2; ++e)
  {
    std::reverse(points.begin(), points.end());
    const std::size_t reach = std::min(points.size() / 3, static_cast<std::size_t>(10.0 / step));
    std::size_t       keep = 0;
    for (std::size_t i = 0; i < reach + keep && i + 2 < points.size() - reach; ++i)
    {
      const double halfway = field.Occupancy(0.5 * (points[i] + points[i + 1]));
      keep = std::min(field.Occupancy(points[i]), halfway) < safelyInside ? i + 1 : keep;
    }
    points.erase(points.begin(), points.begin() + keep);
  }
}

/** Of each point of a section whether it or the way to the next one lies outside the lumen. */
std::vector<char>
FindOutside(const DistanceField & field, const CurvePoints & points)
{
  std::vector<char> isOutside(points.size(), 0);
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    const double halfway = field.Occupancy(0.5 * (points[i] + points[i + 1]));
    isOutside[i] = std::min(field.Occupancy(points[i]), halfway) < leastInside;
  }
  return isOutside;
}

/** A section as itself where all of it lies inside the lumen; else cut where it leaves the lumen, with gaps between. */
void
AddInside(const DistanceField & field, const Section & section, std::vector<Section> & sections)
{
  const std::vector<char> isOutside = FindOutside(field, section.points);
  for (std::size_t begin = 0; begin < section.points.size();)
  {
    std::size_t end = begin;
    while (end < section.points.size() && isOutside[end] == isOutside[begin])
    {
      ++end;
    }
    Section part;
    part.points.assign(section.points.begin() + begin, section.points.begin() + end);
    part.radii.assign(section.radii.begin() + begin, section.radii.begin() + end);
    part.isGap = isOutside[begin] != 0;
    part.piece = section.piece;
    if (begin == 0)
    {
      part.nodes = section.nodes;
    }
    sections.push_back(part);
    begin = end;
  }
}

std::vector<Section>
MakeSections(const LumenNetwork &             network,
             const DistanceField &            field,
             const std::vector<PieceLine> &   lines,
             const std::vector<PlacedPiece> & order,
             const ColonCentrelineOptions &   options)
{
  std::vector<Section> sections;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    // The last end is the caecum, whose pole is wide: what is narrow there is the ileum or the appendix.
    const bool isLast = i + 1 == order.size();
    Section    section;
    section.nodes = lines[order[i].piece].Nodes(true, !isLast);
    section.points = ShapeLine(network, field, section.nodes, options);
    if (isLast)
    {
      LeadToPole(network, field, options.step, section.points);
    }
    TrimEnds(field, options.step, section.points);
    section.radii = RadiiAlong(network, field, section.points, options.step);
    section.piece = static_cast<int>(i);
    if (i > 0)
    {
      const CurvePoints & before = sections.back().points;
      Section             gap;
      gap.isGap = true;
      gap.piece = static_cast<int>(i) - 1;
      gap.points = BridgeGap(before.back(),
                             EndDirection(before, false),
                             section.points.front(),
                             EndDirection(section.points, true),
                             options.step);
      gap.radii.assign(gap.points.size(), options.gapRadius);
      sections.push_back(gap);
    }
    AddInside(field, section, sections);
  }
  return sections;
}

SurfaceArray
MakeArray(const std::string & name, const std::vector<double> & values, int columns = 1, bool areIntegers = false)
{
  SurfaceArray array;
  array.name = name;
  array.areIntegers = areIntegers;
  array.values.resize(static_cast<Eigen::Index>(values.size()) / columns, columns);
  std::copy(values.begin(), values.end(), array.values.data());
  return array;
}

/** The curve with its arrays; sets begin and end of each section by the arcLength. */
void
FillCurve(const LumenGrid &            grid,
          const std::vector<Section> & sections,
          std::vector<double> &        begins,
          ColonCentreline &            result)
{
  std::vector<double> arcs, radii, gaps;
  CurvePoints         points;
  for (const Section & section : sections)
  {
    radii.insert(radii.end(), section.radii.begin(), section.radii.end());
    for (const Eigen::Vector3d & point : section.points)
    {
      arcs.push_back(points.empty() ? 0.0 : arcs.back() + (point - points.back()).norm());
      gaps.push_back(section.isGap ? 1.0 : 0.0);
      if (&point == &section.points.front())
      {
        begins.push_back(arcs.back());
      }
      points.push_back(point);
    }
    if (section.points.empty())
    {
      begins.push_back(arcs.empty() ? 0.0 : arcs.back());
    }
  }
  CurveSet & curve = result.curve;
  curve.V.resize(static_cast<Eigen::Index>(points.size()), 3);
  curve.curves.assign(1, std::vector<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    curve.V.row(i) = grid.ToPhysical(points[i]).transpose();
    curve.curves[0][i] = static_cast<int>(i);
  }
  result.length = arcs.back();
  begins.push_back(result.length);
  curve.pointArrays = { MakeArray("arcLength", arcs), MakeArray("radius", radii), MakeArray("gap", gaps, 1, true) };
}

void
AddPieces(const LumenGrid &                grid,
          const std::vector<PieceLine> &   lines,
          const std::vector<PlacedPiece> & order,
          const std::vector<Section> &     sections,
          const std::vector<double> &      begins,
          ColonCentreline &                result)
{
  for (std::size_t s = 0; s < sections.size(); ++s)
  {
    const double end = begins[s] + CurveLength(sections[s].points);
    if (sections[s].isGap)
    {
      continue;
    }
    if (static_cast<int>(result.pieces.size()) > sections[s].piece)
    {
      result.pieces.back().end = end;
      continue;
    }
    const PieceLine & line = lines[order[sections[s].piece].piece];
    CentrelinePiece   piece;
    piece.component = line.component;
    piece.volume = 1e-3 * line.volume;
    piece.isUsed = true;
    piece.begin = begins[s];
    piece.end = end;
    piece.place = ToPoint(grid, sections[s].points[sections[s].points.size() / 2]);
    result.pieces.push_back(piece);
  }
}

void
AddGaps(const LumenGrid &            grid,
        const std::vector<Section> & sections,
        const std::vector<double> &  begins,
        ColonCentreline &            result)
{
  for (std::size_t s = 0; s < sections.size(); ++s)
  {
    if (!sections[s].isGap)
    {
      continue;
    }
    const Eigen::Vector3d & from = sections[s - 1].points.back();
    const Eigen::Vector3d & to = sections[s + 1].points.front();
    const double            before =
      s == 0 ? 0.0 : begins[s] - (sections[s].points.empty() ? 0.0 : (sections[s].points.front() - from).norm());
    CentrelineGap gap;
    gap.begin = before;
    gap.end = begins[s + 1];
    gap.from = ToPoint(grid, from);
    gap.to = ToPoint(grid, to);
    gap.distance = (to - from).norm();
    gap.isDoubtful = gap.distance > longestJoin;
    result.gaps.push_back(gap);
    result.warnings.push_back("no lumen over " + InTenths(gap.distance) + " mm from " + PlaceInWords(gap.from) +
                              " to " + PlaceInWords(gap.to) + ": the centreline is bridged there" +
                              (gap.isDoubtful ? "; so long a gap puts the order of the pieces in doubt" : ""));
  }
}

/** Tells stretches inside the lumen that are hardly open. */
void
WarnOfNarrowPlaces(const LumenGrid & grid, const std::vector<Section> & sections, ColonCentreline & result)
{
  for (const Section & section : sections)
  {
    const std::vector<int> & nodes = section.nodes;
    // Near the ends of a piece the lumen tapers.
    const std::size_t margin = 15;
    for (std::size_t i = margin; i + margin < nodes.size(); ++i)
    {
      std::size_t narrowest = i;
      std::size_t end = i;
      while (end + margin < nodes.size() && grid.Distance(nodes[end]) < narrow)
      {
        narrowest = grid.Distance(nodes[end]) < grid.Distance(nodes[narrowest]) ? end : narrowest;
        ++end;
      }
      if (end > i)
      {
        result.warnings.push_back("the lumen is only " + InTenths(2.0 * grid.Distance(nodes[narrowest])) +
                                  " mm wide at " + PlaceInWords(ToPoint(grid, grid.Position(nodes[narrowest]))) +
                                  ": a collapsed place, or two loops have merged");
        i = end;
      }
    }
  }
}

/** Lengths for the exponents 2, 3, 4: the line itself, changed by how much the other paths differ from its core. */
void
AddLengths(const LumenNetwork &             network,
           const DistanceField &            field,
           const std::vector<PieceLine> &   lines,
           const std::vector<PlacedPiece> & order,
           const ColonCentrelineOptions &   options,
           ColonCentreline &                result)
{
  const auto lengthOf = [&](const std::vector<int> & nodes) {
    return CurveLength(ShapeLine(network, field, nodes, options));
  };
  result.lengths.fill(result.length);
  for (const PlacedPiece & placed : order)
  {
    const PieceLine & line = lines[placed.piece];
    const double      core = lengthOf(line.core);
    result.lengths[0] += lengthOf(OtherPath(network, line, 2)) - core;
    result.lengths[2] += lengthOf(OtherPath(network, line, 4)) - core;
  }
  const auto [least, most] = std::minmax_element(result.lengths.begin(), result.lengths.end());
  if (*most - *least > 0.03 * result.length)
  {
    result.warnings.push_back("the length of the centreline depends on the cost of paths, " +
                              InTenths(result.lengths[0]) + ", " + InTenths(result.lengths[1]) + " and " +
                              InTenths(result.lengths[2]) + " mm for the exponents 2, 3 and 4: loops may have merged");
  }
}

void
AddCover(const LumenNetwork &             network,
         const std::vector<PieceLine> &   lines,
         const std::vector<PlacedPiece> & order,
         ColonCentreline &                result)
{
  double whole = 0.0;
  double covered = 0.0;
  for (const PlacedPiece & placed : order)
  {
    const PieceLine & line = lines[placed.piece];
    whole += line.volume;
    covered += line.coveredVolume;
    if (line.branchVolume > std::max(20e3, 0.02 * line.volume))
    {
      const auto place = ToPoint(network.grid, network.grid.Position(line.branchPlace));
      result.warnings.push_back("a side branch of " + InTenths(1e-3 * line.branchVolume) + " ml hangs on the line at " +
                                PlaceInWords(place) + ": other bowel, or a loop that the line leaves out");
    }
  }
  result.coverage = whole > 0.0 ? covered / whole : 0.0;
}
} // namespace

ColonCentreline
AssembleCentreline(const LumenNetwork &             network,
                   const DistanceField &            field,
                   const std::vector<PieceLine> &   lines,
                   const std::vector<PlacedPiece> & order,
                   const ColonCentrelineOptions &   options)
{
  ColonCentreline            result;
  const std::vector<Section> sections = MakeSections(network, field, lines, order, options);
  std::vector<double>        begins;
  FillCurve(network.grid, sections, begins, result);
  AddPieces(network.grid, lines, order, sections, begins, result);
  AddGaps(network.grid, sections, begins, result);
  AddLengths(network, field, lines, order, options, result);
  AddCover(network, lines, order, result);
  WarnOfNarrowPlaces(network.grid, sections, result);
  return result;
}

void
AddUnusedLines(const LumenNetwork &             network,
               const std::vector<PieceLine> &   lines,
               const std::vector<PlacedPiece> & order,
               ColonCentreline &                result)
{
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const auto isIt = [i](const PlacedPiece & placed) { return placed.piece == static_cast<int>(i); };
    if (std::any_of(order.begin(), order.end(), isIt))
    {
      continue;
    }
    CentrelinePiece piece;
    piece.component = lines[i].component;
    piece.volume = 1e-3 * lines[i].volume;
    piece.place = ToPoint(network.grid, network.grid.Position(lines[i].core[lines[i].core.size() / 2]));
    piece.reason = "it lies too far from the ends of the other pieces";
    result.pieces.push_back(piece);
    result.warnings.push_back("a piece of lumen of " + InTenths(piece.volume) + " ml at " + PlaceInWords(piece.place) +
                              " is not used: " + piece.reason);
  }
}

void
AddUnusedComponents(const LumenMask *       lumen,
                    const LumenComponents & components,
                    const LumenChoice &     choice,
                    ColonCentreline &       result)
{
  for (std::size_t c = 1; c <= components.components.size(); ++c)
  {
    if (choice.isUsed[c])
    {
      continue;
    }
    CentrelinePiece piece;
    piece.component = static_cast<int>(c);
    piece.volume = components.components[c - 1].volume;
    piece.place = PlaceOf(lumen, components.components[c - 1]);
    piece.reason = choice.reasons[c];
    result.pieces.push_back(piece);
    if (piece.volume >= 1.0)
    {
      result.warnings.push_back("a piece of lumen of " + InTenths(piece.volume) + " ml at " +
                                PlaceInWords(piece.place) + " is not used: " + piece.reason);
    }
  }
}

void
AddMerges(const LumenNetwork & network, ColonCentreline & result)
{
  constexpr double onePlace = 30.0;
  for (const CellTree::Merge & found : network.tree.Merges())
  {
    const CellPassage & passage = network.cells.passages[found.passage];
    CentrelineMerge     merge;
    merge.place = ToPoint(network.grid, network.grid.Position(passage.node));
    merge.clearance = passage.clearance;
    merge.loop = found.loop;
    const bool isKnown = std::any_of(result.merges.begin(), result.merges.end(), [&](const CentrelineMerge & m) {
      return m.place.EuclideanDistanceTo(merge.place) < onePlace;
    });
    if (!isKnown)
    {
      result.merges.push_back(merge);
      const std::string loop = merge.loop > 0.0 ? " that would cut off " + InTenths(merge.loop) + " mm" : "";
      result.warnings.push_back("loops of the colon touch at " + PlaceInWords(merge.place) + " through a hole of " +
                                InTenths(2.0 * merge.clearance) + " mm" + loop + ": the centreline does not pass it");
    }
  }
  std::vector<double> gaps, merges;
  for (const CentrelineGap & gap : result.gaps)
  {
    gaps.insert(gaps.end(), { gap.begin, gap.end });
  }
  for (const CentrelineMerge & m : result.merges)
  {
    merges.insert(merges.end(), { m.place[0], m.place[1], m.place[2], m.clearance, m.loop });
  }
  result.curve.fieldArrays = { MakeArray("lengths", { result.lengths.begin(), result.lengths.end() }) };
  if (!gaps.empty())
  {
    result.curve.fieldArrays.push_back(MakeArray("gaps", gaps, 2));
  }
  if (!merges.empty())
  {
    result.curve.fieldArrays.push_back(MakeArray("merges", merges, 5));
  }
}
} // namespace itk
