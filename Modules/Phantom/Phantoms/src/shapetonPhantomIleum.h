#ifndef shapetonPhantomIleum_h
#define shapetonPhantomIleum_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"
#include "shapetonPhantomSolid.h"

#include <vector>

namespace shapeton
{
/** The terminal ileum, from the mouth between the lips of the valve into the abdomen. */
struct PhantomIleum
{
  std::string                  content;               ///< collapsed, gas or fluid
  bool                         isOpen;                ///< whether the lumen is connected to the colon
  double                       slitWidth;             ///< mm, 0 if closed
  double                       bore;                  ///< mm
  double                       length;                ///< mm, from the mouth to the end
  double                       intensity;             ///< HU of the content
  std::vector<Eigen::Vector3d> axis;                  ///< from just inside the colon, 2 mm apart
  PhantomSolid                 lumen;                 ///< empty if collapsed
  PhantomSolid                 wall;                  ///< including the content
  PhantomSolid                 fluid;                 ///< fluid below the gas of a refluxed ileum; otherwise empty
  double                       fluidIntensity{ 0.0 }; ///< HU
};

/** Missing space (mm) for a tube of radius `margin` at a point between the wall of the abdominal cavity and the spine;
 * negative if there is enough. */
double
LackingBetweenWallAndSpine(const PhantomSolid & cavity, const Eigen::Vector3d & at, double margin);

/** Requires a valve with lips. The anatomy must outlive the solids. */
PhantomIleum
MakePhantomIleum(const ColonAnatomy & anatomy, const ColonFluid & fluid);
} // namespace shapeton

#endif
