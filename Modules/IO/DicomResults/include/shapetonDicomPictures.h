#ifndef shapetonDicomPictures_h
#define shapetonDicomPictures_h

#include "shapetonDicomCode.h"
#include "shapetonDicomSource.h"
#include "shapetonSurfaceMesh.h"

#include "itkImage.h"
#include "itkRGBPixel.h"

namespace shapeton
{
/** Writes a picture as Secondary Capture, in RGB. Throws InputError for more than 65535 rows or columns, OutputError.
 * \ingroup DicomResults */
DicomResults_EXPORT DicomInstance
WriteDicomPicture(const DicomSource &                                 source,
                  const itk::Image<itk::RGBPixel<unsigned char>, 2> * picture,
                  const DicomResultHeader &                           header,
                  const std::string &                                 path);

/** Writes a surface (LPS, mm) as Encapsulated STL in the frame of reference of the source. `what` is a term for it.
 * Throws InputError as WriteSurface(), OutputError. \ingroup DicomResults */
DicomResults_EXPORT DicomInstance
WriteDicomSurface(const DicomSource &       source,
                  const SurfaceMesh &       mesh,
                  const DicomCode &         what,
                  const DicomResultHeader & header,
                  const std::string &       path);

/** What the values of a map are. \ingroup DicomResults */
struct DicomMapMeaning
{
  DicomCode quantity;
  DicomCode unit;
  /** At most 16 characters. */
  std::string label;
  std::string explanation;
  /** Where in the body. */
  DicomCode region;
};

/** Writes an image as Parametric Map: 32 bits, floating point, a frame for each slice of the source, with a real-world
 * value mapping that leaves the values as they are. Throws InputError for another grid than that of the source,
 * OutputError. \ingroup DicomResults */
DicomResults_EXPORT DicomInstance
WriteDicomMap(const DicomSource &          source,
              const itk::Image<float, 3> * image,
              const DicomMapMeaning &      meaning,
              const DicomResultHeader &    header,
              const std::string &          path);
} // namespace shapeton

#endif
