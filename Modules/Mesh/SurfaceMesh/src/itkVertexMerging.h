#ifndef itkVertexMerging_h
#define itkVertexMerging_h

#include "itkSurfaceMesh.h"

namespace itk
{
/** Merges vertices at one position, or nearer than `distance` when that is greater than 0, into the first of them,
 * which keeps its position and its arrays. Returns how many vertices went. Faces are kept, degenerate ones too. */
int
MergeVertices(SurfaceMesh & mesh, double distance);
} // namespace itk

#endif
