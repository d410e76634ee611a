#include "shapetonPelvis.h"

#include "shapetonQuantiles.h"
#include "shapetonVoxelRuns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double cellEdge = 3.0;        // mm; cells of 4 mm join tagged bowel with the sacrum
constexpr double cellPerSpacing = 1.25; // so that thick slices leave no empty layers, also if tilted
constexpr double sampleDistance = 1.5;  // mm, two samples along each edge of a cell
constexpr float  outside = -1024.0F;    // HU of cells without samples
/** HU. Averages in iliac wings are 160 to 600 (two CTs); muscle and contrast-enhanced vessels are below 130. */
constexpr float  leastBone = 150.0F;
constexpr float  greatestGas = -600.0F;  // HU
constexpr float  leastBody = -300.0F;    // HU
constexpr double halfSpine = 24.0;       // mm; half width of the strip that contains the spine
constexpr double halfPromontory = 10.0;  // mm
constexpr double besideSpine = 40.0;     // mm; the iliac bones are lateral to it
constexpr double leastHip = 100e3;       // mm^3; 330 and 360 ml of one, 960 ml of another patient (with the femur)
constexpr double leastHipHeight = 70.0;  // mm
constexpr double greatestContact = 0.05; // with gas; 0.003 of hip bones, 0.08 and 0.16 of contrast agent in the colon
constexpr double leastBehind = 20.0;     // mm behind the promontory
constexpr double leastAbove = 10.0;      // mm of image above a crest
constexpr double lumbarHeight = 60.0;    // mm above the crests where the front edge is level
constexpr double leastBelow = 40.0;      // mm of spine below the crests
constexpr double greatestTilt = 40.0;    // mm between the heights of the crests
constexpr std::array<double, 2> crestsApart{ 120.0, 360.0 };   // mm
constexpr std::array<double, 2> promontoryBelow{ 10.0, 80.0 }; // mm below the crests; 68 and 60 mm in two patients
/** Weight of height against depth for the promontory: the lumbar spine rises more steeply, the sacrum recedes more.
 * With weights from 0.6 to 1, the promontory moves by less than 5 mm in two patients. */
constexpr double weightOfHeight = 0.7;

/** A CT averaged over cubic cells aligned with the axes of the patient. */
class PelvicCells
{
public:
  explicit PelvicCells(const itk::Image<float, 3> * ct)
  {
    const auto spacing = ct->GetSpacing();
    m_Edge =
      std::max({ cellEdge, cellPerSpacing * spacing[0], cellPerSpacing * spacing[1], cellPerSpacing * spacing[2] });
    this->SetGrid(ct);
    this->Average(ct);
  }
  const VoxelGrid &
  Grid() const
  {
    return m_Grid;
  }
  double
  Edge() const
  {
    return m_Edge;
  }
  float
  Value(std::size_t cell) const
  {
    return m_Values[cell];
  }
  Vector3d
  Center(std::size_t cell) const
  {
    const auto voxel = m_Grid.Voxel(cell);
    return m_Low + m_Edge * (Vector3d(voxel[0], voxel[1], voxel[2]).array() + 0.5).matrix();
  }
  /** Upper end of the image, mm. */
  double
  Top() const
  {
    return m_Low.z() + m_Edge * m_Grid.size[2];
  }
  /** z (mm) of the centers of a layer. */
  double
  HeightOf(int layer) const
  {
    return m_Low.z() + m_Edge * (layer + 0.5);
  }
  int
  LayerOf(double z) const
  {
    return static_cast<int>(std::floor((z - m_Low.z()) / m_Edge));
  }

private:
  static Vector3d
  PointOf(const itk::Image<float, 3> * ct, const itk::Index<3> & index)
  {
    itk::Point<double, 3> point;
    ct->TransformIndexToPhysicalPoint(index, point);
    return { point[0], point[1], point[2] };
  }

