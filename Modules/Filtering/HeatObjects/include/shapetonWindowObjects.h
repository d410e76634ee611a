#ifndef shapetonWindowObjects_h
#define shapetonWindowObjects_h

#include "shapetonHeatObjects.h"

namespace shapeton
{
/** Objects found in the heat volumes of several intensity windows, such as those of ChooseObjectWindows(), as one list.
 *
 * Each window separates structures from their surroundings at one threshold: a foot from air, bones from muscle,
 * compact from spongy bone. All objects of the first window are listed. An object of a later window is added unless it
 *   - shows an object that is listed already: one nearly contains the other, and it has at most twice its voxels;
 *   - is the core of a listed object, that is, the only part with at least a tenth of that object's voxels;
 *   - crosses the border of a listed object.
 * HeatObject::time is the number of the window, from 0; heatCurve contains the mean heat of this window only. `heats`
 * contains one volume per window. Throws as FindHeatObjects().
 * \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT HeatObjectList
FindWindowObjects(const std::vector<const itk::Image<float, 3> *> & heats,
                  const HeatObjectOptions &                         options = {},
                  const Progress &                                  progress = {});
} // namespace shapeton

#endif
