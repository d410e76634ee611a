#include "shapetonCenterlineAssembly.h"

#include "shapetonMiddleLine.h"
#include "shapetonParallelFor.h"
#include "shapetonPlaceInWords.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Radius (mm) below which narrow lumen is reported. */
constexpr double narrow = 2.5;
/** DistanceField::Occupancy below which the line is outside the lumen. */
constexpr double leastInside = 0.55;

/** Side branches larger than this volume (mm^3) are reported. */
constexpr double largeBranch = 20e3;
/** Lumen within a distance of besideLine (mm) plus besideRadii radii from the line belongs to the line, not to a side
 * branch. The sensitivity was not measured. */
constexpr double besideLine = 10.0;
constexpr double besideRadii = 2.0;
/** Spread of the lengths for the exponents 2, 3 and 4, as a fraction of the length. Above it, loops have probably
 * merged: a path through a hole between loops depends on the cost, a path along the lumen does not. Chosen on a real
 * prone exam.
 */
constexpr double unsureLength = 0.03;
/** Values of a merge in the field array: x, y, z, clearance, loop. */
constexpr int valuesOfMerge = 5;

/** A section of the curve in grid coordinates. */
struct Section
{
  CurvePoints         points;
  std::vector<double> radii;
  /** Nodes of the original path. */
  std::vector<int> nodes;
  bool             isGap{ false };
  /** Index into the order of pieces; for a gap, index of the preceding piece. */
  int piece{ 0 };
};

itk::Point<double, 3>
ToPoint(const LumenGrid & grid, const Eigen::Vector3d & position)
{
  const Eigen::Vector3d at = grid.ToPhysical(position);
  itk::Point<double, 3> point;
  for (int a = 0; a < 3; ++a)
  {
    point[a] = at[a];
  }
  return point;
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

/** Whether each point of a section, or the segment to the next point, is outside the lumen. */
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

/** Splits a section where it leaves the lumen; the parts outside become gaps. */
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
             const ColonCenterlineOptions &   options)
{
  std::vector<Section> sections;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    // The line ends at the wide pole of the cecum; narrow lumen there is the ileum or the appendix.
    const bool isLast = i + 1 == order.size();
    Section    section;
    section.nodes = lines[order[i].piece].Nodes(true, !isLast);
    section.points = ShapeLine(network, field, section.nodes, options);
    if (isLast)
    {
      LeadToPole(network, field, options, section.points);
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

/** Builds the curve and its arrays; sets begin and end (arcLength) of each section. */
void
FillCurve(const LumenGrid &            grid,
          const std::vector<Section> & sections,
          std::vector<double> &        begins,
          ColonCenterline &            result)
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
          ColonCenterline &                result)
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
    CenterlinePiece   piece;
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
        ColonCenterline &            result)
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
    CenterlineGap gap;
    gap.begin = before;
    gap.end = begins[s + 1];
    gap.from = ToPoint(grid, from);
    gap.to = ToPoint(grid, to);
    gap.distance = (to - from).norm();
    gap.isDoubtful = gap.distance > longestJoin;
    result.gaps.push_back(gap);
    result.warnings.push_back("no lumen from " + PlaceInWords(gap.from) + " to " + PlaceInWords(gap.to) +
                              ": the centerline is bridged there" +
                              (gap.isDoubtful ? "; the order of the pieces is uncertain for such a long gap" : ""));
  }
}

/** Reports very narrow lumen. */
void
WarnOfNarrowPlaces(const LumenGrid & grid, const std::vector<Section> & sections, ColonCenterline & result)
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
                                  ": the colon is collapsed there, or two loops have merged");
        i = end;
      }
    }
  }
}

/** Warns if the line does not begin near the posterior midline, where the anus is expected. */
void
WarnOfUnlikelyRectum(ColonCenterline & result)
{
  // Bounds as fractions of the extent of the line. In LPS, y increases toward the back. The rectum is within 0.07 of
  // the middle in 131 phantoms and a real colon; a wrong line began 0.24 from it.
  constexpr double fromMiddle = 0.2;
  constexpr double leastBack = 0.3;
  ColonExtent      extent;
  for (Eigen::Index i = 0; i < result.curve.V.rows(); ++i)
  {
    extent.Include(result.curve.V.row(i));
  }
  const itk::Point<double, 3> place(Eigen::Vector3d(result.curve.V.row(0)).data());
  if (std::abs(extent.ShareAlong(0, place) - 0.5) > fromMiddle || extent.ShareAlong(1, place) < leastBack)
  {
    result.warnings.push_back("the line begins at " + PlaceInWords(place) +
                              ", which is unlikely for the anus: it may be reversed, or "
                              "the rectum is missing");
  }
}

