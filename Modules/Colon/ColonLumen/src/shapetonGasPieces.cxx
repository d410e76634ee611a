#include "shapetonGasPieces.h"

#include "shapetonColonVolume.h"
#include "shapetonPrincipalAxes.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double ShareOfBorder = 0.6;   // length on the image border per length inside; chosen
constexpr double ShareOfWalls = 0.25;   // of the side walls of the image, or of a row; chosen
constexpr double ShareOfSection = 0.25; // of a section; chosen: the anal canal is much smaller
constexpr double CleftElongation = 2.0; // ratio of axes; chosen: a rectum is rounder, see colon-surfaces.md
constexpr double LeastCleft = 100.0;    // mm^2; chosen: excludes specks
constexpr double ThinShell = 8.0;       // mm; the abdominal wall is thicker
constexpr double NearPlace = 20.0;      // mm along a row; chosen
constexpr double ShareOfShell = 0.3;    // of the front and back ends of a piece; chosen
constexpr double MeasuredMl = 0.5;      // chosen: smaller pieces are not measured

/** Boundary lengths (mm), within the slices, of a part of a slice or a group of parts. */
struct Outline
{
  double border{ 0.0 };
  double edge{ 0.0 }; ///< inside the image
};

/** Computes the outline of each labeled part of the slices. */
std::vector<Outline>
OutlinesInSlices(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & labels)
{
  std::vector<Outline> outlines(labels.number + 1);
  const double         sx = grid.spacing[0];
  const double         sy = grid.spacing[1];
  ForEachRun(set, [&](std::size_t r, int j, int) {
    auto &         outline = outlines[labels.ofRun[r]];
    const VoxelRun run = set.runs[r];
    const double   length = (run.end - run.begin) * sx;
    (run.begin == 0 ? outline.border : outline.edge) += sy;
    (run.end == grid.size[0] ? outline.border : outline.edge) += sy;
    (j == 0 ? outline.border : outline.edge) += length;
    (j == grid.size[1] - 1 ? outline.border : outline.edge) += length;
  });
  // A boundary shared by two adjacent rows is not an edge, but was counted twice.
  for (int k = 0; k < set.size[2]; ++k)
  {
    for (int j = 1; j < set.size[1]; ++j)
    {
      ForEachOverlap(set, set.Row(j - 1, k), set.Row(j, k), [&](std::size_t r, std::size_t, int overlap) {
        outlines[labels.ofRun[r]].edge -= 2.0 * overlap * sx;
      });
    }
  }
  return outlines;
}

std::vector<char>
RunsOf(const RunLabels & labels, const std::vector<char> & isIn)
{
  std::vector<char> use(labels.ofRun.size());
  for (std::size_t r = 0; r < use.size(); ++r)
  {
    use[r] = isIn[labels.ofRun[r]];
  }
  return use;
}

/** Marks each part that contains one of the voxels. */
std::vector<char>
PartsOf(const VoxelRuns & set, const RunLabels & parts, const std::vector<std::array<int, 3>> & voxels)
{
  std::vector<char> holds(parts.number + 1, 0);
  for (const auto & v : voxels)
  {
    const auto run = set.Find(v[0], v[1], v[2]);
    holds[run >= 0 ? parts.ofRun[run] : 0] = 1;
  }
  return holds;
}

