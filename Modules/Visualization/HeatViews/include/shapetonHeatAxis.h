#ifndef shapetonHeatAxis_h
#define shapetonHeatAxis_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatClasses.h"
#include "shapetonHeatHistogram.h"
#include "shapetonPicture.h"

#include <vector>

namespace shapeton
{
/** Layout of heat values on the horizontal axis of a heat histogram (dissertation 2.3.1, Figure 2.3).
 * \ingroup ShapetonHeatViews */
enum class HeatScale
{
  /** Position proportional to the cumulative count, so every feature is visible. */
  Equalized,
  /** Position proportional to heat. */
  Normalized
};

/** The heat values from lower to upper, 0 <= lower < upper <= 1. By default all values in the histogram.
 * \ingroup ShapetonHeatViews */
struct HeatRange
{
  double lower{ 0.0 };
  double upper{ 0.0 };
};

/** A one-row histogram whose classes have equal weight, so each class has the same width on its axis. For shapeton
 * densities, where the surroundings would otherwise occupy nearly all of the axis.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT HeatHistogram
BalanceClasses(const HeatHistogram & histogram, std::size_t row, const std::vector<HeatClass> & classes);

/** \class HeatAxis
 * \brief Position of a heat value on the axis of a heat histogram, and its color, consistent in all pictures of one
 * result.
 *
 * The equalized axis is the map HeatHistogram::GetEqualization(), interpolated linearly inside a bin. A sub-range of
 * the heat is re-equalized (the hierarchical histogram). If the range has no counts, all bins are equally wide.
 *
 * \ingroup ShapetonHeatViews
 */
class ShapetonHeatViews_EXPORT HeatAxis
{
public:
  /** Throws std::invalid_argument for an invalid range, except the default. */
  explicit HeatAxis(const HeatHistogram & histogram,
                    HeatScale             scale = HeatScale::Equalized,
                    const HeatRange &     range = {});

  /** Position from 0 at the lower end to 1 at the upper end; values beyond the ends are clamped. Nondecreasing in
   * heat. */
  double
  PositionOf(double heat) const;

  /** The smallest heat at this position in [0, 1]. */
  double
  HeatAt(double position) const;

  /** Color of voxels with this heat: HeatColor() of its position. On the equalized axis, uses the position of the bin's
   * center, where its line is drawn. */
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