/** Expensive intermediate results. */
struct ShapedLines
{
  std::vector<Section> sections;
  /** Lengths (mm) of the line through each piece for exponent 2, the exponent in the options, and exponent 4. */
  std::vector<std::array<double, 3>> lengths;
};

ShapedLines
ShapeLines(const LumenNetwork &             network,
           const DistanceField &            field,
           const std::vector<PieceLine> &   lines,
           const std::vector<PlacedPiece> & order,
           const ColonCenterlineOptions &   options)
{
  ShapedLines shaped;
  shaped.lengths.resize(order.size());
  ParallelFor(1 + 3 * order.size(), [&](std::size_t task) {
    if (task == 0)
    {
      shaped.sections = MakeSections(network, field, lines, order, options);
      return;
    }
    const std::size_t      i = (task - 1) / 3;
    const int              exponent = 2 + static_cast<int>((task - 1) % 3);
    const PieceLine &      line = lines[order[i].piece];
    const std::vector<int> path = exponent == 3 ? line.core : OtherPath(network, line, exponent);
    shaped.lengths[i][exponent - 2] = CurveLength(ShapeLine(network, field, path, options));
  });
  return shaped;
}

/** Lengths for the exponents 2, 3 and 4, from the length of the line and the differences between the paths. */
void
AddLengths(const std::vector<std::array<double, 3>> & ofPieces, ColonCenterline & result)
{
  result.lengths.fill(result.length);
  for (const auto & lengths : ofPieces)
  {
    result.lengths[0] += lengths[0] - lengths[1];
    result.lengths[2] += lengths[2] - lengths[1];
  }
  const auto [least, most] = std::minmax_element(result.lengths.begin(), result.lengths.end());
  if (*most - *least > unsureLength * result.length)
  {
    result.warnings.push_back("the length of the centerline depends on the path cost: " + InTenths(result.lengths[0]) +
                              ", " + InTenths(result.lengths[1]) + " and " + InTenths(result.lengths[2]) +
                              " mm for the exponents 2, 3 and 4: loops may have merged");
  }
}

/** Lumen connected to the line but far from it. */
struct SideBranch
{
  int    place;  ///< index of the line point to which most of it is connected
  double volume; ///< mm^3
};

/** Finds branches: lumen far from the line that is connected to consecutive line points. `away` is the volume (mm^3) of
 * far lumen for each line point. */
std::vector<SideBranch>
SideBranches(const std::vector<double> & away)
{
  std::vector<SideBranch> branches;
  for (int i = 0; i < static_cast<int>(away.size()); ++i)
  {
    if (away[i] == 0.0)
    {
      continue;
    }
    if (i == 0 || away[i - 1] == 0.0)
    {
      branches.push_back({ i, 0.0 });
    }
    branches.back().volume += away[i];
    branches.back().place = away[i] > away[branches.back().place] ? i : branches.back().place;
  }
  return branches;
}

/** Finds side branches: lumen whose distance to the line, measured within the lumen, exceeds the limit for the
 * caliber. */
void
AddCover(const LumenNetwork & network, const std::vector<Section> & sections, ColonCenterline & result)
{
  std::vector<int>    path; // a node for each point of the line, -1 outside the lumen
  std::vector<double> reach;
  for (const Section & section : sections)
  {
    for (std::size_t i = 0; i < section.points.size(); ++i)
    {
      path.push_back(section.isGap ? -1 : network.grid.NodeOf(section.points[i]));
      reach.push_back(besideLine + besideRadii * section.radii[i]);
    }
  }
  const NearestPlaces nearest = NearestOnPath(network.grid, network.cells, network.tree, path);
  std::vector<double> away(path.size(), 0.0);
  double              whole = 0.0;
  double              uncovered = 0.0;
  for (int node = 0; node < network.grid.NumberOfNodes(); ++node)
  {
    const int i = nearest.indices[node];
    if (i >= 0)
    {
      whole += network.grid.NodeVolume();
      if (nearest.distances[node] > reach[i])
      {
        uncovered += network.grid.NodeVolume();
        away[i] += network.grid.NodeVolume();
      }
    }
  }
  result.coverage = whole > 0.0 ? 1.0 - uncovered / whole : 0.0;
  for (const SideBranch & branch : SideBranches(away))
  {
    if (branch.volume > largeBranch)
    {
      const auto place = ToPoint(network.grid, network.grid.Position(path[branch.place]));
      result.warnings.push_back("a side branch of " + InTenths(1e-3 * branch.volume) + " ml starts at " +
                                PlaceInWords(place) + ": other bowel, or a loop missed by the line");
    }
  }
}
} // namespace