/** Whether each run is in a group of slice parts at the border that is outside air. */
std::vector<char>
OutsideRuns(const ColonGrid & grid, const VoxelRuns & set, const std::vector<std::array<int, 3>> & kept)
{
  const RunLabels   parts = LabelRuns(set, VoxelContact::FaceInSlice);
  const auto        outlines = OutlinesInSlices(grid, set, parts);
  std::vector<char> touches(parts.number + 1, 0);
  for (int p = 1; p <= parts.number; ++p)
  {
    touches[p] = outlines[p].border > 0.0;
  }
  const RunLabels      groups = LabelRuns(set, VoxelContact::Face, RunsOf(parts, touches));
  std::vector<Outline> ofGroup(groups.number + 1);
  std::vector<char>    done(parts.number + 1, 0);
  for (std::size_t r = 0; r < set.runs.size(); ++r)
  {
    const int part = parts.ofRun[r];
    if (!done[part])
    {
      done[part] = 1;
      ofGroup[groups.ofRun[r]].border += outlines[part].border;
      ofGroup[groups.ofRun[r]].edge += outlines[part].edge;
    }
  }
  std::vector<char> isOutside(groups.number + 1, 0);
  const double      walls = 2.0 * grid.size[2] * (grid.size[0] * grid.spacing[0] + grid.size[1] * grid.spacing[1]);
  for (int g = 1; g <= groups.number; ++g)
  {
    isOutside[g] = ofGroup[g].border >= std::min(ShareOfBorder * ofGroup[g].edge, ShareOfWalls * walls);
  }
  const std::vector<char> isKept = PartsOf(set, groups, kept);
  for (int g = 1; g <= groups.number; ++g)
  {
    isOutside[g] = isOutside[g] && !isKept[g];
  }
  isOutside[0] = 0;
  return RunsOf(groups, isOutside);
}

/** Number of voxels of a slice part, and their moments (mm) in one slice. */
struct Section
{
  double          voxels{ 0.0 };
  bool            touchesSide{ false }; ///< of the slice
  Eigen::Vector2d sum{ 0.0, 0.0 };
  Eigen::Matrix2d squares{ Eigen::Matrix2d::Zero() };

  PrincipalAxes
  Axes() const
  {
    const Eigen::Vector2d mean = sum / voxels;
    return PrincipalAxes(squares / voxels - mean * mean.transpose());
  }

  /** Whether a part is elongated from front to back, like the natal cleft, or open to the side, like air next to the
   * table. Gas over a fluid level is elongated sideways within the body. */
  bool
  IsLikeCleft(const ColonGrid & grid) const
  {
    const PrincipalAxes   axes = this->Axes();
    const Eigen::Vector2d along = axes.vectors.col(1);
    const Eigen::Vector3d inSpace = along[0] * grid.axes.col(0) + along[1] * grid.axes.col(1);
    const double          elongation = std::sqrt(axes.values[1] / std::max(axes.values[0], 1e-9));
    return elongation > CleftElongation && (touchesSide || std::abs(inSpace[1]) > std::abs(inSpace[0]));
  }
};

std::vector<Section>
SectionsOfParts(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & parts, int slice)
{
  std::vector<Section> sections(parts.number + 1);
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    auto &         section = sections[parts.ofRun[r]];
    const VoxelRun run = set.runs[r];
    section.voxels += run.end - run.begin;
    section.touchesSide =
      section.touchesSide || run.begin == 0 || run.end == grid.size[0] || j == 0 || j == grid.size[1] - 1;
    for (int i = run.begin; i < run.end && k == slice; ++i)
    {
      const Eigen::Vector2d x(i * grid.spacing[0], j * grid.spacing[1]);
      section.sum += x;
      section.squares += x * x.transpose();
    }
  });
  return sections;
}

/** Adds the natal cleft, and strips of air next to the table, to the outside air. At the caudal image border, unlike a
 * rectum, they are long and narrow, and oriented from front to back or open to the side. They are followed upward while
 * the overlap with the next slice is at least a quarter; the anal canal is much smaller. */
