#include "shapetonTaggedPools.h"

#include "shapetonAirFluidLevels.h"
#include "shapetonColonPieces.h"
#include "shapetonColonVolume.h"
#include "shapetonInterruption.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>

namespace shapeton
{
namespace
{
constexpr double PassageRadius = 2.5;   // mm; narrower connections between parts of the fluid are leaks
constexpr double PassageInVoxels = 1.4; // minimum radius of a passage, to exclude layers across a wall
constexpr double ThinReach = 12.0;      // maximum length (mm) of a thin layer from wide fluid or a level
constexpr double DeepestWide = 20.0;    // maximum depth (mm) of a wide part below a level
constexpr double ReachOfDip = 3.0;      // voxels
/** Tolerated rise in intensity along a path (HU), and its increase per HU of noise (standard deviation). */
constexpr double LeastTolerance = 10.0;
constexpr double ToleratedNoise = 0.5;

/** Undecided matter at least as wide as a passage; parts that belong to the colon are marked. */
class WideFluid
{
public:
  explicit WideFluid(LumenField & field)
    : m_Field(field)
    , m_Column(field.grid,
               field.hu,
               field.fall,
               field.evidence.thresholds,
               field.evidence.remainingNoise,
               field.evidence.smoothing)
  {
    const ClassVolume &        classes = field.classes;
    std::vector<unsigned char> mask(classes.size());
    std::transform(classes.begin(), classes.end(), mask.begin(), [](unsigned char c) { return c == Undecided; });
    const double radius = std::max(PassageRadius, PassageInVoxels * field.grid.spacing.maxCoeff());
    const auto   d = SquaredDistanceToBackground(field.grid, mask, radius);
    m_Runs = CollectRuns(field.grid, [&](std::size_t p) { return d[p] >= radius * radius && classes[p] == Undecided; });
    m_Labels = LabelRuns(m_Runs);
    m_IsColon.assign(m_Labels.number + 1, 0);
  }

  /** Marks the fluid directly under the levels of the colon, and wide parts below it that are not separated from it by
   * a wall. */
  void
  MarkUnderLevels()
  {
    std::vector<LevelColumn::Votes> votes(m_IsColon.size());
    for (const auto & level : m_Field.evidence.levels)
    {
      std::array<int, 3> v;
      for (const auto floor : level.voxels)
      {
        if (m_Field.evidence.isColon[level.gas] && m_Field.IsTagged(level) && m_Field.Local(floor, v))
        {
          this->MarkColumn(level, v, votes);
        }
      }
    }
    for (std::size_t n = 1; n < votes.size(); ++n)
    {
      m_IsColon[n] = m_IsColon[n] || (votes[n].all > 0 && votes[n].AreOpen());
    }
  }

  void
  MarkSeeds()
  {
    for (const auto & seed : m_Field.evidence.brightSeeds)
    {
      std::array<int, 3> v;
      if (m_Field.Local(m_Field.evidence.grid.Index(seed[0], seed[1], seed[2]), v))
      {
        m_Field.classes[m_Field.grid.Index(v[0], v[1], v[2])] = ColonFluid;
        const auto run = m_Runs.Find(v[0], v[1], v[2]);
        m_IsColon[run < 0 ? 0 : m_Labels.ofRun[run]] = 1;
      }
    }
  }

