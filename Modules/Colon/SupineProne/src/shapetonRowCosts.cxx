#include "shapetonRowCosts.h"

#include "shapetonParallelFor.h"

#include <algorithm>

namespace shapeton
{
namespace
{
constexpr double costOutside = 8.0; ///< cost of a row beyond the end of the target or of its segment

/** Mean product of a with b cyclically shifted back by `shift` >= 0 columns. */
double
ProductOf(const Eigen::RowVectorXd & a, const Eigen::RowVectorXd & b, Eigen::Index shift)
{
  const Eigen::Index rest = a.size() - shift;
  return (a.head(rest).dot(b.tail(rest)) + a.tail(shift).dot(b.head(shift))) / static_cast<double>(a.size());
}
} // namespace

RowCosts::RowCosts(const CylinderPicture &           source,
                   const CylinderPicture &           target,
                   int                               reach,
                   const CylindricalWarpingOptions & options)
  : m_Source(source), m_Target(target), m_Options(options), m_Reach(reach)
{
  m_HasTaeniae = options.taeniaWeight > 0.0 && source.taeniae.size() > 0 && target.taeniae.size() > 0;
}

std::vector<float>
RowCosts::OfRow(int row, int firstRotation, int rotations) const
{
  const int                offsets = 2 * m_Reach + 1;
  const int                angles = m_Source.Angles();
  std::vector<float>       cost(static_cast<std::size_t>(offsets) * rotations);
  const Eigen::RowVectorXd folds = m_Source.values.row(row);
  const Eigen::RowVectorXd taeniae = m_HasTaeniae ? m_Source.taeniae.row(row) : folds;
  ParallelFor(offsets, [&](std::size_t offset) {
    const int    j = 2 * row + static_cast<int>(offset) - m_Reach;
    const double spring = this->SpringOf(static_cast<int>(offset));
    float *      out = cost.data() + offset * rotations;
    if (j < 0 || j >= m_Target.Rows() || this->SegmentOf(m_Source, row) != this->SegmentOf(m_Target, j))
    {
      std::fill(out, out + rotations, static_cast<float>(costOutside));
      return;
    }
    if (m_Source.isExcluded[row] || m_Target.isExcluded[j])
    {
      std::fill(out, out + rotations, static_cast<float>(spring));
      return;
    }
    const Eigen::RowVectorXd targetFolds = m_Target.values.row(j);
    const Eigen::RowVectorXd targetTaeniae = m_HasTaeniae ? m_Target.taeniae.row(j) : targetFolds;
    const double content = m_Options.contentWeight * (folds.squaredNorm() + targetFolds.squaredNorm()) / angles;
    for (int rotation = 0; rotation < rotations; ++rotation)
    {
      const int shift = (((firstRotation + rotation) % angles) + angles) % angles;
      double    product = ProductOf(folds, targetFolds, shift);
      product += m_HasTaeniae ? m_Options.taeniaWeight * ProductOf(taeniae, targetTaeniae, shift) : 0.0;
      out[rotation] = static_cast<float>(spring + content - product);
    }
  });
  return cost;
}

double
RowCosts::SpringOf(int offset) const
{
  const double away = (offset - m_Reach) * m_Target.step / m_Options.frameDeviation;
  return m_Options.springWeight * away * away;
}

int
RowCosts::SegmentOf(const CylinderPicture & picture, int row) const
{
  const double place = picture.begin + row * picture.step;
  return static_cast<int>(
    std::count_if(m_Options.breaks.begin(), m_Options.breaks.end(), [place](double at) { return place > at; }));
}
} // namespace shapeton