void
AddCleft(const ColonGrid &                       grid,
         const VoxelRuns &                       set,
         const std::vector<std::array<int, 3>> & kept,
         std::vector<char> &                     isOutsideRun)
{
  const RunLabels     parts = LabelRuns(set, VoxelContact::FaceInSlice);
  const int           caudal = grid.axes(2, 2) > 0.0 ? 0 : grid.size[2] - 1;
  const auto          sections = SectionsOfParts(grid, set, parts, caudal);
  const int           up = caudal == 0 ? 1 : -1;
  std::vector<char>   isKept = PartsOf(set, parts, kept);
  std::vector<char>   isCleft(parts.number + 1, 0);
  std::vector<double> overlaps(parts.number + 1, 0.0);
  std::vector<double> below(parts.number + 1, 0.0);
  for (int k = caudal; k >= 0 && k < grid.size[2]; k += up)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      const auto row = set.Row(j, k);
      for (auto r = set.firstOfRow[row]; r < set.firstOfRow[row + 1]; ++r)
      {
        const auto & section = sections[parts.ofRun[r]];
        const bool   isStart =
          k == caudal && section.voxels * grid.spacing[0] * grid.spacing[1] > LeastCleft && section.IsLikeCleft(grid);
        const bool goesOn = overlaps[parts.ofRun[r]] > ShareOfSection * std::max(1.0, below[parts.ofRun[r]]);
        isCleft[parts.ofRun[r]] = !isOutsideRun[r] && !isKept[parts.ofRun[r]] && (isStart || goesOn);
      }
    }
    for (int j = 0; j < grid.size[1] && k + up >= 0 && k + up < grid.size[2]; ++j)
    {
      ForEachOverlap(set, set.Row(j, k), set.Row(j, k + up), [&](std::size_t r, std::size_t s, int overlap) {
        if (isCleft[parts.ofRun[r]])
        {
          overlaps[parts.ofRun[s]] += overlap;
          below[parts.ofRun[s]] = std::max(below[parts.ofRun[s]], sections[parts.ofRun[r]].voxels);
        }
      });
    }
  }
  for (std::size_t r = 0; r < isOutsideRun.size(); ++r)
  {
    isOutsideRun[r] = isOutsideRun[r] || isCleft[parts.ofRun[r]];
  }
}

/** Whether the image border cuts a box. The caudal border is ignored if the image shows the whole outline of the body,
 * since it then cuts the natal cleft. */
bool
IsCut(const ColonGrid & grid, const VoxelBox & box, bool showsOutside)
{
  const bool isHeadUp = grid.axes(2, 2) > 0.0;
  bool       isCut = false;
  for (int a = 0; a < 3; ++a)
  {
    const bool isLong = a == 2 && showsOutside;
    isCut =
      isCut || (box.low[a] == 0 && !(isLong && isHeadUp)) || (box.high[a] == grid.size[a] && !(isLong && !isHeadUp));
  }
  return isCut;
}

/** Computes volumes, bounding boxes, means and centers. */
void
MeasurePieces(const ColonGrid & grid, const VoxelValues & hu, bool showsOutside, GasOfVolume & gas)
{
  const auto                   measured = PiecesOfRuns(gas.set, gas.labels);
  std::vector<Eigen::Vector3d> sums(gas.pieces.size(), Eigen::Vector3d::Zero());
  ForEachRun(gas.set, [&](std::size_t r, int j, int k) {
    const int      p = gas.labels.ofRun[r];
    const VoxelRun run = gas.set.runs[r];
    sums[p] += Eigen::Vector3d(0.5 * (run.begin + run.end - 1), j, k) * (run.end - run.begin);
    for (int i = run.begin; i < run.end; ++i)
    {
      gas.pieces[p].mean += hu[grid.Index(i, j, k)];
    }
  });
  for (std::size_t p = 1; p < gas.pieces.size(); ++p)
  {
    auto & piece = gas.pieces[p];
    piece.voxels = measured[p].voxels;
    piece.box = measured[p].box;
    piece.ml = piece.voxels * grid.VoxelVolume() * 1e-3;
    piece.mean /= static_cast<double>(piece.voxels);
    piece.center = grid.Position(Eigen::Vector3d(sums[p] / static_cast<double>(piece.voxels)));
    piece.isCut = IsCut(grid, piece.box, showsOutside);
  }
}

/** Finds pieces with a wide opening to outside air across slices. */
void
FindPockets(const ColonGrid & grid, GasOfVolume & gas)
{
  std::vector<double> contact(gas.pieces.size(), 0.0);
  std::vector<double> section(gas.pieces.size(), 0.0);
  std::vector<double> largest(gas.pieces.size(), 0.0);
  std::vector<int>    slice(gas.pieces.size(), -1);
  ForEachRun(gas.set, [&](std::size_t r, int, int k) {
    const int p = gas.labels.ofRun[r];
    section[p] = slice[p] == k ? section[p] : 0.0;
    slice[p] = k;
    section[p] += gas.set.runs[r].end - gas.set.runs[r].begin;
    largest[p] = std::max(largest[p], section[p]);
  });
  for (int k = 1; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      ForEachOverlap(gas.set, gas.set.Row(j, k - 1), gas.set.Row(j, k), [&](std::size_t r, std::size_t s, int overlap) {
        if (gas.isOutsideRun[r] != gas.isOutsideRun[s])
        {
          contact[gas.isOutsideRun[r] ? gas.labels.ofRun[s] : gas.labels.ofRun[r]] += overlap;
        }
      });
    }
  }
  for (std::size_t p = 1; p < gas.pieces.size(); ++p)
  {
    gas.pieces[p].isOutside = contact[p] > ShareOfSection * largest[p];
  }
}