  void
  SetGrid(const itk::Image<float, 3> * ct)
  {
    const auto region = ct->GetBufferedRegion();
    Vector3d   high = Vector3d::Constant(std::numeric_limits<double>::lowest());
    m_Low = -high;
    for (int corner = 0; corner < 8; ++corner)
    {
      itk::Index<3> index = region.GetIndex();
      for (int a = 0; a < 3; ++a)
      {
        index[a] += (corner >> a) % 2 * (static_cast<itk::IndexValueType>(region.GetSize(a)) - 1);
      }
      const Vector3d point = PointOf(ct, index);
      m_Low = m_Low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    const Vector3i size = ((high - m_Low) / m_Edge).array().floor().cast<int>() + 1;
    m_Grid.SetSize({ { size[0], size[1], size[2] } });
  }

  void
  Average(const itk::Image<float, 3> * ct)
  {
    std::vector<double> sums(m_Grid.NumberOfVoxels(), 0.0);
    std::vector<int>    samples(m_Grid.NumberOfVoxels(), 0);
    const auto          region = ct->GetBufferedRegion();
    std::array<int, 3>  step{};
    for (int a = 0; a < 3; ++a)
    {
      step[a] = std::max(1, static_cast<int>(sampleDistance / ct->GetSpacing()[a]));
    }
    itk::Index<3> index;
    const auto    low = region.GetIndex();
    const auto    high = region.GetUpperIndex();
    for (index[2] = low[2]; index[2] <= high[2]; index[2] += step[2])
    {
      for (index[1] = low[1]; index[1] <= high[1]; index[1] += step[1])
      {
        for (index[0] = low[0]; index[0] <= high[0]; index[0] += step[0])
        {
          const Vector3i    at = ((PointOf(ct, index) - m_Low) / m_Edge).array().floor().cast<int>();
          const std::size_t cell = m_Grid.Index(at[0], at[1], at[2]);
          sums[cell] += ct->GetPixel(index);
          ++samples[cell];
        }
      }
    }
    m_Values.assign(sums.size(), outside);
    for (std::size_t cell = 0; cell < sums.size(); ++cell)
    {
      m_Values[cell] = samples[cell] > 0 ? static_cast<float>(sums[cell] / samples[cell]) : outside;
    }
  }

  VoxelGrid          m_Grid;
  Vector3d           m_Low;
  double             m_Edge;
  std::vector<float> m_Values;
};

using CellSet = std::vector<std::size_t>;

/** The largest connected part of the bone cells selected by their distance from the midline (mm, to the left). */
CellSet
LargestBone(const PelvicCells & cells, double midline, const std::function<bool(double)> & isSelected)
{
  const VoxelGrid & grid = cells.Grid();
  const auto        isBone = [&](std::size_t cell) {
    return cells.Value(cell) >= leastBone && isSelected(cells.Center(cell).x() - midline);
  };
  const VoxelRuns      runs = CollectRuns(grid, isBone);
  const RunLabels      labels = LabelRuns(runs);
  std::vector<CellSet> bones(labels.number + 1);
  ForEachRun(runs, [&](std::size_t r, int j, int k) {
    for (int i = runs.runs[r].begin; i < runs.runs[r].end; ++i)
    {
      bones[labels.ofRun[r]].push_back(grid.Index(i, j, k));
    }
  });
  return *std::max_element(
    bones.begin(), bones.end(), [](const CellSet & one, const CellSet & other) { return one.size() < other.size(); });
}

/** Fraction of the neighbors of a set that contain gas. */
double
ContactWithGas(const PelvicCells & cells, const CellSet & set)
{
  int gas = 0;
  int all = 0;
  for (const std::size_t cell : set)
  {
    ForEachNeighbor(cells.Grid(), cell, [&](std::size_t other) {
      all += !std::binary_search(set.begin(), set.end(), other);
      gas += cells.Value(other) < greatestGas;
    });
  }
  return static_cast<double>(gas) / std::max(all, 1);
}

/** x (mm) of the center of the body. */
double
MiddleOfBody(const PelvicCells & cells)
{
  double sum = 0.0;
  int    number = 0;
  for (std::size_t cell = 0; cell < cells.Grid().NumberOfVoxels(); ++cell)
  {
    if (cells.Value(cell) > leastBody)
    {
      sum += cells.Center(cell).x();
      ++number;
    }
  }
  return sum / std::max(number, 1);
}

/** Mean of the highest cells in a set, which is in ascending order. */
Vector3d
TopOf(const PelvicCells & cells, const CellSet & set)
{
  const double top = cells.Center(set.back()).z();
  Vector3d     sum = Vector3d::Zero();
  int          number = 0;
  for (auto cell = set.rbegin(); cell != set.rend() && cells.Center(*cell).z() == top; ++cell)
  {
    sum += cells.Center(*cell);
    ++number;
  }
  return sum / number;
}

bool
IsBetween(double value, const std::array<double, 2> & range)
{
  return value >= range[0] && value <= range[1];
}

/** The crest of a hip bone; empty if the set is not a hip bone. */
std::optional<Vector3d>
CrestOf(const PelvicCells & cells, const CellSet & hip)
{
  const double volume = std::pow(cells.Edge(), 3) * static_cast<double>(hip.size());
  if (volume < leastHip || ContactWithGas(cells, hip) > greatestContact)
  {
    return std::nullopt;
  }
  const Vector3d crest = TopOf(cells, hip);
  const double   height = crest.z() - cells.Center(hip.front()).z();
  return height >= leastHipHeight && crest.z() + leastAbove <= cells.Top() ? std::optional(crest) : std::nullopt;
}

/** y (mm) of the cells of the spine in the median plane, for each layer upward from the bottom of the image. */
std::vector<std::vector<double>>
MedianBone(const PelvicCells & cells, const CellSet & spine, double middle)
{
  std::vector<std::vector<double>> layers(cells.Grid().size[2]);
  for (const std::size_t cell : spine)
  {
    const Vector3d point = cells.Center(cell);
    if (std::abs(point.x() - middle) <= halfPromontory)
    {
      layers[cells.Grid().Voxel(cell)[2]].push_back(point.y());
    }
  }
  return layers;
}

/** The most anterior y (mm) of a layer that is not anterior to the limit. */
std::optional<double>
FrontBehind(const std::vector<double> & layer, double limit)
{
  std::optional<double> front;
  for (const double y : layer)
  {
    front = y >= limit && (!front || y < *front) ? y : front;
  }
  return front;
}

/** Median front edge of the lumbar spine above the crests. */
double
FrontAbove(const std::vector<std::vector<double>> & layers, int crest, int number)
{
  std::vector<double> fronts;
  for (int k = crest; k < std::min(crest + number, static_cast<int>(layers.size())); ++k)
  {
    const auto front = FrontBehind(layers[k], std::numeric_limits<double>::lowest());
    fronts.insert(fronts.end(), front ? 1 : 0, front.value_or(0.0));
  }
  return fronts.empty() ? std::numeric_limits<double>::lowest() : UpperMedian(std::move(fronts));
}

/** The most prominent point of the front edge of the spine, followed downward from the crests. Bowel with contrast
 * agent may touch the sacrum, so the edge is at most one cell anterior to that of the last layers. */
std::optional<Vector3d>
MostProminent(const PelvicCells & cells, const std::vector<std::vector<double>> & layers, const Vector3d & middle)
{
  constexpr int           last = 3; // layers; vertebrae with little bone have gaps
  const int               crest = cells.LayerOf(middle.z());
  std::vector<double>     edge(1, FrontAbove(layers, crest, static_cast<int>(lumbarHeight / cells.Edge())));
  std::optional<Vector3d> best;
  const auto              prominence = [](const Vector3d & p) { return -p.y() - weightOfHeight * p.z(); };
  for (int k = crest; k >= 0; --k)
  {
    const double limit = *std::min_element(edge.end() - std::min<long>(last, edge.size()), edge.end()) - cells.Edge();
    if (const auto front = FrontBehind(layers[k], limit))
    {
      edge.push_back(*front);
      const Vector3d point(middle.x(), *front, cells.HeightOf(k));
      const bool     isThere = IsBetween(middle.z() - point.z(), promontoryBelow);
      best = isThere && (!best || prominence(point) > prominence(*best)) ? point : best;
    }
  }
  return best;
}

/** \param middle x of the midline, mean z of the crests. */
std::optional<Vector3d>
FindPromontory(const PelvicCells & cells, const Vector3d & middle)
{
  const CellSet spine = LargestBone(cells, middle.x(), [](double lateral) { return std::abs(lateral) <= halfSpine; });
  const bool    isInView = !spine.empty() && cells.Center(spine.back()).z() >= middle.z() &&
                        cells.Center(spine.front()).z() <= middle.z() - leastBelow;
  return isInView ? MostProminent(cells, MedianBone(cells, spine, middle.x()), middle) : std::nullopt;
}

bool
ReachesBehind(const PelvicCells & cells, const CellSet & hip, double y)
{
  return std::any_of(hip.begin(), hip.end(), [&](std::size_t cell) { return cells.Center(cell).y() >= y; });
}
} // namespace

