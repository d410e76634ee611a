#include "shapetonStableRegions.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
using Index = ComponentTree::Index;

/** Width of a level of log heat; growth is measured over two levels, that is, a 5 % change in the threshold. */
constexpr double LevelWidth = 0.025;
/** The volume of a stable region stays within this factor. */
constexpr double SameVolume = 1.2;
/** The volumes of two regions of one path differ by at least this factor, which exceeds SameVolume. */
constexpr double OtherVolume = 1.3;
/** Smallest range over which a region must be stable; noise of a few percent is less persistent. */
constexpr double LeastRange = 0.1;

/** The region of a path that contains all its voxels up to a level, counted from the greatest heat. */
struct Step
{
  int   level;
  Index first, end;

  double
  Voxels() const
  {
    return end - first;
  }
};

/** The regions from an extremum until they join a larger one, each the main child of the next. */
struct Path
{
  std::vector<Step> steps;          ///< ascending levels
  int               lastLevel{ 0 }; ///< the level at which the path joins another one
  double            joined{ 0.0 };  ///< voxels of the region after it has joined

  /** Number of voxels at any level. */
  double
  Voxels(int level) const
  {
    if (level >= lastLevel)
    {
      return joined;
    }
    const Step * const step = this->StepAt(level);
    return step == nullptr ? 1.0 : step->Voxels();
  }

  /** The region with all voxels of the path up to a level; null before its first voxel. */
  const Step *
  StepAt(int level) const
  {
    const auto next =
      std::upper_bound(steps.begin(), steps.end(), level, [](int l, const Step & step) { return l < step.level; });
    return next == steps.begin() ? nullptr : &*(next - 1);
  }
};

class PathFinder
{
public:
  PathFinder(const ComponentTree & tree, const float * values, float greatest)
    : m_Arcs(tree.GetArcs()), m_Voxels(tree.GetVoxels()), m_Values(values), m_Greatest(greatest)
  {
    m_MainChild.assign(m_Arcs.size(), None);
    for (Index arc = 0; arc + 1 < m_Arcs.size(); ++arc)
    {
      Index & child = m_MainChild[m_Arcs[arc].parent];
      if (child == None || this->VoxelsOf(arc) > this->VoxelsOf(child))
      {
        child = arc;
      }
    }
    const double first = LogHeat(values[m_Voxels.front()], greatest);
    const double last = LogHeat(values[m_Voxels.back()], greatest);
    m_Sign = first < last ? -1.0 : 1.0;
  }

  /** The last arcs of all paths with at least this number of voxels. */
  std::vector<Index>
  PathEnds(std::uint64_t leastVoxels) const
  {
    std::vector<Index> ends;
    for (Index arc = 0; arc < m_Arcs.size(); ++arc)
    {
      const bool isMain = m_MainChild[m_Arcs[arc].parent] == arc;
      if (this->VoxelsOf(arc) >= leastVoxels && !isMain)
      {
        ends.push_back(arc);
      }
    }
    return ends;
  }

  Path
  FindPath(Index last) const
  {
    std::vector<Index> arcs;
    for (Index arc = last; arc != None; arc = m_MainChild[arc])
    {
      arcs.push_back(arc);
    }
    Path path;
    for (auto arc = arcs.rbegin(); arc != arcs.rend(); ++arc)
    {
      this->AddArc(m_Arcs[*arc], path);
    }
    const auto & parent = m_Arcs[m_Arcs[last].parent];
    const bool   isRoot = m_Arcs[last].parent == last;
    path.lastLevel = isRoot ? path.steps.back().level + 1 : this->LevelOf(parent.begin);
    path.joined = isRoot ? path.steps.back().Voxels() : parent.begin + 1 - parent.first;
    return path;
  }

private:
  static constexpr Index None = ~Index{ 0 };

  Index
  VoxelsOf(Index arc) const
  {
    return m_Arcs[arc].end - m_Arcs[arc].first;
  }

  int
  LevelOf(Index position) const
  {
    const double depth = m_Sign * -LogHeat(m_Values[m_Voxels[position]], m_Greatest);
    return static_cast<int>(std::floor(depth / LevelWidth));
  }

