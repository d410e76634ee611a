#ifndef shapetonLumenCells_h
#define shapetonLumenCells_h

#include "shapetonLumenGrid.h"

namespace shapeton
{
/** A place where two cells touch, at its widest. */
struct CellPassage
{
  int a, b;
  /** Distance to the wall of the widest pair of voxels, mm. */
  float clearance;
  /** The narrower one of that pair. */
  int node;
};

/** \class LumenCells
 * \brief The lumen cut into compact cells, each about one inscribed ball.
 *
 * Voxels are taken from the widest to the narrowest: one that no cell has claimed joins the cell of a neighbour, or
 * where that is far for its radius becomes the centre of a new cell and claims its inscribed ball. So cells never reach
 * through a hole into another loop, whose wider voxels are taken before those of the hole.
 */
struct LumenCells
{
  explicit LumenCells(const LumenGrid & grid);

  int
  NumberOfCells() const
  {
    return static_cast<int>(centres.size());
  }

  /** Radius (mm) of the cell in the middle of the volume. */
  double
  UsualRadius() const;

  /** Of each node. */
  std::vector<int> cellOf;
  /** Nodes. */
  std::vector<int>             centres;
  std::vector<Eigen::Vector3d> positions;
  /** mm. */
  std::vector<double> radii;
  /** mm^3. */
  std::vector<double> volumes;
  /** The widest first. */
  std::vector<CellPassage> passages;

private:
  void
  Claim(const LumenGrid & grid, int centre);
  int
  BestNeighbour(const LumenGrid & grid, int node) const;
  void
  FindPassages(const LumenGrid & grid);
};
} // namespace shapeton

#endif
