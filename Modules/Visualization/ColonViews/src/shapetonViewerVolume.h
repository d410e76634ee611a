#ifndef shapetonViewerVolume_h
#define shapetonViewerVolume_h

#include "shapetonColonViewer.h"
#include "shapetonPageBlocks.h"
#include "shapetonSurfaceMesh.h"

#include "itkImage.h"

namespace shapeton
{
/** Adds the bounding box of these points in a volume, with a margin of 15 mm, to the blocks as `name`. The header holds
 * the geometry (LPS, with oblique directions), the HU of a stored value (offset and step), and the block size of the
 * means. Block `name`Coarse holds a byte per block: 1 if its voxels are means, that is, farther than `options.near`
 * from the lumen. Without a CT the volume is a mask. */
void
PutViewerVolume(PageBlocks &                         blocks,
                const std::string &                  name,
                const itk::Image<float, 3> &         volume,
                const itk::Image<unsigned char, 3> & lumen,
                const VertexMatrix &                 points,
                bool                                 isCt,
                const ColonViewerOptions &           options);
} // namespace shapeton

#endif
