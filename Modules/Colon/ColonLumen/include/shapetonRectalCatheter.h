#ifndef shapetonRectalCatheter_h
#define shapetonRectalCatheter_h

#include "itkPoint.h"

#include <vector>

namespace shapeton
{
/** Evidence that a tube in the rectum is a catheter. \ingroup ShapetonColonLumen */
struct CatheterEvidence
{
  /** Longest section (mm) of the bore inside the body that is round (ovality below .1) and uniform (radii within .5
   * mm). */
  double length{ 0.0 };
  double enclosedLength{ 0.0 }; ///< length of tube (mm) where 80 % of the radial rays cross a wall into the lumen
  double enclosedShare{ 0.0 };  ///< fraction of such rays, 0 to 1: minimum over the best 6 mm
  double boreSpread{ 0.0 };     ///< mm: 80th minus 20th percentile of the radius along the section
  /** Deviation of the bore from a circle: root mean square of the second and third harmonics of the radius over the
   * angle, divided by the mean radius; median along the section. */
  double ovality{ 0.0 };
  /** 0 to 1: the smallest of the margins by which the lengths, the fraction and the bore radius meet their limits (.5
   * at the limit). A catheter has a confidence of at least .5. */
  double confidence{ 0.0 };
};

/** \class RectalCatheter
 * \brief An insufflation tube in the rectum. Lengths in mm, points in LPS.
 * \ingroup ShapetonColonLumen */
struct RectalCatheter
{
  /** Whether the confidence is at least .5, so that the tube is added to the lumen. Otherwise, it may be a catheter or
   * bowel. */
  bool isSure{ false };
  /** Axis of the bore, one point per mm, from the anal side (or the border of the image). If the catheter is certain,
   * the axis is extended along a straight line to the end of the tip. */
  std::vector<itk::Point<double, 3>> axis;
  double                             boreDiameter{ 0.0 };
  double                             outerDiameter{ 0.0 };
  double                             tipRadius{ 0.0 };       ///< maximum distance of the tip from the axis
  double                             wallHU{ 0.0 };          ///< median of the maxima across the wall
  double                             balloonDiameter{ 0.0 }; ///< including the membrane; 0 if no filled balloon is seen
  itk::Point<double, 3>              balloonCenter{};        ///< center of a visible balloon
  double                             filledMl{ 0.0 };        ///< volume of tube, tip and balloon added to the lumen
  CatheterEvidence                   evidence;
};
} // namespace shapeton

#endif
