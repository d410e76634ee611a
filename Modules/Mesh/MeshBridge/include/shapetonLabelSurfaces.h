#ifndef shapetonLabelSurfaces_h
#define shapetonLabelSurfaces_h

#include "ShapetonMeshBridgeExport.h"

#include "shapetonSurfaceMesh.h"

#include "itkImage.h"

#include <vector>

namespace shapeton
{
/** Surfaces of the voxels with each of the given labels, in the given order: closed and oriented outward, LPS in mm; no
 * faces for a label without voxels.
 *
 * The surface passes midway between voxel centers inside and outside (marching cubes, vtkFlyingEdges3D), also at the
 * border of the image, then SmoothSurface() moves each vertex along its normal and along the surface by at most half of
 * the smallest voxel spacing, so it stays between these centers. The result does not depend on the number of threads.
 * \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT std::vector<SurfaceMesh>
SurfacesOfLabels(const itk::Image<unsigned short, 3> * image, const std::vector<unsigned short> & labels);
} // namespace shapeton

#endif
