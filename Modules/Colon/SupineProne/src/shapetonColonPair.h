#ifndef shapetonColonPair_h
#define shapetonColonPair_h

#include "shapetonCylinderPicture.h"
#include "shapetonStartFrame.h"

#include <memory>

namespace shapeton
{
constexpr int    WarpAngles = 48;   ///< rotations of the warping
constexpr double WarpRowStep = 3.0; ///< mm between its rows

/** Two positions with what is known of them before they are registered. The positions must outlive it. */
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
  /** Places of the source, mm, where segments meet that are registered by themselves. */
  std::vector<double> breaks;

  /** Of the target, mm. */
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

/** Fills in taeniae, frame and, where `isSegmentWise`, breaks. Throws InputError where the positions have no landmarks
 * in common. */
void
FindFrame(ColonPair & pair, bool isSegmentWise, std::vector<std::string> & warnings);

/** Nothing is to be seen at this place of a colon. */
bool
IsExcluded(const ColonPosition & position, const ColonCylinder & cylinder, const CylinderPlace & place);
} // namespace shapeton

#endif