  void
  AddArc(const ComponentTree::Arc & arc, Path & path) const
  {
    for (Index begin = arc.begin; begin < arc.end;)
    {
      const int level = this->LevelOf(begin);
      Index     end = begin + 1; // by doubling and halving: levels ascend along the arc
      for (Index step = 1; end < arc.end && this->LevelOf(end) == level; step *= 2)
      {
        begin = end;
        end = step < arc.end - end ? end + step : arc.end;
      }
      while (begin + 1 < end)
      {
        const Index middle = begin + (end - begin) / 2;
        (this->LevelOf(middle) == level ? begin : end) = middle;
      }
      if (path.steps.empty() || path.steps.back().level != level)
      {
        path.steps.push_back({ level, 0, 0 });
      }
      path.steps.back().first = arc.first;
      path.steps.back().end = begin + 1;
      begin += 1;
    }
  }

  const std::vector<ComponentTree::Arc> & m_Arcs;
  const std::vector<Index> &              m_Voxels;
  const float *                           m_Values;
  float                                   m_Greatest;
  double                                  m_Sign{ 1.0 };
  std::vector<Index>                      m_MainChild;
};

/** The levels [first, last] around a level over which the volume stays within SameVolume. */
std::array<int, 2>
StableLevels(const Path & path, int level)
{
  const double       voxels = path.Voxels(level);
  std::array<int, 2> range = { { level, level } };
  while (range[0] - 1 >= path.steps.front().level && voxels <= SameVolume * path.Voxels(range[0] - 1))
  {
    --range[0];
  }
  while (range[1] + 1 < path.lastLevel && path.Voxels(range[1] + 1) <= SameVolume * voxels)
  {
    ++range[1];
  }
  return range;
}

/** The level of least growth, or the middle one of several. */
int
CalmestLevel(const Path & path, const std::array<int, 2> & range)
{
  const auto growth = [&](int level) { return path.Voxels(level + 1) / path.Voxels(level - 1); };
  int        first = range[0];
  int        last = range[0];
  for (int level = range[0] + 1; level <= range[1]; ++level)
  {
    const bool isLess = growth(level) < growth(first);
    first = isLess ? level : first;
    last = isLess || growth(level) == growth(first) ? level : last;
  }
  return (first + last) / 2;
}

/** The most persistent regions of a path. */
void
AddStableRegions(const Path &                path,
                 const HeatObjectOptions &   options,
                 double                      mostVoxels,
                 std::vector<StableRegion> & found)
{
  struct Plateau
  {
    std::array<int, 2> levels;
    double             voxels;
  };
  std::vector<Plateau> plateaus;
  for (int level = path.steps.front().level; level < path.lastLevel; ++level)
  {
    const double voxels = path.Voxels(level);
    if (voxels >= static_cast<double>(options.leastVoxels) && voxels <= mostVoxels)
    {
      plateaus.push_back({ StableLevels(path, level), voxels });
    }
  }
  std::stable_sort(plateaus.begin(), plateaus.end(), [](const Plateau & a, const Plateau & b) {
    return a.levels[1] - a.levels[0] > b.levels[1] - b.levels[0];
  });
  std::vector<double> accepted;
  for (const Plateau & plateau : plateaus)
  {
    const double range = (plateau.levels[1] - plateau.levels[0]) * LevelWidth;
    const bool   isOther = std::all_of(accepted.begin(), accepted.end(), [&](double voxels) {
      return std::max(voxels, plateau.voxels) >= OtherVolume * std::min(voxels, plateau.voxels);
    });
    if (range < LeastRange || !isOther)
    {
      continue;
    }
    const int    level = CalmestLevel(path, plateau.levels);
    const Step & step = *path.StepAt(level);
    const double growth = std::log(path.Voxels(level + 1) / path.Voxels(level - 1));
    accepted.push_back(step.Voxels());
    found.push_back({ step.first, step.end, growth, range });
  }
}
} // namespace

double
LogHeat(float value, float greatest)
{
  constexpr float least = 1e-6F;
  return std::log(static_cast<double>(std::max(value, least * greatest)));
}

std::vector<StableRegion>
FindStableRegions(const ComponentTree & tree, const float * values, float greatest, const HeatObjectOptions & options)
{
  const PathFinder                       finder(tree, values, greatest);
  const double                           mostVoxels = options.mostShare * static_cast<double>(tree.GetVoxels().size());
  const auto                             ends = finder.PathEnds(options.leastVoxels);
  std::vector<std::vector<StableRegion>> ofPaths(ends.size());
  ParallelFor(ends.size(),
              [&](std::size_t i) { AddStableRegions(finder.FindPath(ends[i]), options, mostVoxels, ofPaths[i]); });
  std::vector<StableRegion> regions;
  for (const auto & ofPath : ofPaths)
  {
    regions.insert(regions.end(), ofPath.begin(), ofPath.end());
  }
  return regions;
}
} // namespace shapeton
