#ifndef shapetonRectalCatheter_h
#define shapetonRectalCatheter_h

#include "itkPoint.h"

#include <vector>

namespace shapeton
{
/** Evidence that a tube in the rectum is a catheter. \ingroup ShapetonColonLumen */
struct CatheterEvidence
{
  /** Longest stretch (mm) of bore inside the body that is round (ovality below .1) and even (radii within .5 mm). */
  double length{ 0.0 };
  double enclosedLength{ 0.0 }; ///< mm of tube where 80 % of the rays across it cross a wall and enter the lumen
  double enclosedShare{ 0.0 };  ///< share of such rays, 0..1: minimum over the best 6 mm
  double boreSpread{ 0.0 };     ///< mm: difference of the 80th and the 20th percentile of the radius along the stretch
  /** Deviation of the bore from a circle: root mean square of the second and third harmonics of the radius over the
   * angle, divided by the mean radius; median along the stretch. */
  double ovality{ 0.0 };
  /** 0..1: margin of lengths, share and bore radius within their limits, .5 at the limit; the minimum of them. At least
   * .5 for a catheter. */
  double confidence{ 0.0 };
};

/** \class RectalCatheter
 * \brief An insufflation tube in the rectum. Lengths in mm, points in LPS.
 * \ingroup ShapetonColonLumen */
struct RectalCatheter
{
  /** Whether the confidence is at least .5: the tube is added to the lumen. Otherwise it may be a catheter or bowel. */
  bool isSure{ false };
  /** Axis of the bore, one point per mm, from the anal side (or the border of the image); if certain, extended straight
   * through the tip to its end. */
  std::vector<itk::Point<double, 3>> axis;
  double                             boreDiameter{ 0.0 };
  double                             outerDiameter{ 0.0 };
  double                             tipRadius{ 0.0 };       ///< distance from the axis to the widest place of the tip
  double                             wallHU{ 0.0 };          ///< median of the maxima across the wall
  double                             balloonDiameter{ 0.0 }; ///< with its membrane; 0 if no filled balloon is visible
  itk::Point<double, 3>              balloonCenter{};        ///< center of a visible balloon
  double                             filledMl{ 0.0 };        ///< volume of tube, tip and balloon added to the lumen
  CatheterEvidence                   evidence;
};
} // namespace shapeton

#endif
