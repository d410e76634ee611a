#ifndef shapetonPhantomIleum_h
#define shapetonPhantomIleum_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"
#include "shapetonPhantomSolid.h"

#include <vector>

namespace shapeton
{
/** The last of the small bowel, from the mouth between the lips of the valve away into the abdomen. */
struct PhantomIleum
{
  std::string                  content;   ///< collapsed, gas or fluid
  bool                         isOpen;    ///< its lumen and that of the colon are one
  double                       slitWidth; ///< mm, 0 where closed
  double                       bore;      ///< mm
  double                       length;    ///< from the mouth to where it is lost, mm
  double                       intensity; ///< of the content, HU
  std::vector<Eigen::Vector3d> axis;      ///< from just inside the colon, 2 mm apart
  PhantomSolid                 lumen;     ///< empty where collapsed
  PhantomSolid                 wall;      ///< with what is in it
};

/** Of a colon whose valve has lips. Anatomy has to outlive the solids. */
PhantomIleum
MakePhantomIleum(const ColonAnatomy & anatomy, const ColonFluid & fluid);
} // namespace shapeton

#endif
