#ifndef shapetonGasPieces_h
#define shapetonGasPieces_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonColonVolume.h"
#include "shapetonVoxelRuns.h"

namespace shapeton
{
/** A connected piece of gas. */
struct GasPiece
{
  std::size_t     voxels{ 0 };
  double          ml{ 0.0 };
  VoxelBox        box;
  Eigen::Vector3d centre{ 0.0, 0.0, 0.0 }; ///< LPS
  double          mean{ 0.0 };             ///< HU
  double          radius{ 0.0 };           ///< of the largest ball in it, mm; 0 below 0.5 ml
  double          inside{ 0.0 };           ///< mean HU at least 3 mm deep, or in its deepest part
  bool            isOutside{ false };      ///< air that belongs to the outside, though a slice encloses it
  bool            isCut{ false }; ///< the border of the image cuts it, its caudal one not counted beside outside air
};

/** All gas of a volume, and which part of it lies outside the body. Entry 0 of `pieces` stands for the air outside. */
struct GasOfVolume
{
  VoxelRuns             set;
  RunLabels             labels; ///< 0: outside
  std::vector<GasPiece> pieces;
  std::vector<char>     isOutsideRun;
};

/** Voxels below `seed`. Air is outside where a slice shows it at the border of the image and the border is at least as
 * long as 0.6 of its edge inside the image, or a quarter of the image's own border: the way around a convex body is
 * never shorter than the body's own outline, measured along rows and columns, while gas in a bowel that the border cuts
 * has a long wall and a short cut. Slices are looked at one by one because an open rectal tube joins the rectum to the
 * room. A piece that opens to the outside across slices with more than a quarter of its largest section belongs to it,
 * too. A piece that mostly ends, in front or behind, at a thin shell over such air belongs to it: tables, cushions.
 * The natal cleft is outside, too. Air that holds one of the `kept` voxels is not outside. */
GasOfVolume
FindGas(const ColonGrid & grid, const VoxelValues & hu, double seed, const std::vector<std::array<int, 3>> & kept);

/** Fills in `radius` and `inside` of pieces from 0.5 ml on. */
void
MeasureDepth(const ColonGrid & grid, const VoxelValues & hu, GasOfVolume & gas);
struct MeasuredPiece
{
  double ml{ 0.0 };
  double radius{ 0.0 }; ///< mm
};

/** Volume and inscribed radius of a piece together with some voxels. */
MeasuredPiece
MeasureTogether(const ColonGrid &                       grid,
                const GasOfVolume &                     gas,
                int                                     piece,
                const std::vector<std::array<int, 3>> & voxels);
} // namespace shapeton

#endif
