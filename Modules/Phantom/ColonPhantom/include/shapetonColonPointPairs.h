#ifndef shapetonColonPointPairs_h
#define shapetonColonPointPairs_h

#include "ColonPhantomExport.h"

#include "shapetonCsvTable.h"
#include "shapetonCurveSet.h"

namespace shapeton
{
/** The same pieces of wall in two positions of a patient, each a correspondence.vtp (ColonAnatomy::Correspondence()): a
 * row sx,sy,sz,px,py,pz (LPS, mm) for each materialId that both have and that lies in a collapsed stretch of neither,
 * in ascending order. Throws InputError where an array is missing or no materialId is common. \ingroup ColonPhantom */
ColonPhantom_EXPORT CsvTable
TableOfPointPairs(const CurveSet & first, const CurveSet & second);
} // namespace shapeton

#endif
