#ifndef shapetonColonPointPairs_h
#define shapetonColonPointPairs_h

#include "ShapetonPhantomsExport.h"

#include "shapetonCsvTable.h"
#include "shapetonCurveSet.h"

namespace shapeton
{
/** Corresponding wall points in two positions of a patient, each a correspondence.vtp
 * (ColonAnatomy::Correspondence()): a row sx,sy,sz,px,py,pz (LPS, mm) for each materialId in both, outside collapsed
 * stretches of either, in ascending order. Throws InputError if an array is missing or no common materialId exists.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT CsvTable
TableOfPointPairs(const CurveSet & first, const CurveSet & second);
} // namespace shapeton

#endif
