#ifndef shapetonViewerVolume_h
#define shapetonViewerVolume_h

#include "shapetonColonViewer.h"
#include "shapetonPageBlocks.h"
#include "shapetonSurfaceMesh.h"

#include "itkImage.h"

namespace shapeton
{
/** The volumes of a position, on one grid. */
struct ViewerVolume
{
  /** The CT (HU) that the page shows first, or a mask. */
  itk::Image<float, 3>::ConstPointer shown;
  /** The cleansed CT, if `shown` is the original CT; otherwise null. */
  itk::Image<float, 3>::ConstPointer cleansed;
  bool                               isCt{ true };
  /** Whether `shown` is a cleansed CT. */
  bool isCleansed{ false };
};

/** Adds the bounding box of these points in a volume, with a margin of 15 mm, to the blocks as `name`. The header holds
 * the geometry (LPS, with oblique directions), the place of the box in the image (`first`, `whole`, voxels), the HU of
 * codes (lowest, step, the code `knee`, and the step above it), and the block size of the means. Block `name`Coarse
 * holds a byte per block: 1 if its voxels are means, that is, farther than `options.near` from the lumen. With a
 * cleansed CT, `name`CleansedAt and `name`Cleansed hold the voxels that differ and their codes. */
void
PutViewerVolume(PageBlocks &                         blocks,
                const std::string &                  name,
                const ViewerVolume &                 volume,
                const itk::Image<unsigned char, 3> & lumen,
                const VertexMatrix &                 points,
                const ColonViewerOptions &           options);
} // namespace shapeton

#endif
