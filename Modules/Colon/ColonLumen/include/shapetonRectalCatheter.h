#ifndef shapetonRectalCatheter_h
#define shapetonRectalCatheter_h

#include "itkPoint.h"

#include <vector>

namespace shapeton
{
/** How far a tube in the rectum is sure to be a catheter. \ingroup ColonLumen */
struct CatheterEvidence
{
  /** mm of bore inside the body that is round (ovality below .1) and even (radii within .5 mm), the longest stretch. */
  double length{ 0.0 };
  double enclosedLength{ 0.0 }; ///< mm of the tube where 80 % of the rays across it cross a wall and enter the lumen
  double enclosedShare{ 0.0 };  ///< of the rays that do, 0..1: at least, in the best 6 mm
  double boreSpread{ 0.0 };     ///< mm, of the radius along the stretch: between its 20th and 80th percentile
  /** Deviation of the bore from a circle: root mean square of the second and third harmonics of the radius over the
   * angle, divided by the mean radius; median along the stretch. */
  double ovality{ 0.0 };
  /** 0..1: how far lengths, share and the radius of the bore lie within their limits, .5 at the limit; the least of
   * them. A catheter from .5 on. */
  double confidence{ 0.0 };
};

/** \class RectalCatheter
 * \brief A tube for insufflation that lies in the rectum. Lengths in mm, points in LPS.
 * \ingroup ColonLumen */
struct RectalCatheter
{
  /** True if the confidence is at least .5: the tube is added to the lumen. If false, it may be a catheter or bowel. */
  bool isSure{ false };
  /** The middle of the bore, a point each mm, from the anal side (or the image's border) on; straight through the tip
   * to its end, where it is sure. */
  std::vector<itk::Point<double, 3>> axis;
  double                             boreDiameter{ 0.0 };
  double                             outerDiameter{ 0.0 };
  double                             tipRadius{ 0.0 };       ///< of the widest place of the tip, from the axis
  double                             wallHU{ 0.0 };          ///< the greatest across the wall, the median
  double                             balloonDiameter{ 0.0 }; ///< with its membrane; 0 where no filled one is seen
  itk::Point<double, 3>              balloonCentre{};        ///< of a balloon that is seen
  double                             filledMl{ 0.0 };        ///< of tube, tip and balloon that were not lumen before
  CatheterEvidence                   evidence;
};
} // namespace shapeton

#endif
