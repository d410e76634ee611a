#include "shapetonAirFluidInterface.h"

#include "shapetonParallelFor.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** In-place binomial smoothing (1 2 1) of a line; zero beyond its ends. */
void
SmoothCells(float * line, std::size_t stride, int length)
{
  float before = 0.0F;
  for (int p = 0; p < length; ++p)
  {
    const float here = line[p * stride];
    const float after = p + 1 < length ? line[(p + 1) * stride] : 0.0F;
    line[p * stride] = 0.25F * before + 0.5F * here + 0.25F * after;
    before = here;
  }
}
} // namespace

LocalFluid::LocalFluid(const ColonGrid &                  grid,
                       const VoxelValues &                hu,
                       const std::vector<unsigned char> & fluid,
                       double                             fallback)
  : m_Fallback(fallback)
{
  for (int a = 0; a < 3; ++a)
  {
    m_Edge[a] = std::max(1, static_cast<int>(std::lround(2.0 / grid.spacing[a])));
    m_Size[a] = (grid.size[a] + m_Edge[a] - 1) / m_Edge[a];
  }
  m_Sum.assign(this->Cell(0, 0, m_Size[2]), 0.0F);
  m_Weight = m_Sum;
  this->Accumulate(grid, hu, fluid);
  this->Spread();
}

void
LocalFluid::Accumulate(const ColonGrid & grid, const VoxelValues & hu, const std::vector<unsigned char> & fluid)
{
  std::array<int, 3> deep;
  for (int a = 0; a < 3; ++a)
  {
    constexpr double depth = 2.0, rounding = 1e-6; // mm, voxels
    deep[a] = static_cast<int>(std::ceil(depth / grid.spacing[a] - rounding));
  }
  ParallelFor(m_Size[2], [&](std::size_t z) {
    for (int k = std::max<int>(z * m_Edge[2], deep[2]); k < std::min<int>((z + 1) * m_Edge[2], grid.size[2] - deep[2]);
         ++k)
    {
      for (int j = deep[1]; j < grid.size[1] - deep[1]; ++j)
      {
        for (int i = deep[0]; i < grid.size[0] - deep[0]; ++i)
        {
          const auto p = grid.Index(i, j, k);
          bool       isDeep = fluid[p] != 0;
          for (int a = 0; a < 3 && isDeep; ++a)
          {
            isDeep = fluid[p - deep[a] * grid.stride[a]] && fluid[p + deep[a] * grid.stride[a]];
          }
          if (isDeep)
          {
            const auto cell = this->Cell(i / m_Edge[0], j / m_Edge[1], static_cast<int>(z));
            m_Sum[cell] += hu[p];
            m_Weight[cell] += 1.0F;
          }
        }
      }
    }
  });
}

void
LocalFluid::Spread()
{
  for (auto * values : { &m_Sum, &m_Weight })
  {
    constexpr int passes = 5; // a Gaussian of 1.6 cells of 2 mm with a reach of 5 cells; chosen to bridge gaps of 1 cm
    for (int pass = 0; pass < passes; ++pass)
    {
      ParallelFor(m_Size[2], [&](std::size_t slice) {
        const int z = static_cast<int>(slice);
        for (int y = 0; y < m_Size[1]; ++y)
        {
          SmoothCells(&(*values)[this->Cell(0, y, z)], 1, m_Size[0]);
        }
        for (int x = 0; x < m_Size[0]; ++x)
        {
          SmoothCells(&(*values)[this->Cell(x, 0, z)], m_Size[0], m_Size[1]);
        }
      });
      ParallelFor(m_Size[1], [&](std::size_t y) {
        for (int x = 0; x < m_Size[0]; ++x)
        {
          SmoothCells(&(*values)[this->Cell(x, static_cast<int>(y), 0)], this->Cell(0, 0, 1), m_Size[2]);
        }
      });
    }
  }
}

double
LocalFluid::At(int i, int j, int k) const
{
  const std::array<int, 3> voxel{ { i, j, k } };
  std::array<int, 3>       first;
  std::array<double, 3>    part;
  for (int a = 0; a < 3; ++a)
  {
    const double x = (voxel[a] + 0.5) / m_Edge[a] - 0.5;
    first[a] = static_cast<int>(std::floor(x));
    part[a] = x - first[a];
  }
  double sum = 0.0;
  double weight = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double             w = 1.0;
    std::array<int, 3> c;
    for (int a = 0; a < 3; ++a)
    {
      const int upper = (corner >> a) & 1;
      c[a] = std::min(std::max(first[a] + upper, 0), m_Size[a] - 1);
      w *= upper ? part[a] : 1.0 - part[a];
    }
    const auto cell = this->Cell(c[0], c[1], c[2]);
    sum += w * m_Sum[cell];
    weight += w * m_Weight[cell];
  }
  return weight > 1e-3 ? sum / weight : m_Fallback;
}

