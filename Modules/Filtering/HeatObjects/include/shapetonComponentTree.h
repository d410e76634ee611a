#ifndef shapetonComponentTree_h
#define shapetonComponentTree_h

#include "shapetonVoxelGrid.h"
#include "ShapetonHeatObjectsExport.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class ComponentTree
 * \brief All connected regions {value >= t} of a volume (max-tree), or {value <= t} (min-tree), for all t.
 *
 * Two regions are disjoint, or one contains the other, so they form a tree (Salembier, Oliveras, Garrido 1998). Voxels
 * are neighbors across faces. The region of a voxel is the one with the voxel's value as t. It is a contiguous range of
 * GetVoxels(), so it is found and listed without a search.
 *
 * Regions that contain the same extrema form an arc, as in the merge tree of topological analysis. Arcs are found
 * without sweeping all voxels in order: each voxel climbs to its extremum, and only voxels whose higher neighbors are
 * not connected among themselves can join regions (Carr et al. 2016). Construction is parallel; the result does not
 * depend on the number of threads. Memory: 8 bytes per voxel, 24 during construction.
 *
 * \ingroup ShapetonHeatObjects */
class ShapetonHeatObjects_EXPORT ComponentTree
{
public:
  using Index = std::uint32_t;

  /** Regions with the same extrema, as ranges of GetVoxels(). */
  struct Arc
  {
    Index first;  ///< begin of the smallest region that contains all regions below the arc
    Index begin;  ///< begin of the voxels of the arc itself; first < begin if smaller arcs join here
    Index end;    ///< end of the voxels of the arc
    Index parent; ///< the arc that this one joins; its own number for the root, the last arc
  };

  /** Arcs; each follows those it contains. */
  const std::vector<Arc> &
  GetArcs() const
  {
    return m_Arcs;
  }

  /** Index of each voxel in the volume, region by region; within an arc in the order in which voxels join. */
  const std::vector<Index> &
  GetVoxels() const
  {
    return m_Voxels;
  }

  /** The arc of each voxel of the volume. */
  const std::vector<Index> &
  GetArcOfVoxel() const
  {
    return m_ArcOfVoxel;
  }

private:
  friend class ComponentTreeBuilder;

  std::vector<Arc>   m_Arcs;
  std::vector<Index> m_Voxels;
  std::vector<Index> m_ArcOfVoxel;
};

/** The max-tree and the min-tree of one volume. \ingroup ShapetonHeatObjects */
struct ComponentTrees
{
  ComponentTree maxTree;
  ComponentTree minTree;
};

/** Builds both trees; among equal values, the voxel with the smaller index counts as larger. `values` contains one
 * number per voxel of the grid. Throws InputError if a value is not a number, and ParameterError for an empty grid or
 * more than 2^32 - 1 voxels. \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT ComponentTrees
BuildComponentTrees(const float * values, const VoxelGrid & grid);
} // namespace shapeton

#endif
