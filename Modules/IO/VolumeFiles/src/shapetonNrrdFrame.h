#ifndef shapetonNrrdFrame_h
#define shapetonNrrdFrame_h

#include "shapetonRemarks.h"

#include <array>
#include <string>

namespace shapeton
{
/** What ITK's reader of NRRD leaves out of the frame of a volume. */
struct NrrdFrame
{
  /** Reads the text header. Throws InputError for directions, an origin or spacings that are not numbers, for
   * left-handed spaces, and for different units of length. */
  explicit NrrdFrame(const std::string & path);

  /** Signs that take coordinates as ITK returns them to LPS. ITK takes the wrong axis of a left-anterior-superior
   * space, and none of spaces with time. */
  std::array<double, 3> signs{ 1.0, 1.0, 1.0 };
  /** Millimeters per unit of length. */
  double millimeters{ 1.0 };
  /** Index of the first stored voxel in the grid of the header: the start of the Segmentation_Extent of 3D Slicer until
   * 2016, otherwise 0. */
  std::array<double, 3> first{};
  Remarks               notes;
};
} // namespace shapeton

#endif
