#ifndef shapetonLumenAlong_h
#define shapetonLumenAlong_h

#include "ShapetonColonModelExport.h"
#include "shapetonCurveSet.h"
#include "shapetonTopologyPreservingGrowth.h"

#include <functional>

namespace shapeton
{
/** Labels the voxels of a lumen according to the closest point of the centerline, measured within the lumen to separate
 * touching loops; the label is 0 outside the lumen.
 * \param centerline one curve with the point array `arcLength`.
 * \param labelOf maps the distance along the centerline (mm) to a label; called from several threads.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT itk::Image<unsigned short, 3>::Pointer
                          LabelLumenAlong(const LumenMaskImage *                        lumen,
                                          const CurveSet &                              centerline,
                                          const std::function<unsigned short(double)> & labelOf);
} // namespace shapeton

#endif
