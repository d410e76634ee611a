#ifndef shapetonCatheterTube_h
#define shapetonCatheterTube_h

#include "shapetonColonStructurePart.h"

#include <vector>

namespace shapeton
{
/** The tube through the anal canal into the rectum: ground truth, and parts in painting order. */
struct CatheterTube
{
  ColonCatheter                      truth;
  std::vector<Eigen::Vector3d>       axis; ///< from outside the body to the tip
  std::vector<ColonStructures::Part> parts;
};

/** Requires an anatomy with a catheter. Anatomy and fluid must outlive the parts. */
CatheterTube
MakeCatheterTube(const ColonAnatomy & anatomy, const ColonFluid & fluid);
} // namespace shapeton

#endif
