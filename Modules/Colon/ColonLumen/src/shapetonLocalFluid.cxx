#include "shapetonLocalFluid.h"

#include "shapetonParallelFor.h"

#include <cmath>

namespace shapeton
{
namespace
{
/** Binomial smoothing 1 2 1 of a line in place, nothing beyond its ends. */
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
                       const std::vector<float> &         hu,
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
LocalFluid::Accumulate(const ColonGrid & grid, const std::vector<float> & hu, const std::vector<unsigned char> & fluid)
{
  std::array<int, 3> deep;
  for (int a = 0; a < 3; ++a)
  {
    deep[a] = static_cast<int>(std::ceil(2.0 / grid.spacing[a] - 1e-6));
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
    for (int pass = 0; pass < 5; ++pass)
    {
      for (int z = 0; z < m_Size[2]; ++z)
      {
        for (int y = 0; y < m_Size[1]; ++y)
        {
          SmoothCells(&(*values)[this->Cell(0, y, z)], 1, m_Size[0]);
        }
        for (int x = 0; x < m_Size[0]; ++x)
        {
          SmoothCells(&(*values)[this->Cell(x, 0, z)], m_Size[0], m_Size[1]);
        }
      }
      for (int y = 0; y < m_Size[1]; ++y)
      {
        for (int x = 0; x < m_Size[0]; ++x)
        {
          SmoothCells(&(*values)[this->Cell(x, y, 0)], this->Cell(0, 0, 1), m_Size[2]);
        }
      }
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
} // namespace shapeton
