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
  double          radius{ 0.0 };           ///< of the largest inscribed ball, mm; 0 for pieces below 0.5 ml
  double          inside{ 0.0 };           ///< mean HU of the voxels at least 3 mm deep, or of the deepest part
  bool            isOutside{ false };      ///< outside air, even if enclosed in a slice
  bool            isCut{ false };          ///< cut by the image border, except by the caudal border next to outside air
};

/** All gas of a volume. Entry 0 of `pieces` is the air outside the body. */
struct GasOfVolume
{
  VoxelRuns             set;
  RunLabels             labels; ///< 0: outside
  std::vector<GasPiece> pieces;
  std::vector<char>     isOutsideRun;
};

/** Finds voxels below `seed`. Air is outside if it touches the image border in a slice and this contact is at least 0.6
 * times as long as the edge of the air inside the image, or at least a quarter of the image border. For air around a
 * convex body, the contact is at least as long as the body outline, measured along rows and columns; for gas in a
 * truncated bowel, it is short. Slices are tested separately because an open rectal tube connects the rectum to the
 * room. The following are also outside: pieces with an opening to the outside, across slices, larger than a quarter of
 * their largest section; pieces mostly behind a thin shell next to outside air (tables, cushions); and the natal cleft.
 * Air that contains one of the `kept` voxels is not outside. */
GasOfVolume
FindGas(const ColonGrid & grid, const VoxelValues & hu, double seed, const std::vector<std::array<int, 3>> & kept);

/** Sets `radius` and `inside` of pieces with a volume of at least 0.5 ml. */
void
MeasureDepth(const ColonGrid & grid, const VoxelValues & hu, GasOfVolume & gas);
struct MeasuredPiece
{
  double ml{ 0.0 };
  double radius{ 0.0 }; ///< mm
};

/** Volume and inscribed radius of a piece extended by additional voxels. */
MeasuredPiece
MeasureTogether(const ColonGrid &                       grid,
                const GasOfVolume &                     gas,
                int                                     piece,
                const std::vector<std::array<int, 3>> & voxels);
} // namespace shapeton

#endif
