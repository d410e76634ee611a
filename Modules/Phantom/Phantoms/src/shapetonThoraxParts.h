#ifndef shapetonThoraxParts_h
#define shapetonThoraxParts_h

#include "shapetonColonAnatomy.h"
#include "shapetonPhantomSolid.h"

namespace shapeton
{
/** The inner surface of the ribs: the column of the abdomen's chest wall, closed by a cap whose top is at z = 350 mm.
 */
PhantomSolid
ThoracicCage();

/** The structures between the lungs, including the heart with its fat. */
PhantomSolid
Mediastinum();

/** The heart without its fat. */
PhantomSolid
Heart();

/** The regions covered by the two halves of the diaphragm above the dome of the abdomen; `lift` (mm) raises them. */
PhantomSolid
RightHemidiaphragm(double lift);
PhantomSolid
LeftHemidiaphragm(double lift);

/** Shoulders and neck, muscles of the chest, pleura, diaphragm with liver and spleen under it, mediastinum with fat,
 * heart, great vessels and esophagus. Lungs, airways and pulmonary vessels are those of MakeLungParts(). */
void
AddThorax(PhantomBodies & bodies, const ColonAnatomy & anatomy, double lift);
} // namespace shapeton

#endif