  void
  Paint()
  {
    ForEachRun(m_Runs, [&](std::size_t r, int j, int k) {
      const auto first = m_Field.classes.begin() + m_Field.grid.Index(0, j, k);
      std::fill(first + m_Runs.runs[r].begin,
                first + m_Runs.runs[r].end,
                m_IsColon[m_Labels.ofRun[r]] ? ColonFluid : OtherBright);
    });
  }

private:
  /** Processes one column under a level: marks the first fluid, and votes on the first wide part below it. */
  void
  MarkColumn(const Level & level, const std::array<int, 3> & floor, std::vector<LevelColumn::Votes> & votes)
  {
    bool isIn = false;
    bool isOpen = false;
    for (int t = 1; t * m_Field.fall.step <= (isIn ? DeepestWide : m_Field.FluidReach()); ++t)
    {
      const auto q = m_Field.Below(floor, t);
      if (q < 0)
      {
        return;
      }
      unsigned char & here = m_Field.classes[q];
      const bool      isFluid = here == Undecided || here == ColonFluid;
      if (isIn && !isFluid)
      {
        return;
      }
      if (!isIn && isFluid)
      {
        isIn = true;
        isOpen = m_Column.IsOpen(level, floor, t);
        here = isOpen ? static_cast<unsigned char>(ColonFluid) : here;
      }
      const auto w = m_Field.grid.Voxel(q);
      const auto run = m_Runs.Find(w[0], w[1], w[2]);
      if (isIn && run >= 0)
      {
        votes[m_Labels.ofRun[run]].open += isOpen;
        ++votes[m_Labels.ofRun[run]].all;
        return;
      }
    }
  }

  LumenField &      m_Field;
  LevelColumn       m_Column;
  VoxelRuns         m_Runs;
  RunLabels         m_Labels;
  std::vector<char> m_IsColon; ///< by label
};
} // namespace

void
SplitAtNecks(LumenField & field)
{
  WideFluid wide(field);
  wide.MarkUnderLevels();
  wide.MarkSeeds();
  wide.Paint();
  ClassVolume & classes = field.classes;
  const int     layers = static_cast<int>(std::ceil(ThinReach / std::cbrt(field.grid.VoxelVolume())));
  GrowClasses(field.grid, classes, layers, [&classes](std::size_t p, unsigned char c) {
    return classes[p] == Undecided && (c == ColonFluid || c == OtherBright);
  });
  std::replace(
    classes.begin(), classes.end(), static_cast<unsigned char>(Undecided), static_cast<unsigned char>(OtherBright));
}

namespace
{
constexpr double LeastPoolContrast = 100.0; // HU above tissue
constexpr double Plateau = 0.75;            // relative to the contrast of a core; a wall in between is below
constexpr double GreatestDepth = 15.0;      // mm, ratio of core volume to open contact area with the fluid
constexpr double LeastCoreMl = 0.05;        // chosen: excludes specks of noise
constexpr double NeckRadius = 2.5;          // mm; parts connected by narrower necks are tested separately
/** Maximum share of the surface of a core that is next to brighter matter. Fluid that mixes fades towards tissue; a rim
 * of brighter small bowel behind a thin wall has 0.6 to 1 (a real scan and phantoms), unmixed fluid in the colon 0 to
 * 0.4 (phantoms). */
constexpr double MostRising = 0.5;

struct Arrival
{
  float       faintest; ///< minimum of the mean values on the path
  std::size_t voxel;

  bool
  operator<(const Arrival & other) const
  {
    return faintest != other.faintest ? faintest < other.faintest : voxel > other.voxel;
  }
};

class UnmixedFluid
{
public:
  UnmixedFluid(const ColonGrid &       grid,
               const VoxelValues &     hu,
               const VoxelValues &     sharp,
               const ColonThresholds & thresholds,
               double                  noise,
               double                  smoothing,
               ClassVolume &           classes)
    : m_Grid(grid)
    , m_Hu(hu)
    , m_Sharp(sharp)
    , m_Least(thresholds.tissue +
              std::max(LeastPoolContrast, ShareInWall(grid, smoothing) * (thresholds.fluid - thresholds.tissue)))
    , m_Tissue(thresholds.tissue)
    , m_Tolerance(LeastTolerance + ToleratedNoise * noise)
    , m_Voxel(std::max(1.0, std::cbrt(grid.VoxelVolume())))
    , m_Classes(classes)
  {}

