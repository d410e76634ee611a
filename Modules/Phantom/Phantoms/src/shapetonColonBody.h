#ifndef shapetonColonBody_h
#define shapetonColonBody_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"
#include "shapetonPhantomSolid.h"

namespace shapeton
{
/** The colon: the 2 mm wall, gas and tagged fluid. Anatomy and fluid must outlive the body. */
std::shared_ptr<const PhantomBody>
MakeColonBody(const ColonAnatomy & anatomy, const ColonFluid & fluid);

/** Thickness of the wall around the lumen of colon and small bowel, mm. */
constexpr double bowelWall = 2.0;

/** Mean intensities, HU. */
constexpr double gasIntensity = -994.0;
constexpr double softTissueIntensity = 50.0;

std::vector<itk::Point<double, 3>>
ToPoints(const std::vector<Eigen::Vector3d> & axis);

/** Depth of polyp tissue, including the wall behind it. Larger than the wall of MakeColonBody(), whose thickness is the
 * same on polyps as elsewhere. */
PhantomSolid
PolypSolid(const ColonPolyp & polyp);

/** The air between the buttocks, below the anal verge and behind the perineum. */
PhantomSolid
NatalCleft(const ColonAnatomy & anatomy);

/** The part of a solid in the lumen of the colon, or up to `beyond` mm (at most 9) behind its surface. */
PhantomSolid
WithinColon(const PhantomSolid & solid, const ColonAnatomy & anatomy, double beyond);

/** The part of a solid that is more than `gap` mm (at most 9) from the lumen of the colon. */
PhantomSolid
AwayFromColon(const PhantomSolid & solid, const ColonAnatomy & anatomy, double gap);
} // namespace shapeton

#endif