namespace
{
constexpr double Reach = 5.0;     // mm perpendicular to gravity; chosen
constexpr double Thickness = 4.0; // mm along gravity; chosen: beyond the blur of a level
constexpr double Sigma = 2.5;     // mm, of the weights perpendicular to gravity
/** Search interval for the blur of levels (mm), and bounds on the result (mm); half a step is added to the upper bound.
 * The blur is 0.9 mm in real levels and 0.75 mm in phantoms. */
constexpr double LowestBlur = 0.2;
constexpr double HighestBlur = 3.0;
constexpr double LeastBlur = 0.4;
constexpr double GreatestBlur = 1.5;
constexpr int    BisectionsOfBlur = 40;
} // namespace

LevelSurface::LevelSurface(const ColonGrid &                  grid,
                           const VoxelValues &                hu,
                           const std::vector<unsigned char> & labels,
                           const GravitySteps &               fall,
                           const LocalFluid &                 fluid,
                           double                             gas)
  : m_Grid(grid)
  , m_Fall(fall)
  , m_Cells({}, Reach)
  , m_Blur(std::sqrt(UsualBlur * UsualBlur + UniformVariance(fall.step)))
{
  this->Collect(hu, labels, fluid, gas);
  m_Cells = LateralCells(m_Places, Reach);
}

bool
LevelSurface::Crossing(const VoxelValues & hu, std::size_t voxel, double half, double & depth, double & rise) const
{
  const auto v = m_Grid.Voxel(voxel);
  float      above = 0.0F;
  for (int t = -2; t <= 3; ++t)
  {
    const auto o = m_Fall.Offset(t);
    if (!m_Grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
    {
      return false;
    }
    const float value = hu[m_Grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2])];
    if (t > -2 && above < half && value >= half)
    {
      depth = m_Grid.Position(voxel).dot(m_Fall.direction) + (t - 1 + (half - above) / (value - above)) * m_Fall.step;
      rise = value - above;
      return true;
    }
    above = value;
  }
  return false;
}

void
LevelSurface::Collect(const VoxelValues &                hu,
                      const std::vector<unsigned char> & labels,
                      const LocalFluid &                 fluid,
                      double                             gas)
{
  const auto          down = m_Fall.Offset(1);
  std::vector<double> rises;
  for (std::size_t p = 0; p < labels.size(); ++p)
  {
    if (labels[p] != 1)
    {
      continue;
    }
    const auto v = m_Grid.Voxel(p);
    if (!m_Grid.Holds(v[0] + down[0], v[1] + down[1], v[2] + down[2]) ||
        labels[m_Grid.Index(v[0] + down[0], v[1] + down[1], v[2] + down[2])] != 2)
    {
      continue;
    }
    const double f = fluid.At(v[0], v[1], v[2]);
    double       depth = 0.0;
    double       rise = 0.0;
    if (this->Crossing(hu, p, 0.5 * (gas + f), depth, rise))
    {
      const auto x = m_Grid.Position(p);
      m_Places.push_back({ static_cast<float>(x.dot(m_Fall.across[0])), static_cast<float>(x.dot(m_Fall.across[1])) });
      m_Depths.push_back(static_cast<float>(depth));
      rises.push_back(rise / (f - gas));
    }
  }
  this->MeasureBlur(rises);
}

void
LevelSurface::MeasureBlur(const std::vector<double> & shares)
{
  constexpr std::size_t leastRises = 50; // chosen: with fewer, the usual blur is kept
  if (shares.size() < leastRises)
  {
    return;
  }
  const double median = UpperMedian(shares);
  double       low = LowestBlur;
  double       high = HighestBlur;
  // Bisection for the sigma at which the rise over the step that contains the crossing equals the median. The crossing
  // is assumed to be a quarter of the way along the step, halfway between the extremes.
  for (int i = 0; i < BisectionsOfBlur; ++i)
  {
    const double sigma = 0.5 * (low + high);
    const double rise =
      NormalDistribution(0.75 * m_Fall.step / sigma) - NormalDistribution(-0.25 * m_Fall.step / sigma);
    (rise > median ? low : high) = sigma;
  }
  m_Blur = std::min(std::max(0.5 * (low + high), LeastBlur), GreatestBlur + 0.5 * m_Fall.step);
}

std::optional<double>
LevelSurface::HeightAbove(std::size_t voxel) const
{
  const auto   x = m_Grid.Position(voxel);
  const double a = x.dot(m_Fall.across[0]);
  const double b = x.dot(m_Fall.across[1]);
  const double depth = x.dot(m_Fall.direction);
  double       sum = 0.0;
  double       weight = 0.0;
  m_Cells.ForEachNear(a, b, [&](int i) {
    const double da = m_Places[i].a - a;
    const double db = m_Places[i].b - b;
    const double square = da * da + db * db;
    if (square <= Reach * Reach && std::abs(m_Depths[i] - depth) <= Thickness)
    {
      const double w = std::exp(-0.5 * square / (Sigma * Sigma));
      sum += w * (m_Depths[i] - depth);
      weight += w;
    }
  });
  return weight > 0.0 ? std::optional<double>(sum / weight) : std::nullopt;
}
} // namespace shapeton
