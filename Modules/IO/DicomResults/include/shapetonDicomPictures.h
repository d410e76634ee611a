#ifndef shapetonDicomPictures_h
#define shapetonDicomPictures_h

#include "shapetonDicomCode.h"
#include "shapetonDicomSource.h"
#include "shapetonSurfaceMesh.h"

#include "itkImage.h"
#include "itkRGBPixel.h"

namespace shapeton
{
/** Writes a picture as an RGB Secondary Capture. Throws InputError for more than 65535 rows or columns, and
 * OutputError.
 * \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomInstance
WriteDicomPicture(const DicomSource &                                 source,
                  const itk::Image<itk::RGBPixel<unsigned char>, 2> * picture,
                  const DicomResultHeader &                           header,
                  const std::string &                                 path);

/** Writes a surface (LPS, mm) as an Encapsulated STL in the frame of reference of the source. `what` is the coded term
 * for the surface. Throws InputError as WriteSurface() does, and OutputError. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomInstance
WriteDicomSurface(const DicomSource &       source,
                  const SurfaceMesh &       mesh,
                  const DicomCode &         what,
                  const DicomResultHeader & header,
                  const std::string &       path);

/** Description of the values of a map. \ingroup ShapetonDicomResults */
struct DicomMapMeaning
{
  DicomCode quantity;
  DicomCode unit;
  /** At most 16 characters. */
  std::string label;
  std::string explanation;
  /** Body region. */
  DicomCode region;
};

/** Writes an image as a Parametric Map: 32-bit floating point, one frame per slice of the source, with an identity
 * real-world value mapping. Throws InputError if the grid differs from that of the source, and OutputError.
 * \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomInstance
WriteDicomMap(const DicomSource &          source,
              const itk::Image<float, 3> * image,
              const DicomMapMeaning &      meaning,
              const DicomResultHeader &    header,
              const std::string &          path);
} // namespace shapeton

#endif
