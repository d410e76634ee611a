#ifndef shapetonTopologyPreservingGrowth_h
#define shapetonTopologyPreservingGrowth_h

#include "ShapetonColonModelExport.h"

#include "itkImage.h"

#include <cstdint>

namespace shapeton
{
/** Mask of the object (nonzero voxels). \ingroup ShapetonColonModel */
using LumenMaskImage = itk::Image<unsigned char, 3>;
/** Growth priority of each voxel. \ingroup ShapetonColonModel */
using GrowthRankImage = itk::Image<std::uint16_t, 3>;

/** Whether changing a voxel preserves the topology.
 *
 * Object voxels are connected by faces (6+), background voxels by faces and edges (18). Only this pair is consistent
 * with VTK's marching cubes (vtkFlyingEdges3D, vtkMarchingCubes), which separates the inner voxels of an ambiguous
 * face. The surface of a mask thus has exactly the components, cavities and handles of the mask.
 *
 * Bertrand, Malandain: A new characterization of three-dimensional simple points (1994): the topological numbers
 * T6+ of the object and T18 of the background are both 1.
 *
 * \param neighborhood the 27 voxels as bits x + 3 y + 9 z for x, y, z in 0..2; bit 13, the center, is ignored.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT bool
IsSimplePoint(std::uint32_t neighborhood);

/** Topological numbers of a voxel object; voxels outside the image are background. \ingroup ShapetonColonModel */
struct MaskTopology
{
  std::int64_t voxels{ 0 };
  /** Face-connected components. */
  std::int64_t components{ 0 };
  /** Enclosed 18-connected components of the background. */
  std::int64_t cavities{ 0 };
  /** components - handles + cavities; half the Euler number of its surface. */
  std::int64_t eulerNumber{ 0 };
  /** Sum of the genera of the surfaces. */
  std::int64_t handles{ 0 };
};

/** Counts components, cavities and handles in linear time. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT MaskTopology
TopologyOfMask(const LumenMaskImage * mask);

/** Grows an object within a limit without changing its topology.
 *
 * Simple points are added in order of decreasing rank; ties are resolved in order of discovery, so the result is
 * deterministic. A rejected voxel is tested again each time a neighbor is added, so that no more voxels can be added at
 * the end. Where two fronts cannot join, a membrane one voxel thick remains at the lowest ranks.
 *
 * \param grown the seed on input, the result on output; seed voxels remain even outside the limit.
 * \param limit voxels that may be added.
 * \param ranks 0 to 65535.
 * \return the number of voxels added. Single-threaded; about 0.2 microseconds per added voxel. Throws
 * std::invalid_argument if the sizes differ.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::int64_t
GrowByTopologyPreservingPoints(LumenMaskImage * grown, const LumenMaskImage * limit, const GrowthRankImage * ranks);
} // namespace shapeton

#endif
