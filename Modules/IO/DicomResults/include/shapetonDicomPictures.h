#ifndef shapetonDicomPictures_h
#define shapetonDicomPictures_h

#include "shapetonDicomCode.h"
#include "shapetonDicomSource.h"
#include "shapetonSurfaceMesh.h"

#include "itkImage.h"
#include "itkRGBPixel.h"

namespace shapeton
{
/** Writes a picture as Secondary Capture in RGB. Throws InputError for more than 65535 rows or columns, OutputError.
 * \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomInstance
WriteDicomPicture(const DicomSource &                                 source,
                  const itk::Image<itk::RGBPixel<unsigned char>, 2> * picture,
                  const DicomResultHeader &                           header,
                  const std::string &                                 path);

/** Writes a surface (LPS, mm) as Encapsulated STL in the frame of reference of the source. `what` is the coded term for
 * the surface. Throws InputError as WriteSurface() does, OutputError. \ingroup ShapetonDicomResults */
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

/** Writes an image as Parametric Map: 32-bit floating point, a frame per slice of the source, with an identity
 * real-world value mapping. Throws InputError if the grid differs from the source, OutputError.
 * \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomInstance
WriteDicomMap(const DicomSource &          source,
              const itk::Image<float, 3> * image,
              const DicomMapMeaning &      meaning,
              const DicomResultHeader &    header,
              const std::string &          path);
} // namespace shapeton

#endif
