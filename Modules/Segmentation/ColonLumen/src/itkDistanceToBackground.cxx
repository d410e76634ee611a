#include "itkDistanceToBackground.h"

#include "itkParallelFor.h"

#include <limits>

namespace itk
{
namespace
{
constexpr float Far = 1e12F;

/** min over q of f(q) + ((p - q) spacing)^2 for all p of one line, in place. */
class LineTransform
{
public:
  LineTransform(int length, double spacing)
    : m_SquareSpacing(spacing * spacing), m_Values(length), m_Vertex(length), m_Begin(length + 1)
  {}

  void
  Apply(float * line, std::size_t stride)
  {
    const int length = static_cast<int>(m_Values.size());
    for (int p = 0; p < length; ++p)
    {
      m_Values[p] = line[p * stride];
    }
    if (this->BuildEnvelope())
    {
      this->Evaluate(line, stride);
    }
  }

private:
  double
  Crossing(int q, int r) const
  {
    return 0.5 * ((m_Values[q] - m_Values[r]) / (m_SquareSpacing * (q - r)) + q + r);
  }

  bool
  BuildEnvelope()
  {
    m_Last = -1;
    for (int q = 0; q < static_cast<int>(m_Values.size()); ++q)
    {
      if (m_Values[q] >= Far)
      {
        continue;
      }
      while (m_Last >= 0 && this->Crossing(q, m_Vertex[m_Last]) <= m_Begin[m_Last])
      {
        --m_Last;
      }
      m_Begin[m_Last + 1] = m_Last < 0 ? -std::numeric_limits<double>::infinity() : this->Crossing(q, m_Vertex[m_Last]);
      m_Vertex[++m_Last] = q;
    }
    return m_Last >= 0;
  }

  void
  Evaluate(float * line, std::size_t stride) const
  {
    int k = 0;
    for (int p = 0; p < static_cast<int>(m_Values.size()); ++p)
    {
      while (k < m_Last && m_Begin[k + 1] < p)
      {
        ++k;
      }
      const double d = p - m_Vertex[k];
      line[p * stride] = static_cast<float>(m_Values[m_Vertex[k]] + d * d * m_SquareSpacing);
    }
  }

  double              m_SquareSpacing;
  std::vector<double> m_Values;
  std::vector<int>    m_Vertex;
  std::vector<double> m_Begin;
  int                 m_Last{ -1 };
};
} // namespace

std::vector<float>
SquaredDistanceToBackground(const ColonGrid & grid, const std::vector<unsigned char> & mask)
{
  std::vector<float> d(mask.size());
  ParallelFor(grid.size[2], [&](std::size_t k) {
    LineTransform alongX(grid.size[0], grid.spacing[0]);
    LineTransform alongY(grid.size[1], grid.spacing[1]);
    float *       slice = &d[k * grid.stride[2]];
    for (std::size_t p = 0; p < grid.stride[2]; ++p)
    {
      slice[p] = mask[k * grid.stride[2] + p] ? Far : 0.0F;
    }
    for (int j = 0; j < grid.size[1]; ++j)
    {
      alongX.Apply(slice + j * grid.stride[1], 1);
    }
    for (int i = 0; i < grid.size[0]; ++i)
    {
      alongY.Apply(slice + i, grid.stride[1]);
    }
  });
  ParallelFor(grid.size[1], [&](std::size_t j) {
    LineTransform alongZ(grid.size[2], grid.spacing[2]);
    for (int i = 0; i < grid.size[0]; ++i)
    {
      alongZ.Apply(&d[i + j * grid.stride[1]], grid.stride[2]);
    }
  });
  return d;
}
} // namespace itk
