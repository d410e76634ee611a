#ifndef shapetonHeatAxis_h
#define shapetonHeatAxis_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatClasses.h"
#include "shapetonHeatHistogram.h"
#include "shapetonPicture.h"

#include <vector>

namespace shapeton
{
/** Layout of heats on the horizontal axis of a heat histogram (dissertation 2.3.1, Figure 2.3).
 * \ingroup ShapetonHeatViews */
enum class HeatScale
{
  /** Position by the cumulative count, so that every feature gets space. */
  Equalized,
  /** Position proportional to heat. */
  Normalized
};

/** The heats from lower to upper, 0 <= lower < upper <= 1. The default means all heats that occur.
 * \ingroup ShapetonHeatViews */
struct HeatRange
{
  double lower{ 0.0 };
  double upper{ 0.0 };
};

/** A one-row histogram whose classes have equal weight, so that its axis gives each class the same width. For densities
 * of shapetons, where the surroundings do not cool to the background and would occupy nearly all of the axis.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatHistogram
BalanceClasses(const HeatHistogram & histogram, std::size_t row, const std::vector<HeatClass> & classes);

/** \class HeatAxis
 * \brief Position of a heat on the axis of a heat histogram, and its color, consistent in all pictures of one result.
 *
 * The equalized axis is the map HeatHistogram::GetEqualization(), interpolated linearly inside a bin. A sub-range of
 * heats is re-equalized (the hierarchical histogram). If the range has no counts, all bins are equally wide.
 *
 * \ingroup ShapetonHeatViews
 */
class ShapetonHeatViews_EXPORT HeatAxis
{
public:
  /** Throws std::invalid_argument for a range that is neither the default nor valid. */
  explicit HeatAxis(const HeatHistogram & histogram,
                    HeatScale             scale = HeatScale::Equalized,
                    const HeatRange &     range = {});

  /** Position from 0 at the lower end to 1 at the upper end; heats beyond the ends are clamped. Nondecreasing in
   * heat. */
  double
  PositionOf(double heat) const;

  /** The smallest heat at this position in [0, 1]. */
  double
  HeatAt(double position) const;

  /** Color of a heat, of its line in the histogram, and of objects of that heat: HeatColor() of its position. On the
   * equalized axis it is the position of the center of its bin, where the line is drawn. */
  RGBColor
  ColorOf(double heat) const;

  HeatScale
  GetScale() const
  {
    return m_Scale;
  }
  const HeatRange &
  GetRange() const
  {
    return m_Range;
  }

private:
  double
  ShareBelow(double heat) const;

  HeatScale           m_Scale;
  HeatRange           m_Range;
  std::vector<double> m_Shares;
  double              m_LowerShare{ 0.0 };
  double              m_UpperShare{ 1.0 };
};
} // namespace shapeton

#endif