  void
  Add(const VoxelSet & seeds)
  {
    m_Seeds = seeds;
    std::sort(m_Seeds.begin(), m_Seeds.end());
    this->Flood(seeds);
    this->GrowBack(this->Cores(seeds));
  }

private:
  /** Mean of a voxel and its face neighbors, which reduces noise but preserves walls two voxels thick. */
  float
  Mean(std::size_t voxel) const
  {
    float sum = m_Hu[voxel];
    int   count = 1;
    ForEachNeighbor(m_Grid, voxel, [&](std::size_t q) {
      sum += m_Hu[q];
      ++count;
    });
    return sum / static_cast<float>(count);
  }

  /** Visits reachable voxels in order of path brightness, so the first path to each voxel is the best. */
  void
  Flood(const VoxelSet & seeds)
  {
    std::priority_queue<Arrival> queue;
    const auto                   visit = [&](std::size_t q, float faintest) {
      if (m_Classes[q] == Nothing && m_Reached.count(q) == 0)
      {
        const float mean = this->Mean(q);
        if (mean >= m_Least && mean <= faintest + m_Tolerance)
        {
          m_Reached[q] = mean;
          queue.push({ std::min(faintest, mean), q });
        }
      }
    };
    for (std::size_t p = 0; p < m_Classes.size(); ++p)
    {
      if (m_Classes[p] == ColonFluid)
      {
        ForEachNeighbor(m_Grid, p, [&](std::size_t q) {
          if (m_Classes[q] == Nothing)
          {
            queue.push({ std::numeric_limits<float>::max(), p });
          }
        });
      }
    }
    for (const auto p : seeds)
    {
      m_Reached[p] = this->Mean(p);
      queue.push({ m_Reached[p], p });
    }
    RareInterruption interruption;
    while (!queue.empty())
    {
      interruption.Check();
      const Arrival next = queue.top();
      queue.pop();
      ForEachNeighbor(m_Grid, next.voxel, [&](std::size_t q) { visit(q, next.faintest); });
    }
  }

  /** Whether fluid is within two voxels or 2 mm, where matter may be its blurred edge. */
  bool
  IsNearFluid(std::size_t p) const
  {
    const double reach = std::max(2.0, 1.99 * m_Voxel);
    return !ForAllWithin(m_Grid, p, reach, [&](std::size_t q, double squaredDistance) {
      return m_Classes[q] != ColonFluid || squaredDistance >= reach * reach;
    });
  }

  /** Cores: reached voxels beyond the blurred edge, in pieces of at least LeastCoreMl that are open to the fluid. */
  VoxelSet
  Cores(const VoxelSet & seeds) const
  {
    VoxelSet cores;
    for (const auto & reached : m_Reached)
    {
      if (m_Hu[reached.first] > m_Least && !this->IsNearFluid(reached.first))
      {
        cores.push_back(reached.first);
      }
    }
    cores.insert(cores.end(), seeds.begin(), seeds.end());
    std::sort(cores.begin(), cores.end());
    cores.erase(std::unique(cores.begin(), cores.end()), cores.end());
    return this->OpenPieces(cores);
  }

  /** Minimum value on the line to the nearest fluid voxel; empty if there is none within three voxels. */
  std::optional<double>
  DipTowardsFluid(std::size_t p) const
  {
    double      nearest = ReachOfDip * ReachOfDip * m_Voxel * m_Voxel;
    std::size_t fluid = p;
    ForAllWithin(m_Grid, p, ReachOfDip * m_Voxel, [&](std::size_t q, double squaredDistance) {
      if (m_Classes[q] == ColonFluid && squaredDistance < nearest)
      {
        nearest = squaredDistance;
        fluid = q;
      }
      return true;
    });
    if (fluid == p)
    {
      return std::nullopt;
    }
    const auto from = m_Grid.Voxel(p);
    const auto to = m_Grid.Voxel(fluid);
    const int  steps = std::max({ std::abs(to[0] - from[0]), std::abs(to[1] - from[1]), std::abs(to[2] - from[2]) });
    double     dip = m_Sharp[p];
    for (int n = 1; n < steps; ++n)
    {
      const auto at = [&](int a) {
        return from[a] + static_cast<int>(std::lround(n * static_cast<double>(to[a] - from[a]) / steps));
      };
      dip = std::min<double>(dip, m_Sharp[m_Grid.Index(at(0), at(1), at(2))]);
    }
    return dip;
  }

