#include "shapetonBodySampler.h"

#include "shapetonForEachCell.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using CellIndex = std::array<int, 3>;

constexpr double widestCell = 0.82; // mm
constexpr double leastBlur = 0.05;  // cells; standard deviations up to this are not blurred
constexpr double blurReach = 3.5;   // standard deviations at which the weights of the blur end

std::size_t
NumberOf(const CellIndex & size)
{
  return static_cast<std::size_t>(size[0]) * size[1] * size[2];
}

// Blurs an array [outer][length][inner] along the middle axis and subsamples by `step`.
std::vector<float>
BlurAxis(const std::vector<float> & in,
         std::size_t                outer,
         int                        length,
         std::size_t                inner,
         int                        step,
         const std::vector<float> & weights,
         int                        results)
{
  std::vector<float> out(outer * results * inner, 0.0F);
  for (std::size_t o = 0; o < outer; ++o)
  {
    for (int r = 0; r < results; ++r)
    {
      float * const       target = &out[(o * results + r) * inner];
      const float * const source = &in[(o * length + static_cast<std::size_t>(r) * step) * inner];
      for (std::size_t k = 0; k < weights.size(); ++k)
      {
        const float         weight = weights[k];
        const float * const line = source + k * inner;
        for (std::size_t i = 0; i < inner; ++i)
        {
          target[i] += weight * line[i];
        }
      }
    }
  }
  return out;
}
} // namespace

// The cells of a region, with the margin required by the blur.
class BodySampler::Canvas
{
public:
  Canvas(const BodySampler & sampler, const CellIndex & first, const CellIndex & size)
    : m_Sampler(sampler)
    , m_First(first)
    , m_Size(size)
    , m_Values(NumberOf(size))
    , m_CellWidth((sampler.m_Axes[0].width + sampler.m_Axes[1].width + sampler.m_Axes[2].width) / 3.0)
  {
    for (const auto & body : sampler.m_Bodies)
    {
      m_Stack.push_back(body.get());
    }
  }

  std::vector<float>
  Paint()
  {
    this->PaintBlock({ { 0, 0, 0 } }, m_Size, 0);
    return std::move(m_Values);
  }

private:
  PointType
  CenterOf(const CellIndex & first, const CellIndex & size) const
  {
    PointType point = m_Sampler.m_FirstCell;
    for (unsigned int i = 0; i < 3; ++i)
    {
      point += m_Sampler.m_Steps[i] * (m_First[i] + first[i] + 0.5 * (size[i] - 1));
    }
    return point;
  }

  // Bounding radius of the cells of the block and the ramps of their faces.
  double
  RadiusOf(const CellIndex & size) const
  {
    double squared = 0.0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double half = 0.5 * size[i] * m_Sampler.m_Axes[i].width;
      squared += half * half;
    }
    constexpr double forRounding = 1.001;
    return forRounding * std::sqrt(squared) + 0.5 * m_CellWidth;
  }

  template <typename TValue>
  void
  Fill(const CellIndex & first, const CellIndex & size, const TValue & valueAt)
  {
    const CellIndex end{ { first[0] + size[0], first[1] + size[1], first[2] + size[2] } };
    ForEachCell(first, end, 1, [&](const CellIndex & cell) {
      m_Values[(static_cast<std::size_t>(cell[2]) * m_Size[1] + cell[1]) * m_Size[0] + cell[0]] = valueAt(cell);
    });
  }

  // Pushes the bodies from `begin` that may affect the block, except completely covered ones; returns true if the block
  // is inside at most one body, away from its faces.
  bool
  SelectBodies(const PointType & center, double radius, std::size_t begin, bool & textured)
  {
    const std::size_t end = m_Stack.size();
    bool              uniform = true;
    textured = false;
    for (std::size_t i = end; i > begin; --i)
    {
      const PhantomBody * const body = m_Stack[i - 1];
      const BodyProbe           probe = body->Probe(center);
      if (probe.distance > radius)
      {
        continue;
      }
      const bool covers = probe.distance < -radius;
      uniform = m_Stack.size() == end && covers && probe.clearance > radius;
      textured = probe.textured;
      m_Stack.push_back(body);
      if (covers)
      {
        break;
      }
    }
    std::reverse(m_Stack.begin() + static_cast<std::ptrdiff_t>(end), m_Stack.end());
    return uniform;
  }

  void
  PaintBlock(const CellIndex & first, const CellIndex & size, std::size_t begin)
  {
    if (NumberOf(size) == 1)
    {
      this->PaintCell(first, begin);
      return;
    }
    const std::size_t end = m_Stack.size();
    bool              textured = false;
    const PointType   center = this->CenterOf(first, size);
    if (this->SelectBodies(center, this->RadiusOf(size), begin, textured))
    {
      this->FillUniform(first, size, center, m_Stack.size() > end ? m_Stack.back() : nullptr, textured);
    }
    else
    {
      this->PaintHalves(first, size, end);
    }
    m_Stack.resize(end);
  }

  void
  PaintHalves(const CellIndex & first, const CellIndex & size, std::size_t begin)
  {
    const auto axis = std::max_element(size.begin(), size.end()) - size.begin();
    CellIndex  lower = size;
    lower[axis] = (size[axis] + 1) / 2;
    this->PaintBlock(first, lower, begin);
    CellIndex upper = size;
    upper[axis] -= lower[axis];
    CellIndex middle = first;
    middle[axis] += lower[axis];
    this->PaintBlock(middle, upper, begin);
  }

  void
  FillUniform(const CellIndex &   first,
              const CellIndex &   size,
              const PointType &   center,
              const PhantomBody * body,
              bool                textured)
  {
    if (body != nullptr && textured)
    {
      this->Fill(first, size, [&](const CellIndex & cell) {
        return static_cast<float>(body->Intensity(this->CenterOf(cell, { { 1, 1, 1 } })));
      });
      return;
    }
    const auto value = static_cast<float>(body == nullptr ? m_Sampler.m_Background : body->Intensity(center));
    this->Fill(first, size, [value](const CellIndex &) { return value; });
  }

  void
  PaintCell(const CellIndex & cell, std::size_t begin)
  {
    const CellIndex one{ { 1, 1, 1 } };
    const PointType center = this->CenterOf(cell, one);
    double          value = m_Sampler.m_Background;
    for (std::size_t i = begin; i < m_Stack.size(); ++i)
    {
      m_Stack[i]->Paint(center, m_CellWidth, value);
    }
    this->Fill(cell, one, [value](const CellIndex &) { return static_cast<float>(value); });
  }

  const BodySampler &              m_Sampler;
  CellIndex                        m_First;
  CellIndex                        m_Size;
  std::vector<float>               m_Values;
  double                           m_CellWidth;
  std::vector<const PhantomBody *> m_Stack; // the relevant bodies at each depth of the recursion
};

