#include "ConventionalHeat.h"

#include "shapetonHeatDiffusionSolver.h"
#include "shapetonParallelFor.h"

#include <algorithm>

using namespace shapeton;

namespace
{
/** Heat of one source in the box that it has reached. */
class SingleSource
{
public:
  explicit SingleSource(const VolumeGradientOperator & volumeGradient)
    : m_VolumeGradient(volumeGradient), m_Heat(volumeGradient.GetGrid().GetLength(), 0.0), m_Next(m_Heat)
  {}

  void
  Start(const std::array<std::size_t, 3> & source)
  {
    this->Clear();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_First[axis] = static_cast<std::ptrdiff_t>(source[axis]);
      m_Last[axis] = m_First[axis];
    }
    m_Heat[m_VolumeGradient.GetGrid().GetRow(m_First[1], m_First[2]) + source[0]] = 1.0;
  }

  void
  Step()
  {
    const auto & grid = m_VolumeGradient.GetGrid();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      m_First[axis] = std::max<std::ptrdiff_t>(0, m_First[axis] - 1);
      m_Last[axis] = std::min<std::ptrdiff_t>(grid.GetSize()[axis] - 1, m_Last[axis] + 1);
    }
    this->ForBox([&](std::size_t i) {
      double flow = 0.0;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        const std::size_t   stride = grid.GetStride(axis);
        const float * const c = m_VolumeGradient.GetConductances(axis);
        flow += c[i] * (m_Heat[i + stride] - m_Heat[i]) + c[i - stride] * (m_Heat[i - stride] - m_Heat[i]);
      }
      m_Next[i] = m_Heat[i] + HeatDiffusionSolver::MaximumTimeStepLength * flow;
    });
    std::swap(m_Heat, m_Next);
  }

  /** Sum of products of the current heat and the heat one step before. */
  double
  ProductWithPrevious()
  {
    double sum = 0.0;
    this->ForBox([&](std::size_t i) { sum += m_Heat[i] * m_Next[i]; });
    return sum;
  }

  double
  SquaredNorm()
  {
    double sum = 0.0;
    this->ForBox([&](std::size_t i) { sum += m_Heat[i] * m_Heat[i]; });
    return sum;
  }

private:
  template <typename TBody>
  void
  ForBox(const TBody & body)
  {
    for (std::ptrdiff_t z = m_First[2]; z <= m_Last[2]; ++z)
    {
      for (std::ptrdiff_t y = m_First[1]; y <= m_Last[1]; ++y)
      {
        const std::size_t row = m_VolumeGradient.GetGrid().GetRow(y, z);
        for (std::ptrdiff_t x = m_First[0]; x <= m_Last[0]; ++x)
        {
          body(row + static_cast<std::size_t>(x));
        }
      }
    }
  }

  void
  Clear()
  {
    this->ForBox([this](std::size_t i) { m_Heat[i] = m_Next[i] = 0.0; });
  }

  const VolumeGradientOperator & m_VolumeGradient;
  std::vector<double>            m_Heat;
  std::vector<double>            m_Next;
  std::array<std::ptrdiff_t, 3>  m_First{ { 0, 0, 0 } };
  std::array<std::ptrdiff_t, 3>  m_Last{ { -1, -1, -1 } };
};
} // namespace

std::vector<float>
ConventionalHeat(const VolumeGradientOperator & volumeGradient, std::uint64_t timeSteps)
{
  const auto &              size = volumeGradient.GetGrid().GetSize();
  std::vector<float>        heat(size[0] * size[1] * size[2]);
  std::vector<SingleSource> sources(NumberOfThreads(), SingleSource(volumeGradient));
  ParallelForWorkers(size[1] * size[2], [&](std::size_t row, unsigned int worker) {
    for (std::size_t x = 0; x < size[0]; ++x)
    {
      // P = 1 - dt L is symmetric: e' P^(2k) e = |P^k e|^2, so half of the steps suffice.
      SingleSource & source = sources[worker];
      source.Start({ x, row % size[1], row / size[1] });
      for (std::uint64_t step = 0; step < (timeSteps + 1) / 2; ++step)
      {
        source.Step();
      }
      const double rest = timeSteps % 2 == 0 ? source.SquaredNorm() : source.ProductWithPrevious();
      heat[row * size[0] + x] = static_cast<float>(rest);
    }
  });
  return heat;
}