  /** Whether a core contains a seed, or has broad contact with the fluid and mostly no dip in between. */
  bool
  IsOpenToFluid(const VoxelSet & piece) const
  {
    double              sum = 0.0;
    std::vector<double> dips;
    for (const auto p : piece)
    {
      if (std::binary_search(m_Seeds.begin(), m_Seeds.end(), p))
      {
        return true;
      }
      sum += m_Reached.at(p);
      if (const auto dip = this->DipTowardsFluid(p))
      {
        dips.push_back(*dip);
      }
    }
    const double mean = sum / static_cast<double>(piece.size());
    const auto   open = static_cast<std::size_t>(std::count_if(
      dips.begin(), dips.end(), [&](double dip) { return dip - m_Tissue > Plateau * (mean - m_Tissue); }));
    return 3 * open > 2 * dips.size() &&
           open * m_Voxel * m_Voxel * GreatestDepth >= piece.size() * m_Grid.VoxelVolume() &&
           !this->IsRimOfBrighter(piece);
  }

  /** Whether a core is the blurred rim of brighter matter that no fading path reaches. */
  bool
  IsRimOfBrighter(const VoxelSet & piece) const
  {
    std::size_t surface = 0;
    std::size_t rising = 0;
    for (const auto p : piece)
    {
      const float brightest = m_Reached.at(p) + static_cast<float>(m_Tolerance);
      bool        isSurface = false;
      bool        isRising = false;
      ForEachNeighbor(m_Grid, p, [&](std::size_t q) {
        const bool isOutside = m_Classes[q] != ColonFluid && m_Classes[q] != ColonGas && m_Reached.count(q) == 0;
        isSurface = isSurface || isOutside;
        isRising = isRising || (isOutside && this->Mean(q) > brightest);
      });
      surface += isSurface;
      rising += isRising;
    }
    return static_cast<double>(rising) > MostRising * static_cast<double>(surface);
  }

  VoxelSet
  OpenPieces(const VoxelSet & cores) const
  {
    VoxelSet   kept;
    const auto isLumen = [this](std::size_t p) { return m_Classes[p] == ColonFluid || m_Classes[p] == ColonGas; };
    for (const auto & piece : ConnectedPieces(m_Grid, cores, PartsAtNecks(m_Grid, cores, NeckRadius, isLumen)))
    {
      if (piece.size() * m_Grid.VoxelVolume() * 1e-3 >= LeastCoreMl && this->IsOpenToFluid(piece))
      {
        kept.insert(kept.end(), piece.begin(), piece.end());
      }
    }
    std::sort(kept.begin(), kept.end());
    return kept;
  }

  /** Adds cores, and adjacent voxels with values above the half height of the core. */
  void
  GrowBack(const VoxelSet & cores)
  {
    std::vector<std::pair<std::size_t, float>> front;
    for (const auto p : cores)
    {
      m_Classes[p] = ColonFluid;
      front.push_back({ p, m_Reached[p] });
    }
    for (int layer = 0; layer < 4; ++layer)
    {
      std::vector<std::pair<std::size_t, float>> next;
      for (const auto & from : front)
      {
        ForEachNeighbor(m_Grid, from.first, [&](std::size_t q) {
          if (m_Classes[q] == Nothing && m_Hu[q] > 0.5 * (m_Tissue + from.second))
          {
            m_Classes[q] = ColonFluid;
            next.push_back({ q, from.second });
          }
        });
      }
      front.swap(next);
    }
  }

