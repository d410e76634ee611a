#ifndef shapetonWindowObjects_h
#define shapetonWindowObjects_h

#include "shapetonHeatObjects.h"

namespace shapeton
{
/** Objects of heat volumes of several windows of intensity, such as those of ChooseObjectWindows(), as one list.
 *
 * Each window separates what differs from its surroundings across one threshold: a foot from air, bones from muscle,
 * compact from spongy bone. The objects of the first window are all listed. One of a later window is added unless it
 *   - shows an object that is listed already: one nearly contains the other, and it has at most twice its voxels;
 *   - is the core of a listed object: it is the only part of at least a tenth of it, so it does not divide it;
 *   - crosses the border of a listed object.
 * HeatObject::time is the window, from 0; heatCurve has the mean heat of this window only. `heats` has one volume per
 * window. Throws as FindHeatObjects().
 * \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT HeatObjectList
FindWindowObjects(const std::vector<const itk::Image<float, 3> *> & heats,
                  const HeatObjectOptions &                         options = {},
                  const Progress &                                  progress = {});
} // namespace shapeton

#endif
