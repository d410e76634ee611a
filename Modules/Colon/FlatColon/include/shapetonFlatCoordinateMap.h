#ifndef shapetonFlatCoordinateMap_h
#define shapetonFlatCoordinateMap_h

#include "shapetonFlatColonGrid.h"
#include "shapetonVolumeWriter.h"

#include "itkImage.h"
#include "itkVector.h"

namespace shapeton
{
/** For each pixel of the flat map its point in space, LPS, mm. Index (0, 0) is the first column and row; the physical
 * space of the image is the map: the physical point of an index is its (u, v) in mm. \ingroup FlatColon */
using FlatCoordinateMap = itk::Image<itk::Vector<float, 3>, 2>;

/** Gives a picture the size and the physical space of the grid: the physical point of an index is its (u, v) in mm.
 * \ingroup FlatColon */
FlatColon_EXPORT void
SetFlatSpace(const FlatColonGrid & grid, itk::ImageBase<2> * picture);

/** Not a number where no face lies. \ingroup FlatColon */
FlatColon_EXPORT FlatCoordinateMap::Pointer
                 MakeFlatCoordinateMap(const FlatColonGrid & grid);

/** Throws ParameterError unless the name is empty (not wanted) or ends with .nrrd. \ingroup FlatColon */
FlatColon_EXPORT const std::string &
                       RequireCoordinateMapName(const std::string & path);

/** Writes NRRD; the space of the vectors, pixel size and circumference stand beside `metadata` in its header. Throws
 * OutputError when the file cannot be written, ParameterError for another extension. \ingroup FlatColon */
FlatColon_EXPORT void
WriteFlatCoordinateMap(const FlatColonGrid & grid, const std::string & path, const VolumeMetadata & metadata = {});
} // namespace shapeton

#endif