  const ColonGrid &                      m_Grid;
  const VoxelValues &                    m_Hu;
  const VoxelValues &                    m_Sharp;
  double                                 m_Least;
  double                                 m_Tissue;
  double                                 m_Tolerance;
  double                                 m_Voxel; ///< mm, at least 1
  ClassVolume &                          m_Classes;
  VoxelSet                               m_Seeds;
  std::unordered_map<std::size_t, float> m_Reached;
};
} // namespace

void
AddUnmixedFluid(const ColonGrid &                grid,
                const VoxelValues &              hu,
                const VoxelValues &              sharp,
                const ColonThresholds &          thresholds,
                double                           noise,
                double                           smoothing,
                const std::vector<std::size_t> & seeds,
                ClassVolume &                    classes)
{
  if (thresholds.fluid > 0.0)
  {
    UnmixedFluid(grid, hu, sharp, thresholds, noise, smoothing, classes).Add(seeds);
  }
}

namespace
{
/** Limits for tagged fluid without gas, chosen on few data. Smaller pools look like small bowel. Pools of 80 and 150 ml
 * in two phantoms (seeds 3 and 8, prone) are missed. */
constexpr double LeastMl = 50.0;
constexpr double LeastRadius = 14.0; // mm; small bowel has a diameter of 25 mm, plus discretization
constexpr double RectumMl = 20.0;
constexpr double PoolRectumRadius = 10.0; // mm
constexpr double LeastLength = 2.5;       // in volumes of the largest inscribed ball
constexpr double WellTagged = 300.0;      // HU above tissue
constexpr double SimilarShare = 0.25;     // relative to the contrast of the fluid

/** Whether the mean of up to 27 voxels at the center of the largest inscribed ball is similar to the fluid of the
 * colon. The center may be at the image border. */
bool
IsAsBright(const ColonEvidence & evidence, const std::array<int, 3> & middle)
{
  double sum = 0.0;
  int    number = 0;
  for (int n = 0; n < 27; ++n)
  {
    const std::array<int, 3> v{ { middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1 } };
    if (evidence.grid.Holds(v[0], v[1], v[2]))
    {
      sum += evidence.hu[evidence.grid.Index(v[0], v[1], v[2])];
      ++number;
    }
  }
  const auto & t = evidence.thresholds;
  return std::abs(sum / number - t.fluid) < SimilarShare * (t.fluid - t.tissue);
}
} // namespace

std::vector<FluidWithoutGas>
TakeFluidWithoutGas(ColonEvidence & evidence)
{
  std::vector<FluidWithoutGas> taken;
  if (!evidence.isTagged || evidence.thresholds.fluid - evidence.thresholds.tissue < WellTagged)
  {
    return taken;
  }
  const auto pieces = PiecesOfRuns(evidence.brightSet, evidence.brightLabels);
  const auto areNearer = PiecesNearerToAnus(evidence, evidence.brightSet, evidence.brightLabels);
  for (int p = 1; p <= evidence.brightLabels.number; ++p)
  {
    const double ml = 1e-3 * evidence.grid.VoxelVolume() * static_cast<double>(pieces[p].voxels);
    if (evidence.isColonBright[p] || ml < (areNearer[p] ? RectumMl : LeastMl))
    {
      continue;
    }
    const auto   deepest = FindDeepestVoxel(evidence.grid, evidence.brightSet, evidence.brightLabels, p, pieces[p]);
    const auto & v = deepest.voxel;
    const double ballMl = 4e-3 / 3.0 * Pi * deepest.radius * deepest.radius * deepest.radius;
    const bool   isWide = ml >= LeastMl && deepest.radius >= LeastRadius;
    if ((isWide || (areNearer[p] && deepest.radius >= PoolRectumRadius)) && ml >= LeastLength * ballMl &&
        IsAsBright(evidence, v))
    {
      evidence.isColonBright[p] = 1;
      evidence.brightSeeds.push_back(v);
      taken.push_back({ ml, !isWide, evidence.grid.Position(evidence.grid.Index(v[0], v[1], v[2])) });
    }
  }
  return taken;
}
} // namespace shapeton
