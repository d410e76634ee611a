#ifndef shapetonLabelFiles_h
#define shapetonLabelFiles_h

#include "ShapetonHeatToolsExport.h"

#include "shapetonHeatClasses.h"
#include "shapetonHeatObjects.h"
#include "shapetonProvenance.h"
#include "shapetonSegments.h"
#include "shapetonShapeQuantity.h"

#include "itkImage.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Writes the labels of classes, as a segmentation with their names and colors (see SegmentMetadata()). Throws as
 * WriteVolume(). \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
WriteClassLabels(const itk::Image<unsigned char, 3> * labels,
                 const std::vector<HeatClass> &       classes,
                 const ShapeQuantity &                quantity,
                 const std::string &                  path,
                 const Provenance &                   provenance);

/** Writes labels of objects, as a segmentation with their names and colors: label i shows the object `objects[i - 1]`.
 * Throws as WriteVolume(). \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
WriteObjectLabels(const HeatObjectList::LabelImage * labels,
                  const std::vector<int> &           objects,
                  const std::string &                path,
                  const Provenance &                 provenance);

/** Writes labels grown from seeds, as a segmentation. Segments keep names, colors and terms of the segments of the
 * seeds; others are named by their labels. Throws as WriteVolume(). \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
WriteSeededLabels(const itk::Image<unsigned short, 3> * labels,
                  const std::vector<unsigned short> &   labelValues,
                  const std::vector<Segment> &          ofSeeds,
                  const std::string &                   path,
                  const Provenance &                    provenance);
} // namespace shapeton

#endif
