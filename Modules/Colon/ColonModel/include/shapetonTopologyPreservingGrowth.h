#ifndef shapetonTopologyPreservingGrowth_h
#define shapetonTopologyPreservingGrowth_h

#include "ShapetonColonModelExport.h"

#include "itkImage.h"

#include <cstdint>

namespace shapeton
{
/** Nonzero voxels belong to the object. \ingroup ShapetonColonModel */
using LumenMaskImage = itk::Image<unsigned char, 3>;
/** Growth priority of each voxel. \ingroup ShapetonColonModel */
using GrowthRankImage = itk::Image<std::uint16_t, 3>;

/** Whether changing a voxel preserves the topology.
 *
 * Object voxels are connected by faces (6+), background voxels by faces and edges (18). Only this pair matches the
 * surface that VTK's marching cubes (vtkFlyingEdges3D, vtkMarchingCubes) extracts from a binary volume: where the four
 * voxels of a square alternate, its table keeps the inner ones apart. So the surface of a mask has exactly the
 * components, cavities and handles of the mask.
 *
 * Bertrand, Malandain: A new characterization of three-dimensional simple points (1994): the topological numbers
 * T6+ of the object and T18 of the background are both 1.
 *
 * \param neighborhood the 27 voxels around it, bit x + 3 y + 9 z for x, y, z in 0..2; bit 13, the center, is ignored.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT bool
IsSimplePoint(std::uint32_t neighborhood);

/** Topological numbers of a voxel object; voxels beyond the image are background. \ingroup ShapetonColonModel */
struct MaskTopology
{
  std::int64_t voxels{ 0 };
  /** Face-connected components. */
  std::int64_t components{ 0 };
  /** Enclosed components of the background, which is connected by faces and edges. */
  std::int64_t cavities{ 0 };
  /** components - handles + cavities; half the Euler number of its surface. */
  std::int64_t eulerNumber{ 0 };
  /** The sum of the genera of its surfaces. */
  std::int64_t handles{ 0 };
};

/** Counts components, cavities and handles; linear time. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT MaskTopology
TopologyOfMask(const LumenMaskImage * mask);

/** Grows an object within a limit without changing its topology.
 *
 * Only simple points are added, those of the greatest rank first; ties are added in the order they were met. A rejected
 * voxel is tested again whenever a neighbor has been added. So equal input gives equal output, and at the end no voxel
 * of the limit can be added. Where two fronts meet without being able to join, a membrane one voxel thick remains,
 * where the ranks are lowest.
 *
 * \param grown the seed, in and out; voxels of the seed stay even outside the limit.
 * \param limit voxels that may be added.
 * \param ranks 0 to 65535.
 * \return the number of voxels added. One thread; about 0.2 microseconds per added voxel.
 * Throws std::invalid_argument when the sizes differ.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::int64_t
GrowByTopologyPreservingPoints(LumenMaskImage * grown, const LumenMaskImage * limit, const GrowthRankImage * ranks);
} // namespace shapeton

#endif
