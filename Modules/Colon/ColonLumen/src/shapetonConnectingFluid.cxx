#include "shapetonConnectingFluid.h"

#include "shapetonDisjointSets.h"
#include "shapetonInterruption.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <unordered_map>

namespace shapeton
{
namespace
{
/** Bounds chosen on the sigmoid of one real patient (40 ml over a length of 150 mm, with an opening of 80 mm^2 at the
 * narrower end). */
constexpr double LeastJoinedMl = 2.0;  // minimum volume of each of the two pieces
constexpr double LeastStretchMl = 0.5; // minimum volume of a stretch
constexpr double LeastRestMl = 0.05;   // minimum volume of fluid behind a neck
constexpr double LeastOpening = 10.0;  // mm^2; leaks through a wall are smaller
constexpr double LongestPath = 400.0;  // mm; a sigmoid of usual length
constexpr double Detour = 50.0;        // mm through voxel faces; twice the depth of a haustrum beside the path
constexpr double SimilarFluid = 0.25;  // maximum deviation of the median, relative to the contrast of the fluid
/** Distance from certain gas to certain fluid across a blurred step, in standard deviations of the blur, plus half a
 * voxel for the sampling. A wall of 2 mm in between adds 1 mm. */
constexpr double ReachInBlurs = 2.25;
constexpr double ReachInVoxels = 0.5;
constexpr double NowhereNear = std::numeric_limits<double>::infinity();

constexpr double LeastEnclosed = 0.3; // share of the surface of gas that is open to the fluid

double
ReachOfOpening(const LumenField & field)
{
  return ReachInBlurs * field.Blur() + ReachInVoxels * std::cbrt(field.grid.VoxelVolume());
}

/** Lumen of the colon, connected across the blurred layer between gas and fluid. */
class PiecesOfLumen
{
public:
  explicit PiecesOfLumen(const LumenField & field) : m_Field(field), m_Reach(ReachOfOpening(field))
  {
    const ClassVolume & classes = field.classes;
    m_Runs = CollectRuns(field.grid, [&](std::size_t p) { return IsColonLumen(classes[p]); });
    m_Labels = LabelRuns(m_Runs);
    m_Joined = DisjointSets<>(m_Labels.number + 1);
    m_Ml.assign(m_Labels.number + 1, 0.0);
    ForEachRun(m_Runs, [&](std::size_t r, int j, int k) {
      for (int i = m_Runs.runs[r].begin; i < m_Runs.runs[r].end; ++i)
      {
        this->JoinToGas(field.grid.Index(i, j, k), m_Labels.ofRun[r]);
      }
    });
    for (std::size_t r = 0; r < m_Runs.runs.size(); ++r)
    {
      m_Ml[m_Joined.Find(m_Labels.ofRun[r])] +=
        1e-3 * field.grid.VoxelVolume() * (m_Runs.runs[r].end - m_Runs.runs[r].begin);
    }
  }

  /** Label of a sufficiently large piece that touches the voxel or has gas within the layer around it; 0 if there is
   * none. */
  int
  Next(std::size_t voxel)
  {
    int piece = 0;
    ForEachNeighbor(m_Field.grid, voxel, [&](std::size_t q) { piece = piece > 0 ? piece : this->LargePieceAt(q); });
    if (piece == 0)
    {
      this->ForEachGasNear(voxel, [&](std::size_t q) { piece = piece > 0 ? piece : this->LargePieceAt(q); });
    }
    return piece;
  }

private:
  template <typename TBody>
  void
  ForEachGasNear(std::size_t voxel, const TBody & body) const
  {
    ForAllWithin(m_Field.grid, voxel, m_Reach, [&](std::size_t q, double squaredDistance) {
      if (m_Field.classes[q] == ColonGas && squaredDistance <= m_Reach * m_Reach)
      {
        body(q);
      }
      return true;
    });
  }

  void
  JoinToGas(std::size_t voxel, int label)
  {
    bool isSurface = false;
    ForEachNeighbor(
      m_Field.grid, voxel, [&](std::size_t q) { isSurface = isSurface || !IsColonLumen(m_Field.classes[q]); });
    if (isSurface && m_Field.classes[voxel] == ColonFluid)
    {
      this->ForEachGasNear(voxel, [&](std::size_t q) { m_Joined.Join(label, this->LabelAt(q)); });
    }
  }