/** Whether, near a position, at least a quarter of the first or last row of a slice is outside air, so that the image
 * border does not cut the body there. */
bool
ShowsAir(const ColonGrid & grid, const GasOfVolume & gas, int i, int j, int k)
{
  const auto row = gas.set.Row(j, k);
  const auto reach = static_cast<int>(std::lround(NearPlace / grid.spacing[0]));
  const int  begin = std::max(0, i - reach);
  const int  end = std::min(grid.size[0], i + reach + 1);
  int        outside = 0;
  for (auto r = gas.set.firstOfRow[row]; r < gas.set.firstOfRow[row + 1]; ++r)
  {
    const auto & run = gas.set.runs[r];
    outside += gas.isOutsideRun[r] ? std::max(0, std::min<int>(end, run.end) - std::max<int>(begin, run.begin)) : 0;
  }
  return outside >= ShareOfWalls * (end - begin);
}

/** Whether only a thin shell separates the end of a gas column from outside air, or from an image border where there is
 * air. */
bool
IsThinlyCovered(const ColonGrid & grid, const GasOfVolume & gas, int i, int j, int k, int towards)
{
  for (int n = 1; n * grid.spacing[1] <= ThinShell; ++n)
  {
    const int row = j + towards * n;
    if (row < 0 || row >= grid.size[1])
    {
      return ShowsAir(grid, gas, i, std::clamp(row, 0, grid.size[1] - 1), k);
    }
    const auto run = gas.set.Find(i, row, k);
    if (run >= 0)
    {
      return gas.isOutsideRun[run] || gas.pieces[gas.labels.ofRun[run]].isOutside;
    }
  }
  return false;
}

/** Adds pieces whose front or back is a thin shell next to outside air: hollow tables, cushions and blankets, and the
 * natal cleft above them. Returns whether any was found. */
bool
FindShells(const ColonGrid & grid, GasOfVolume & gas)
{
  std::vector<double> ends(gas.pieces.size(), 0.0);
  std::vector<double> thin(gas.pieces.size(), 0.0);
  ForEachRun(gas.set, [&](std::size_t r, int j, int k) {
    const int p = gas.labels.ofRun[r];
    if (p == 0 || gas.pieces[p].ml < MeasuredMl || gas.pieces[p].isOutside)
    {
      return;
    }
    const VoxelRun run = gas.set.runs[r];
    const int      i = (run.begin + run.end) / 2;
    for (const int towards : { -1, 1 })
    {
      const int row = j + towards;
      if (row < 0 || row >= grid.size[1] || gas.set.Find(i, row, k) < 0)
      {
        ends[p] += run.end - run.begin;
        thin[p] += IsThinlyCovered(grid, gas, i, j, k, towards) ? run.end - run.begin : 0;
      }
    }
  });
  bool isAnyNew = false;
  for (std::size_t p = 1; p < gas.pieces.size(); ++p)
  {
    const bool isNew = !gas.pieces[p].isOutside && thin[p] > ShareOfShell * ends[p];
    gas.pieces[p].isOutside = gas.pieces[p].isOutside || isNew;
    isAnyNew = isAnyNew || isNew;
  }
  return isAnyNew;
}

