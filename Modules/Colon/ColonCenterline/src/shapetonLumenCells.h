#ifndef shapetonLumenCells_h
#define shapetonLumenCells_h

#include "shapetonLumenGrid.h"

namespace shapeton
{
/** The widest place where two cells touch. */
struct CellPassage
{
  int a, b;
  /** Distance to the wall of the widest pair of voxels, mm. */
  float clearance;
  /** The narrower voxel of that pair. */
  int node;
};

/** \class LumenCells
 * \brief The lumen cut into compact cells, each about one inscribed ball.
 *
 * Voxels are visited from the widest to the narrowest. An unclaimed voxel joins the cell of a neighbor, or, if that is
 * far for its radius, becomes the center of a new cell and claims its inscribed ball. So cells never extend through a
 * hole into another loop, whose wider voxels are visited before those of the hole.
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
