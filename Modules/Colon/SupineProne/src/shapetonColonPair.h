#ifndef shapetonColonPair_h
#define shapetonColonPair_h

#include "shapetonCylinderPicture.h"
#include "shapetonStartFrame.h"

#include <memory>

namespace shapeton
{
constexpr int    WarpAngles = 48;   ///< rotations of the warping; chosen: 7.5 degrees
constexpr double WarpRowStep = 3.0; ///< mm between its rows; chosen: folds are 20 to 30 mm apart

/** Two positions with derived data, before registration. The positions must outlive this object. */
struct ColonPair
{
  ColonPair(const ColonPosition & source, const ColonPosition & target);

  const ColonPosition &                source;
  const ColonPosition &                target;
  std::shared_ptr<const ColonCylinder> sourceCylinder;
  std::shared_ptr<const ColonCylinder> targetCylinder;
  std::vector<float>                   sourceFolds; ///< FoldProbability()
  std::vector<float>                   targetFolds;
  TaeniaAngles                         sourceTaeniae;
  TaeniaAngles                         targetTaeniae;
  PiecewiseLine                        frame;
  /** Borders of separately registered segments in the source, mm. */
  std::vector<double> breaks;

  /** Circumference of the target, mm. */
  double
  Around() const
  {
    return targetCylinder->Around();
  }
  bool
  AreTaeniaeKnown() const
  {
    return sourceTaeniae.isKnown && targetTaeniae.isKnown;
  }
};

/** Sets taeniae, frame and, if `isSegmentWise`, breaks. Throws InputError if the positions have no landmarks in
 * common. */
void
FindFrame(ColonPair & pair, bool isSegmentWise, std::vector<std::string> & warnings);

/** Whether the wall at a position is not visible. */
bool
IsExcluded(const ColonPosition & position, const ColonCylinder & cylinder, const CylinderPlace & place);
} // namespace shapeton

#endif