  int
  LabelAt(std::size_t voxel) const
  {
    const auto v = m_Field.grid.Voxel(voxel);
    const auto run = m_Runs.Find(v[0], v[1], v[2]);
    return run < 0 ? 0 : m_Labels.ofRun[run];
  }

  int
  LargePieceAt(std::size_t voxel)
  {
    if (!IsColonLumen(m_Field.classes[voxel]))
    {
      return 0;
    }
    const int piece = m_Joined.Find(this->LabelAt(voxel));
    return m_Ml[piece] >= LeastJoinedMl ? piece : 0;
  }

  const LumenField &  m_Field;
  double              m_Reach; ///< mm
  VoxelRuns           m_Runs;
  RunLabels           m_Labels;
  DisjointSets<>      m_Joined;
  std::vector<double> m_Ml; ///< by representative label
};

/** Connected bright matter that may connect pieces of the lumen. */
class BrightPiece
{
public:
  BrightPiece(const LumenField & field, VoxelSet voxels) : m_Field(field), m_Voxels(std::move(voxels))
  {
    for (std::size_t n = 0; n < m_Voxels.size(); ++n)
    {
      m_Index[m_Voxels[n]] = n;
    }
  }

  bool
  IsAsBrightAsFluid() const
  {
    std::vector<float> values;
    values.reserve(m_Voxels.size());
    for (const auto p : m_Voxels)
    {
      values.push_back(m_Field.hu[p]);
    }
    const auto & t = m_Field.evidence.thresholds;
    return std::abs(UpperMedian(std::move(values)) - t.fluid) <= SimilarFluid * (t.fluid - t.tissue);
  }

  /** The sufficiently large openings to pieces of the lumen. */
  std::vector<VoxelSet>
  Openings(PiecesOfLumen & lumen) const
  {
    std::map<int, VoxelSet> ofPiece;
    for (const auto p : m_Voxels)
    {
      if (const int piece = lumen.Next(p))
      {
        ofPiece[piece].push_back(p);
      }
    }
    const double          area = std::pow(m_Field.grid.VoxelVolume(), 2.0 / 3.0);
    std::vector<VoxelSet> openings;
    for (auto & entry : ofPiece)
    {
      if (area * static_cast<double>(entry.second.size()) >= LeastOpening)
      {
        openings.push_back(std::move(entry.second));
      }
    }
    return openings;
  }

  /** Voxels on paths between two openings that are hardly longer than the shortest path; empty if even that is too
   * long. */
  VoxelSet
  Between(const VoxelSet & one, const VoxelSet & other) const
  {
    const auto toOne = this->Distances(one);
    const auto toOther = this->Distances(other);
    double     shortest = NowhereNear;
    VoxelSet   between;
    for (std::size_t n = 0; n < m_Voxels.size(); ++n)
    {
      shortest = std::min(shortest, toOne[n] + toOther[n]);
    }
    for (std::size_t n = 0; shortest <= LongestPath && n < m_Voxels.size(); ++n)
    {
      if (toOne[n] + toOther[n] <= shortest + Detour)
      {
        between.push_back(m_Voxels[n]);
      }
    }
    return between;
  }

private:
  /** Lengths (mm) of the shortest paths from the sources through voxel faces. */
  std::vector<double>
  Distances(const VoxelSet & sources) const
  {
    using Arrival = std::pair<double, std::size_t>;
    std::vector<double>                                                       distances(m_Voxels.size(), NowhereNear);
    std::priority_queue<Arrival, std::vector<Arrival>, std::greater<Arrival>> queue;
    for (const auto p : sources)
    {
      distances[m_Index.at(p)] = 0.0;
      queue.push({ 0.0, m_Index.at(p) });
    }
    while (!queue.empty())
    {
      const Arrival next = queue.top();
      queue.pop();
      if (next.first > distances[next.second])
      {
        continue;
      }
      const Eigen::Vector3d place = m_Field.grid.Position(m_Voxels[next.second]);
      ForEachNeighbor(m_Field.grid, m_Voxels[next.second], [&](std::size_t q) {
        const auto found = m_Index.find(q);
        if (found != m_Index.end())
        {
          const double length = next.first + (m_Field.grid.Position(q) - place).norm();
          if (length < distances[found->second])
          {
            distances[found->second] = length;
            queue.push({ length, found->second });
          }
        }
      });
    }
    return distances;
  }

