#ifndef shapetonViewerVolume_h
#define shapetonViewerVolume_h

#include "shapetonColonViewer.h"
#include "shapetonPageBlocks.h"

#include "itkImage.h"

namespace shapeton
{
/** Puts the box of a volume that holds these points, with a margin of 15 mm, into the blocks as `name`. The header
 * tells geometry (LPS, with oblique directions), the HU of a stored value (offset and step), and the size of the blocks
 * whose voxels are means; block `name`Coarse holds a byte for each of these: 1 where they are means, which are those
 * farther than `options.near` from the lumen. Without a CT the volume is a mask. */
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
