#ifndef shapetonTopologyPreservingGrowth_h
#define shapetonTopologyPreservingGrowth_h

#include "ColonWallExport.h"

#include "itkImage.h"

#include <cstdint>

namespace shapeton
{
/** Non-zero voxels belong to the object. \ingroup ColonWall */
using LumenMaskImage = itk::Image<unsigned char, 3>;
/** Which voxels are taken first. \ingroup ColonWall */
using GrowthRankImage = itk::Image<std::uint16_t, 3>;

/** Whether a voxel can change sides without any change of topology.
 *
 * Object voxels are connected by faces (6+), background voxels by faces and edges (18). That pair, and no other one, is
 * the topology of the surface that marching cubes of VTK (vtkFlyingEdges3D, vtkMarchingCubes) makes of a binary volume:
 * where four voxels of a square alternate, its table keeps the inner ones apart. So the surface of a mask has exactly
 * the components, cavities and handles of the mask.
 *
 * Bertrand, Malandain: A new characterization of three-dimensional simple points (1994): the topological numbers
 * T6+ of the object and T18 of the background are both 1.
 *
 * \param neighbourhood the 27 voxels around it, bit x + 3 y + 9 z for x, y, z in 0..2; bit 13, itself, does not matter.
 * \ingroup ColonWall */
ColonWall_EXPORT bool
IsSimplePoint(std::uint32_t neighbourhood);

/** Numbers of an object of voxels; beyond the image there is background. \ingroup ColonWall */
struct MaskTopology
{
  std::int64_t voxels{ 0 };
  /** Connected by faces. */
  std::int64_t components{ 0 };
  /** Enclosed components of the background, which is connected by faces and edges. */
  std::int64_t cavities{ 0 };
  /** components - handles + cavities; half the Euler number of its surface. */
  std::int64_t eulerNumber{ 0 };
  /** The sum of the genera of its surfaces. */
  std::int64_t handles{ 0 };
};

/** Counts components, cavities and handles; linear time. \ingroup ColonWall */
ColonWall_EXPORT MaskTopology
TopologyOfMask(const LumenMaskImage * mask);

/** Grows an object inside a limit without any change of its topology.
 *
 * Only simple points are added, those of the greatest rank first, of equal ones the one that was met first; a voxel
 * that was refused is asked again whenever a neighbour has been added. So the result is the same for equal input, and
 * at its end no voxel of the limit can be added. Where two fronts meet without being able to join, a membrane one voxel
 * thick is left, where the ranks are lowest.
 *
 * \param grown the seed, in and out; voxels of the seed stay even outside the limit.
 * \param limit voxels that may be added.
 * \param ranks 0 to 65535.
 * \return how many voxels were added. One thread; about 0.2 microseconds for each voxel that is added.
 * Throws std::invalid_argument when the sizes differ.
 * \ingroup ColonWall */
ColonWall_EXPORT std::int64_t
GrowByTopologyPreservingPoints(LumenMaskImage * grown, const LumenMaskImage * limit, const GrowthRankImage * ranks);
} // namespace shapeton

#endif
