#ifndef shapetonFlatCoordinateMap_h
#define shapetonFlatCoordinateMap_h

#include "shapetonFlatColonGrid.h"
#include "shapetonVolumeWriter.h"

#include "itkImage.h"
#include "itkVector.h"

namespace shapeton
{
/** Point in space (LPS, mm) of each pixel of the flat map. Index (0, 0) is the first column and row; the physical point
 * of an index is (u, v) in mm. \ingroup ShapetonFlatColon */
using FlatCoordinateMap = itk::Image<itk::Vector<float, 3>, 2>;

/** Sets size and physical space of an image to the grid: the physical point of an index is (u, v) in mm.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT void
SetFlatSpace(const FlatColonGrid & grid, itk::ImageBase<2> * picture);

/** Builds the coordinate map; NaN outside all faces. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT FlatCoordinateMap::Pointer
                         MakeFlatCoordinateMap(const FlatColonGrid & grid);

/** Throws ParameterError unless the name is empty (not requested) or ends with .nrrd. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT const std::string &
                               RequireCoordinateMapName(const std::string & path);

/** Writes an NRRD file whose header contains the space of the vectors, the pixel size, the circumference and
 * `metadata`. Throws OutputError if the file cannot be written, and ParameterError for another extension.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT void
WriteFlatCoordinateMap(const FlatColonGrid & grid, const std::string & path, const VolumeMetadata & metadata = {});
} // namespace shapeton

#endif
