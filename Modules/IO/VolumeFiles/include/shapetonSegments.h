#ifndef shapetonSegments_h
#define shapetonSegments_h

#include "ShapetonVolumeFilesExport.h"

#include "itkImageBase.h"
#include "shapetonVolumeWriter.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** A segment of a label map.
 * \ingroup ShapetonVolumeFiles */
struct Segment
{
  unsigned int          label{ 0 }; ///< of its voxels; at least 1
  std::string           name;
  std::array<double, 3> color{}; ///< red, green, blue, each in [0, 1]
  /** Tags of 3D Slicer with its terms of anatomy; empty for a tissue without a more specific term. */
  std::string tags{};
};

/** Metadata with which 3D Slicer reads a label map in NRRD format as a segmentation (`.seg.nrrd`) with names and
 * colors: one binary labelmap layer whose segments all have the extent of the image. Source: the entries that
 * vtkMRMLSegmentationStorageNode of 3D Slicer reads. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT VolumeMetadata
SegmentMetadata(const itk::ImageBase<3> * labels, const std::vector<Segment> & segments);

/** The segments that the header of a NRRD file names, in the order of the file; empty for other files.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT std::vector<Segment>
                           SegmentsOfFile(const std::string & path);
} // namespace shapeton

#endif