BodySampler::BodySampler(PhantomBodies                 bodies,
                         const itk::ImageBase<3> *     grid,
                         const std::array<double, 3> & blur,
                         double                        background)
  : m_Bodies(std::move(bodies)), m_Background(background)
{
  itk::ContinuousIndex<double, 3> first;
  for (unsigned int i = 0; i < 3; ++i)
  {
    m_Axes[i] = MakeAxis(grid->GetSpacing()[i], blur[i]);
    first[i] = 0.5 / m_Axes[i].cells - 0.5;
    for (unsigned int j = 0; j < 3; ++j)
    {
      m_Steps[i][j] = grid->GetDirection()(j, i) * m_Axes[i].width;
    }
  }
  grid->TransformContinuousIndexToPhysicalPoint(first, m_FirstCell);
}

// The blur includes the voxel width; variances are additive.
BodySampler::Axis
BodySampler::MakeAxis(double spacing, double blur)
{
  Axis axis;
  axis.cells = std::clamp(static_cast<int>(std::ceil(spacing / widestCell)), 1, 3);
  axis.width = spacing / axis.cells;
  const double variance = blur * blur - spacing * spacing / 12.0;
  const double sigma = variance > 0.0 ? std::sqrt(variance) / axis.width : 0.0;
  axis.margin = sigma > leastBlur ? static_cast<int>(std::ceil(blurReach * sigma)) : 0;
  std::vector<double> weights(axis.cells + 2 * axis.margin, 0.0);
  double              sum = 0.0;
  for (int cell = 0; cell < axis.cells; ++cell)
  {
    for (int k = -axis.margin; k <= axis.margin; ++k)
    {
      const double weight = k == 0 ? 1.0 : std::exp(-0.5 * k * k / (sigma * sigma));
      weights[cell + axis.margin + k] += weight;
      sum += weight;
    }
  }
  for (const double weight : weights)
  {
    axis.weights.push_back(static_cast<float>(weight / sum));
  }
  return axis;
}

std::vector<float>
BodySampler::Sample(const RegionType & region) const
{
  CellIndex first;
  CellIndex size;
  for (unsigned int i = 0; i < 3; ++i)
  {
    first[i] = static_cast<int>(region.GetIndex(i)) * m_Axes[i].cells - m_Axes[i].margin;
    size[i] = static_cast<int>(region.GetSize(i)) * m_Axes[i].cells + 2 * m_Axes[i].margin;
  }
  std::vector<float> values = Canvas(*this, first, size).Paint();
  const auto         x = static_cast<int>(region.GetSize(0));
  const auto         y = static_cast<int>(region.GetSize(1));
  const auto         z = static_cast<int>(region.GetSize(2));
  const auto         plane = static_cast<std::size_t>(size[0]) * size[1];
  values = BlurAxis(values, 1, size[2], plane, m_Axes[2].cells, m_Axes[2].weights, z);
  values = BlurAxis(values, z, size[1], size[0], m_Axes[1].cells, m_Axes[1].weights, y);
  return BlurAxis(values, static_cast<std::size_t>(z) * y, size[0], 1, m_Axes[0].cells, m_Axes[0].weights, x);
}
} // namespace shapeton
