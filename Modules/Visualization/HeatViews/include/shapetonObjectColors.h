#ifndef shapetonObjectColors_h
#define shapetonObjectColors_h

#include "ShapetonHeatViewsExport.h"

#include "shapetonHeatObjects.h"
#include "shapetonPicture.h"
#include "shapetonShapeTransferFunction.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** "object 3" and its color: the same in pictures, on the page of objects and in label files. Numbers count from 1.
 * \ingroup ShapetonHeatViews */
///@{
ShapetonHeatViews_EXPORT std::string
                         NameOfObject(int number);
ShapetonHeatViews_EXPORT RGBColor
ColorOfObject(int number);
///@}

/** An object in a transfer function: the voxels of a label map that it shows, whatever their heat.
 * \ingroup ShapetonHeatViews */
struct ObjectColor
{
  int              number{ 0 }; ///< of the object, from 1
  std::vector<int> labels;      ///< its label and those of the objects in it; ascending
  std::uint64_t    voxels{ 0 }; ///< number of voxels with these labels
  RGBColor         color;
  double           opacity{ 1.0 }; ///< in [0, 1]; 1 is opaque
};

/** A volume of class numbers and the color of each, to be drawn like a heat volume with its transfer function.
 * \ingroup ShapetonHeatViews */
struct ColoredClasses
{
  itk::Image<float, 3>::ConstPointer values;
  ShapeTransferFunction              lines;
};

/** The classes of a transfer function with objects: the lines, in this order, then the objects. A voxel is in the
 * smallest object that contains it, otherwise in the line of its heat, if any. `labels` contains the number of the
 * smallest object at each voxel, as written by HeatObjects. Throws InputError with `name`, the name of the labels, if
 * the number of voxels of an object differs from that in the labels; the image sizes must be equal.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT ColoredClasses
ColorObjects(const itk::Image<float, 3> *       heat,
             const ShapeTransferFunction &      lines,
             const HeatObjectList::LabelImage * labels,
             const std::vector<ObjectColor> &   objects,
             const std::string &                name);

/** "number:color:opacity,...", for provenance and reports. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::string
                         TextOf(const std::vector<ObjectColor> & objects);
} // namespace shapeton

#endif
