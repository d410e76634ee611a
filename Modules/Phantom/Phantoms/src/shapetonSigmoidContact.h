#ifndef shapetonSigmoidContact_h
#define shapetonSigmoidContact_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonStructures.h"
#include "shapetonPhantomSolid.h"

#include <vector>

namespace shapeton
{
/** A loop of tagged ileum along the sigmoid: their walls touch, their lumens are separate. */
struct SigmoidContactLoop
{
  ColonContact                 truth;
  std::vector<Eigen::Vector3d> axis; ///< empty without a loop
  PhantomSolid                 lumen;
  PhantomSolid                 outer; ///< including the wall
};

/** Placed next to the sigmoid where there is enough room beside the rest of the colon, spine, body wall, pelvic organs
 * and terminal ileum (whose axis may be empty). The anatomy must outlive the solids. */
SigmoidContactLoop
MakeSigmoidContact(const ColonAnatomy & anatomy, const std::vector<Eigen::Vector3d> & ileum);
} // namespace shapeton

#endif