/** Adds voxels with four neighbors in a mask, to close gaps where oblique columns change voxel rows. */
void
FillGaps(const ColonGrid & grid, std::vector<unsigned char> & mask)
{
  const auto before = mask;
  for (int k = 1; k + 1 < grid.size[2]; ++k)
  {
    for (int j = 1; j + 1 < grid.size[1]; ++j)
    {
      for (int i = 1; i + 1 < grid.size[0]; ++i)
      {
        const auto p = grid.Index(i, j, k);
        int        neighbors = 0;
        for (const auto step : grid.stride)
        {
          neighbors += before[p - step] + before[p + step];
        }
        mask[p] = mask[p] || neighbors >= 4;
      }
    }
  }
}
} // namespace

GasOfVolume
FindGas(const ColonGrid & grid, const VoxelValues & hu, double seed, const std::vector<std::array<int, 3>> & kept)
{
  GasOfVolume gas;
  gas.set = CollectRuns(grid, [&](std::size_t p) { return hu[p] < seed; });
  gas.isOutsideRun = OutsideRuns(grid, gas.set, kept);
  const bool showsOutside = std::find(gas.isOutsideRun.begin(), gas.isOutsideRun.end(), 1) != gas.isOutsideRun.end();
  if (showsOutside)
  {
    AddCleft(grid, gas.set, kept, gas.isOutsideRun);
  }
  std::vector<char> inside(gas.isOutsideRun.size());
  for (std::size_t r = 0; r < inside.size(); ++r)
  {
    inside[r] = !gas.isOutsideRun[r];
  }
  gas.labels = LabelRuns(gas.set, VoxelContact::Face, inside);
  gas.pieces.resize(gas.labels.number + 1);
  gas.pieces[0].isOutside = true;
  MeasurePieces(grid, hu, showsOutside, gas);
  FindPockets(grid, gas);
  while (showsOutside && FindShells(grid, gas))
  {}
  return gas;
}

void
MeasureDepth(const ColonGrid & grid, const VoxelValues & hu, GasOfVolume & gas)
{
  for (int p = 1; p <= gas.labels.number; ++p)
  {
    auto & piece = gas.pieces[p];
    if (piece.ml < MeasuredMl || piece.isOutside)
    {
      continue;
    }
    const VoxelBox  box = grid.Widened(piece.box, 1e-6);
    const ColonGrid part = grid.Part(box);
    const auto      d = SquaredDistanceToBackground(part, MaskOfRuns(grid, gas.set, gas.labels, p, box));
    // There is no background if a piece fills its bounding box.
    const float deepest = std::min(*std::max_element(d.begin(), d.end()), 1e6F);
    piece.radius = std::sqrt(deepest);
    const float least = std::min(9.0F, 0.36F * deepest);
    double      sum = 0.0;
    std::size_t count = 0;
    for (int k = 0; k < part.size[2]; ++k)
    {
      for (int j = 0; j < part.size[1]; ++j)
      {
        for (int i = 0; i < part.size[0]; ++i)
        {
          if (d[part.Index(i, j, k)] >= least)
          {
            sum += hu[grid.Index(i + box.low[0], j + box.low[1], k + box.low[2])];
            ++count;
          }
        }
      }
    }
    piece.inside = sum / static_cast<double>(count);
  }
}

MeasuredPiece
MeasureTogether(const ColonGrid &                       grid,
                const GasOfVolume &                     gas,
                int                                     piece,
                const std::vector<std::array<int, 3>> & voxels)
{
  VoxelBox box = gas.pieces[piece].box;
  for (const auto & v : voxels)
  {
    for (int a = 0; a < 3; ++a)
    {
      box.low[a] = std::min(box.low[a], v[a]);
      box.high[a] = std::max(box.high[a], v[a] + 1);
    }
  }
  box = grid.Widened(box, OneVoxel);
  const ColonGrid part = grid.Part(box);
  auto            mask = MaskOfRuns(grid, gas.set, gas.labels, piece, box);
  for (const auto & v : voxels)
  {
    mask[part.Index(v[0] - box.low[0], v[1] - box.low[1], v[2] - box.low[2])] = 1;
  }
  FillGaps(part, mask);
  const auto d = SquaredDistanceToBackground(part, mask);
  return { std::count(mask.begin(), mask.end(), 1) * grid.VoxelVolume() * 1e-3,
           std::sqrt(std::min(*std::max_element(d.begin(), d.end()), GreatestSquaredDistance)) };
}
} // namespace shapeton
