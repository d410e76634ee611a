#ifndef shapetonLumenAlong_h
#define shapetonLumenAlong_h

#include "ColonWallExport.h"
#include "shapetonCurveSet.h"
#include "shapetonTopologyPreservingGrowth.h"

#include <functional>

namespace shapeton
{
/** Labels of the voxels of a lumen by their place along the colon: that of the point of the centreline which is closest
 * within the lumen, so that loops that touch do not get each other's.
 * \param centreline one curve with the point array `arcLength`.
 * \param labelOf gives the label for mm along the centreline; called from several threads.
 * 0 outside of the lumen. \ingroup ColonWall */
ColonWall_EXPORT itk::Image<unsigned short, 3>::Pointer
                 LabelLumenAlong(const LumenMaskImage *                        lumen,
                                 const CurveSet &                              centreline,
                                 const std::function<unsigned short(double)> & labelOf);
} // namespace shapeton

#endif
