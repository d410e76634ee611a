#ifndef shapetonLumenCells_h
#define shapetonLumenCells_h

#include "shapetonLumenGrid.h"

namespace shapeton
{
/** The widest contact between two cells. */
struct CellPassage
{
  int a, b;
  /** Distance from the widest pair of voxels to the wall, mm. */
  float clearance;
  /** The narrower voxel of that pair. */
  int node;
};

/** \class LumenCells
 * \brief Partition of the lumen into compact cells, each about one inscribed ball.
 *
 * Voxels are processed in order of decreasing distance to the wall. An unassigned voxel joins the cell of a neighbor
 * or, if the center of that cell is too far away relative to its radius, becomes the center of a new cell with its
 * inscribed ball. Cells never extend through a hole into another loop, because the wider voxels of that loop are
 * processed before the hole.
 */
struct LumenCells
{
  explicit LumenCells(const LumenGrid & grid);

  int
  NumberOfCells() const
  {
    return static_cast<int>(centers.size());
  }

  /** Volume-weighted median radius of the cells, mm. */
  double
  UsualRadius() const;

  /** Cell of each node. */
  std::vector<int> cellOf;
  /** Nodes at the cell centers. */
  std::vector<int>             centers;
  std::vector<Eigen::Vector3d> positions;
  /** Cell radii, mm. */
  std::vector<double> radii;
  /** Cell volumes, mm^3. */
  std::vector<double> volumes;
  /** Widest first. */
  std::vector<CellPassage> passages;

private:
  void
  Claim(const LumenGrid & grid, int center);
  int
  BestNeighbor(const LumenGrid & grid, int node) const;
  void
  FindPassages(const LumenGrid & grid);
};
} // namespace shapeton

#endif
