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
};

/** Metadata with which 3D Slicer reads a label map in NRRD format as a segmentation (`.seg.nrrd`) with names and
 * colors: one binary labelmap layer whose segments all have the extent of the image. Source: the entries that
 * vtkMRMLSegmentationStorageNode of 3D Slicer reads. \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT VolumeMetadata
SegmentMetadata(const itk::ImageBase<3> * labels, const std::vector<Segment> & segments);
} // namespace shapeton

#endif
