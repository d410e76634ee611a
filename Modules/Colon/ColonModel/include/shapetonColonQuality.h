#ifndef shapetonColonQuality_h
#define shapetonColonQuality_h

#include "shapetonColonModel.h"
#include "shapetonJsonForward.h"

namespace shapeton
{
/** Machine-readable measurements of a model: lumen, centerline, distension, surfaces, warnings. Lengths in mm,
 * volumes in ml, intensities in HU, points in LPS. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT Json
ColonQualityToJson(const ColonModel & model);

/** Replaces the valve in such a document, also among the missing parts. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT void
StateValve(const ValveSearch & search, Json & quality);
} // namespace shapeton

#endif
