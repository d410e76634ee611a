#ifndef shapetonHeatObjectTable_h
#define shapetonHeatObjectTable_h

#include "ShapetonHeatToolsExport.h"

#include "shapetonCsvTable.h"
#include "shapetonHeatObjects.h"
#include "shapetonPicture.h"

#include <string>
#include <vector>

namespace shapeton
{
/** One row per object: object, parent, voxels, volume (mm^3), x, y, z (LPS, mm), meanIntensity, meanHeat, probability,
 * range, contrast, compactness, cut. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT CsvTable
HeatObjectTable(const HeatObjectList & list, const std::vector<int> & objects, const itk::Image<float, 3> * image);

/** Labels 1, 2, ... in these objects, including those inside them; later ones take precedence; 0 elsewhere. Throws
 * ParameterError. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT HeatObjectList::LabelImage::Pointer
                         LabelsOfObjects(const HeatObjectList & list, const std::vector<int> & objects);

/** The objects that contain a point, LPS in mm, the smallest first. Throws ParameterError if the point is outside the
 * volume, and InputError if no object contains it. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT std::vector<int>
                         ObjectsAt(const HeatObjectList & list, const itk::Point<double, 3> & point);

/** Three slices through most objects, with names and colors: label i shows the object `objects[i - 1]`.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT Picture::Pointer
                         DrawHeatObjects(const itk::Image<float, 3> *       image,
                                         const HeatObjectList::LabelImage * labels,
                                         const std::vector<int> &           objects,
                                         const std::string &                title);
} // namespace shapeton

#endif
