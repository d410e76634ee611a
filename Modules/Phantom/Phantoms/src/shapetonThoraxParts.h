#ifndef shapetonThoraxParts_h
#define shapetonThoraxParts_h

#include "shapetonColonAnatomy.h"
#include "shapetonPhantomSolid.h"

namespace shapeton
{
/** The inner surface of the ribs: the cylinder of the chest wall, closed by a cap with its top at z = 350 mm.
 */
PhantomSolid
ThoracicCage();

/** The mediastinum, including the heart with its fat. */
PhantomSolid
Mediastinum();

/** The heart without its fat. */
PhantomSolid
Heart();

/** The regions under the two domes of the diaphragm, above the abdominal cavity, raised by `lift` (mm). */
PhantomSolid
RightHemidiaphragm(double lift);
PhantomSolid
LeftHemidiaphragm(double lift);

/** Adds shoulders and neck, muscles of the chest, pleura, diaphragm with liver and spleen below, mediastinum with fat,
 * heart, great vessels and esophagus. Lungs, airways and pulmonary vessels are created by MakeLungParts(). */
void
AddThorax(PhantomBodies & bodies, const ColonAnatomy & anatomy, double lift);
} // namespace shapeton

#endif