std::optional<Pelvis>
FindPelvis(const itk::Image<float, 3> * ct)
{
  const PelvicCells cells(ct);
  const double      middle = MiddleOfBody(cells);
  const CellSet     left = LargestBone(cells, middle, [](double lateral) { return lateral > besideSpine; });
  const CellSet     right = LargestBone(cells, middle, [](double lateral) { return lateral < -besideSpine; });
  const auto        leftCrest = CrestOf(cells, left);
  const auto        rightCrest = CrestOf(cells, right);
  if (!leftCrest || !rightCrest || std::abs(leftCrest->z() - rightCrest->z()) > greatestTilt ||
      !IsBetween(leftCrest->x() - rightCrest->x(), crestsApart))
  {
    return std::nullopt;
  }
  const auto promontory = FindPromontory(cells, { middle, 0.0, 0.5 * (leftCrest->z() + rightCrest->z()) });
  if (!promontory || !ReachesBehind(cells, left, promontory->y() + leastBehind) ||
      !ReachesBehind(cells, right, promontory->y() + leastBehind))
  {
    return std::nullopt;
  }
  return Pelvis{ *leftCrest, *rightCrest, *promontory };
}

Pelvis
Mirrored(const Pelvis & pelvis)
{
  const auto mirror = [](const Vector3d & point) { return Vector3d(-point.x(), point.y(), point.z()); };
  return { mirror(pelvis.rightCrest), mirror(pelvis.leftCrest), mirror(pelvis.promontory) };
}
} // namespace shapeton