  const LumenField &                           m_Field;
  VoxelSet                                     m_Voxels;
  std::unordered_map<std::size_t, std::size_t> m_Index; ///< of a voxel in m_Voxels
};

/** Connected pieces of other bright matter. */
std::vector<VoxelSet>
PiecesOfOtherBright(const LumenField & field, double leastMl, double mostMl = NowhereNear)
{
  const VoxelRuns       set = CollectRuns(field.grid, [&](std::size_t p) { return field.classes[p] == OtherBright; });
  const RunLabels       labels = LabelRuns(set);
  std::vector<VoxelSet> pieces(labels.number + 1);
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    for (int i = set.runs[r].begin; i < set.runs[r].end; ++i)
    {
      pieces[labels.ofRun[r]].push_back(field.grid.Index(i, j, k));
    }
  });
  const double voxelMl = 1e-3 * field.grid.VoxelVolume();
  pieces.erase(std::remove_if(pieces.begin(),
                              pieces.end(),
                              [&](const VoxelSet & piece) {
                                const double ml = voxelMl * static_cast<double>(piece.size());
                                return ml < leastMl || ml > mostMl;
                              }),
               pieces.end());
  return pieces;
}

/** Whether the layer around a voxel contains a voxel of the wanted class. */
bool
IsOpenTo(const LumenField & field, unsigned char wanted, std::size_t voxel, double reach)
{
  return !ForAllWithin(field.grid, voxel, reach, [&](std::size_t q, double squaredDistance) {
    return field.classes[q] != wanted || squaredDistance > reach * reach;
  });
}

/** Turns other gas whose surface is largely open to the fluid into gas of the colon. */
void
TakeEnclosedGas(LumenField & field)
{
  ColonEvidence &          e = field.evidence;
  const double             reach = ReachOfOpening(field);
  std::vector<std::size_t> surface(e.gas.pieces.size(), 0);
  std::vector<std::size_t> open(e.gas.pieces.size(), 0);
  const auto               forEachVoxel = [&](const auto & body) {
    std::array<int, 3> v;
    ForEachRun(e.gas.set, [&](std::size_t r, int j, int k) {
      const int piece = e.gas.labels.ofRun[r];
      for (int i = e.gas.set.runs[r].begin; e.isCandidate[piece] && !e.isColon[piece] && i < e.gas.set.runs[r].end; ++i)
      {
        if (field.Local(e.grid.Index(i, j, k), v))
        {
          body(piece, field.grid.Index(v[0], v[1], v[2]));
        }
      }
    });
  };
  forEachVoxel([&](int piece, std::size_t p) {
    bool isSurface = false;
    ForEachNeighbor(field.grid, p, [&](std::size_t q) { isSurface = isSurface || field.classes[q] != OtherGas; });
    surface[piece] += isSurface;
    open[piece] += isSurface && IsOpenTo(field, ColonFluid, p, reach);
  });
  std::vector<char> isEnclosed(surface.size());
  for (std::size_t piece = 0; piece < surface.size(); ++piece)
  {
    isEnclosed[piece] =
      open[piece] > 0 && static_cast<double>(open[piece]) >= LeastEnclosed * static_cast<double>(surface[piece]);
  }
  forEachVoxel([&](int piece, std::size_t p) { field.classes[p] = isEnclosed[piece] ? ColonGas : field.classes[p]; });
  for (std::size_t piece = 0; piece < surface.size(); ++piece)
  {
    e.isColon[piece] = e.isColon[piece] || isEnclosed[piece];
  }
}
/** Classifies the voxels on the line from fluid to gas by comparison with the half height. */
void
FillLine(LumenField & field, std::size_t fluid, std::size_t gas)
{
  const ColonThresholds & t = field.evidence.thresholds;
  const auto              from = field.grid.Voxel(fluid);
  const auto              to = field.grid.Voxel(gas);
  int                     steps = 1;
  for (int a = 0; a < 3; ++a)
  {
    steps = std::max(steps, std::abs(to[a] - from[a]));
  }
  for (int n = 1; n < steps; ++n)
  {
    const auto at = [&](int a) {
      return from[a] + static_cast<int>(std::lround(n * static_cast<double>(to[a] - from[a]) / steps));
    };
    const std::size_t p = field.grid.Index(at(0), at(1), at(2));
    if (!IsColonLumen(field.classes[p]))
    {
      field.classes[p] = field.hu[p] < 0.5 * (t.gas + t.fluid) ? ColonGas : ColonFluid;
    }
  }
}

