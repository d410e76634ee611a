#ifndef shapetonColonPointPairs_h
#define shapetonColonPointPairs_h

#include "ShapetonPhantomsExport.h"

#include "shapetonCsvTable.h"
#include "shapetonCurveSet.h"

namespace shapeton
{
/** Corresponding wall points in two positions of a patient; each input is a correspondence.vtp
 * (ColonAnatomy::Correspondence()). The table has one row sx,sy,sz,px,py,pz (LPS, mm) for each materialId that occurs
 * in both positions and is not in a collapsed stretch of either, in ascending order. Throws InputError if an array is
 * missing or the positions have no materialId in common.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT CsvTable
TableOfPointPairs(const CurveSet & first, const CurveSet & second);
} // namespace shapeton

#endif