ColonCenterline
AssembleCenterline(const LumenNetwork &             network,
                   const DistanceField &            field,
                   const std::vector<PieceLine> &   lines,
                   const std::vector<PlacedPiece> & order,
                   const ColonCenterlineOptions &   options)
{
  ColonCenterline              result;
  const ShapedLines            shaped = ShapeLines(network, field, lines, order, options);
  const std::vector<Section> & sections = shaped.sections;
  std::vector<double>          begins;
  FillCurve(network.grid, sections, begins, result);
  AddPieces(network.grid, lines, order, sections, begins, result);
  AddGaps(network.grid, sections, begins, result);
  AddLengths(shaped.lengths, result);
  AddCover(network, sections, result);
  WarnOfNarrowPlaces(network.grid, sections, result);
  if (!options.start)
  {
    WarnOfUnlikelyRectum(result);
  }
  return result;
}

void
AddUnusedLines(const LumenNetwork &             network,
               const std::vector<PieceLine> &   lines,
               const std::vector<PlacedPiece> & order,
               ColonCenterline &                result)
{
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const auto isIt = [i](const PlacedPiece & placed) { return placed.piece == static_cast<int>(i); };
    if (std::any_of(order.begin(), order.end(), isIt))
    {
      continue;
    }
    CenterlinePiece piece;
    piece.component = lines[i].component;
    piece.volume = 1e-3 * lines[i].volume;
    piece.place = ToPoint(network.grid, network.grid.Position(lines[i].core[lines[i].core.size() / 2]));
    piece.reason = "it is too far from the other pieces, or as narrow as small bowel";
    result.pieces.push_back(piece);
    result.warnings.push_back("a piece of lumen of " + InTenths(piece.volume) + " ml at " + PlaceInWords(piece.place) +
                              " is not used: " + piece.reason);
  }
}

void
AddUnusedComponents(const LumenMask *       lumen,
                    const LumenComponents & components,
                    const LumenChoice &     choice,
                    ColonCenterline &       result)
{
  for (std::size_t c = 1; c <= components.components.size(); ++c)
  {
    if (choice.isUsed[c])
    {
      continue;
    }
    CenterlinePiece piece;
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
AddMerges(const LumenNetwork & network, ColonCenterline & result)
{
  constexpr double onePlace = 30.0; // mm; chosen: merges nearer to each other are one place
  for (const CellTree::Merge & found : network.tree.Merges())
  {
    const CellPassage & passage = network.cells.passages[found.passage];
    CenterlineMerge     merge;
    merge.place = ToPoint(network.grid, network.grid.Position(passage.node));
    merge.clearance = passage.clearance;
    merge.loop = found.loop;
    const bool isKnown = std::any_of(result.merges.begin(), result.merges.end(), [&](const CenterlineMerge & m) {
      return m.place.EuclideanDistanceTo(merge.place) < onePlace;
    });
    if (!isKnown)
    {
      result.merges.push_back(merge);
      const std::string loop = merge.loop > 0.0 ? " that would cut off " + InTenths(merge.loop) + " mm" : "";
      result.warnings.push_back("loops of the colon touch at " + PlaceInWords(merge.place) + " through a hole of " +
                                InTenths(2.0 * merge.clearance) + " mm" + loop +
                                ": the centerline does not pass through it");
    }
  }
  std::vector<double> gaps, merges;
  for (const CenterlineGap & gap : result.gaps)
  {
    gaps.insert(gaps.end(), { gap.begin, gap.end });
  }
  for (const CenterlineMerge & m : result.merges)
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
    result.curve.fieldArrays.push_back(MakeArray("merges", merges, valuesOfMerge));
  }
}
} // namespace shapeton
