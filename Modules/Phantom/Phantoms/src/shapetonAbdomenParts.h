#ifndef shapetonAbdomenParts_h
#define shapetonAbdomenParts_h

#include "shapetonColonAnatomy.h"
#include "shapetonPhantomSolid.h"

namespace shapeton
{
/** Intensity of organs, HU. */
constexpr double liverIntensity = 62.0;
constexpr double spleenIntensity = 56.0;

/** Adds a solid of uniform intensity, HU. */
void
AddPart(PhantomBodies & bodies, const PhantomSolid & solid, double intensity);

/** The half space above a height, mm. */
PhantomSolid
Above(double z);

/** The outline of the body, and the inner surface of its muscular wall. */
PhantomSolid
BodyOutline();
PhantomSolid
AbdominalCavity();

/** The top of the abdominal cavity, covered by the diaphragm. */
PhantomSolid
DiaphragmDome();

/** Adds skin, subcutaneous fat, the muscular wall, the fat inside, muscles of the back, buttocks and pelvic floor. */
void
AddBodyWall(PhantomBodies & bodies);

/** Adds spine, sacrum, wings of the ilium, hips and ribs; `hasPubis` adds the pubic bones and the symphysis. */
void
AddBones(PhantomBodies & bodies, bool hasPubis);

/** Adds the upper ribs, sternum, clavicles and scapulae above the bones of AddBones(). */
void
AddThoraxBones(PhantomBodies & bodies);

/** Adds liver, spleen, kidneys, great vessels, bladder, and the stomach with fluid and a small gas bubble. */
void
AddOrgans(PhantomBodies & bodies, const ColonAnatomy & anatomy, const itk::Vector<double, 3> & down);

/** The bladder and the organ behind it, excluding the space for the colon. */
PhantomSolid
PelvicOrgans();

/** The lumen of the stomach: gas and fluid. */
PhantomSolid
StomachLumen(const ColonAnatomy & anatomy);

/** Adds vessels in the fat between the loops of bowel. */
void
AddMesentery(PhantomBodies & bodies, unsigned seed);

/** Adds the plain chest: lung bases of uniform intensity above the diaphragm, and the heart in between. */
void
AddChest(PhantomBodies & bodies, const ColonAnatomy & anatomy);

/** Adds the scanner table under the body. */
void
AddTable(PhantomBodies & bodies, const std::string & position);
} // namespace shapeton

#endif
