#ifndef shapetonSeedFiles_h
#define shapetonSeedFiles_h

#include "ShapetonHeatToolsExport.h"
#include "shapetonHeatSeeds.h"
#include "shapetonSlicerMarkups.h"
#include "shapetonVolume.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Converts a label map of seeds or objects, read from `path`, to labels on the grid of the image. Throws InputError
 * for another grid, and for values that are not integers from 0 to 65535. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT SeedImage::Pointer
LabelsOfVolume(const Volume & volume, const std::string & path, const itk::ImageBase<3> * image);

/** Seeds from markups: label 1 for the first node, 2 for the second, and so on. Points mark the voxels that contain
 * them; curves mark all voxels that their straight segments pass through. Throws InputError for a node without points,
 * and for a point outside the volume or in a voxel of another label; the message states its node and number.
 * \ingroup ShapetonHeatTools
 */
ShapetonHeatTools_EXPORT SeedImage::Pointer
                         SeedsOfMarkups(const std::vector<Markup> & markups, const itk::ImageBase<3> * image);

} // namespace shapeton

#endif