/** Fills the blurred layers between the fluid and the gas of the colon; they are level only where the fluid is free to
 * flow.
 */
void
FillOpenings(LumenField & field, const VoxelSet & fluid)
{
  const double reach = ReachOfOpening(field);
  for (const auto p : fluid)
  {
    ForAllWithin(field.grid, p, reach, [&](std::size_t q, double squaredDistance) {
      if (field.classes[q] == ColonGas && squaredDistance <= reach * reach)
      {
        FillLine(field, p, q);
      }
      return true;
    });
  }
}
void
Take(LumenField & field, const VoxelSet & voxels)
{
  for (const auto p : voxels)
  {
    field.classes[p] = ColonFluid;
  }
}

/** Whether a voxel adjoins fluid of the colon. */
bool
AdjoinsFluid(const LumenField & field, std::size_t voxel)
{
  bool adjoins = false;
  ForEachNeighbor(field.grid, voxel, [&](std::size_t q) { adjoins = adjoins || field.classes[q] == ColonFluid; });
  return adjoins;
}

/** Whether a piece behind a neck belongs to the fluid of the colon, that is, whether much of its surface is open to the
 * lumen. */
bool
IsRestOfFluid(const LumenField & field, const VoxelSet & piece)
{
  const double reach = ReachOfOpening(field);
  std::size_t  surface = 0;
  std::size_t  fluid = 0;
  std::size_t  open = 0;
  for (const auto p : piece)
  {
    bool isSurface = false;
    ForEachNeighbor(field.grid, p, [&](std::size_t q) { isSurface = isSurface || field.classes[q] != OtherBright; });
    const bool isAtFluid = isSurface && AdjoinsFluid(field, p);
    surface += isSurface;
    fluid += isAtFluid;
    open += isAtFluid || (isSurface && IsOpenTo(field, ColonGas, p, reach));
  }
  return std::pow(field.grid.VoxelVolume(), 2.0 / 3.0) * static_cast<double>(fluid) >= LeastOpening &&
         static_cast<double>(open) >= LeastEnclosed * static_cast<double>(surface);
}
} // namespace

VoxelSet
TakeConnectingFluid(LumenField & field)
{
  PiecesOfLumen lumen(field);
  VoxelSet      taken;
  for (VoxelSet & voxels : PiecesOfOtherBright(field, LeastStretchMl))
  {
    Interruption::Check();
    const BrightPiece piece(field, std::move(voxels));
    const auto        openings = piece.Openings(lumen);
    for (std::size_t one = 0; one < openings.size() && piece.IsAsBrightAsFluid(); ++one)
    {
      for (std::size_t other = 0; other < one; ++other)
      {
        const VoxelSet between = piece.Between(openings[one], openings[other]);
        taken.insert(taken.end(), between.begin(), between.end());
      }
    }
  }
  Take(field, taken);
  for (const VoxelSet & voxels : PiecesOfOtherBright(field, LeastRestMl, LeastJoinedMl))
  {
    if (IsRestOfFluid(field, voxels))
    {
      Take(field, voxels);
      taken.insert(taken.end(), voxels.begin(), voxels.end());
    }
  }
  if (!taken.empty())
  {
    TakeEnclosedGas(field);
    FillOpenings(field, taken);
  }
  return taken;
}
} // namespace shapeton
