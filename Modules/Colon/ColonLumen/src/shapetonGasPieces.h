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
  Eigen::Vector3d center{ 0.0, 0.0, 0.0 }; ///< LPS
  double          mean{ 0.0 };             ///< HU
  double          radius{ 0.0 };           ///< of the largest ball inside, mm; 0 below 0.5 ml
  double          inside{ 0.0 };           ///< mean HU at least 3 mm deep, or in its deepest part
  bool            isOutside{ false };      ///< outside air, even if enclosed in a slice
  bool            isCut{ false }; ///< cut by the border of the image, except by its caudal one next to outside air
};

/** All gas of a volume, and its part outside the body. Entry 0 of `pieces` is the air outside. */
struct GasOfVolume
{
  VoxelRuns             set;
  RunLabels             labels; ///< 0: outside
  std::vector<GasPiece> pieces;
  std::vector<char>     isOutsideRun;
};

/** Finds voxels below `seed`. Air is outside if in a slice it touches the border of the image and this border is at
 * least
 * 0.6 times as long as its edge inside the image, or a quarter of the image border. The path around a convex body is
 * never shorter than the outline of the body, measured along rows and columns, while gas in a bowel cut by the border
 * has a long wall and a short cut. Slices are tested one by one because an open rectal tube connects the rectum to the
 * room. A piece that opens to the outside across slices with more than a quarter of its largest section is outside,
 * too, and so is a piece that mostly ends, in front or behind, at a thin shell over outside air: tables, cushions. The
 * natal cleft is outside, too. Air that contains one of the `kept` voxels is not outside. */
GasOfVolume
FindGas(const ColonGrid & grid, const VoxelValues & hu, double seed, const std::vector<std::array<int, 3>> & kept);

/** Sets `radius` and `inside` of pieces of at least 0.5 ml. */
void
MeasureDepth(const ColonGrid & grid, const VoxelValues & hu, GasOfVolume & gas);
struct MeasuredPiece
{
  double ml{ 0.0 };
  double radius{ 0.0 }; ///< mm
};

/** Volume and inscribed radius of a piece together with additional voxels. */
MeasuredPiece
MeasureTogether(const ColonGrid &                       grid,
                const GasOfVolume &                     gas,
                int                                     piece,
                const std::vector<std::array<int, 3>> & voxels);
} // namespace shapeton

#endif
