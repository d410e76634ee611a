#ifndef shapetonHeatAxis_h
#define shapetonHeatAxis_h

#include "HeatViewsExport.h"

#include "shapetonHeatClasses.h"
#include "shapetonHeatHistogram.h"
#include "shapetonPicture.h"

#include <vector>

namespace shapeton
{
/** How heats are laid out on the horizontal axis of a heat histogram (dissertation 2.3.1, Figure 2.3).
 * \ingroup HeatViews */
enum class HeatScale
{
  /** By the share of counts below: every feature gets room. */
  Equalized,
  /** Proportional to heat. */
  Normalized
};

/** The heats lower to upper, 0 <= lower < upper <= 1. The default stands for all heat that occurs.
 * \ingroup HeatViews */
struct HeatRange
{
  double lower{ 0.0 };
  double upper{ 0.0 };
};

/** A histogram of one row whose classes have equal weight: the axis that it lays out gives each class the same room.
 * For densities of shapetons, where the surroundings do not cool to the background and would take nearly all of the
 * axis. \ingroup HeatViews */
HeatViews_EXPORT HeatHistogram
BalanceClasses(const HeatHistogram & histogram, std::size_t row, const std::vector<HeatClass> & classes);

/** \class HeatAxis
 * \brief The place of a heat on the axis of a heat histogram, and its colour, the same in all pictures of one result.
 *
 * The equalised axis is the map HeatHistogram::GetEqualization(), interpolated linearly inside a bin; on a part of the
 * heats, it is re-equalised inside that part (the hierarchical histogram). Where no heat was counted in the part, all
 * bins are equally wide.
 *
 * \ingroup HeatViews
 */
class HeatViews_EXPORT HeatAxis
{
public:
  /** Throws std::invalid_argument for a range that is neither the default nor valid. */
  explicit HeatAxis(const HeatHistogram & histogram,
                    HeatScale             scale = HeatScale::Equalized,
                    const HeatRange &     range = {});

  /** 0 at the lower end, 1 at the upper end; heats beyond the ends are clamped. Never falls with heat. */
  double
  PositionOf(double heat) const;

  /** The least heat at this position in [0, 1]. */
  double
  HeatAt(double position) const;

  /** The colour of a heat, of its line in the histogram, and of objects of that heat: HeatColor() of its position; on
   * the equalised axis, of the middle of its bin, where the line is drawn. */
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
