#ifndef shapetonShapeSignature_h
#define shapetonShapeSignature_h

#include "ShapetonShapeSignatureExport.h"
#include "shapetonVoxelRuns.h"

#include "itkImageBase.h"

#include <array>

namespace shapeton
{
/** \class ShapeSignature
 * \brief Shape descriptor of a binary object, nearly invariant to position, rotation and sampling.
 *
 * Volume and surface are in mm^3 and mm^2; all other measures are dimensionless and scale-invariant. Times are t / r^2,
 * where r is the radius of the ball with the same volume; see Times().
 *
 * Two curves of heat over logarithmic time:
 * - `remainingHeat`: the object starts at heat 1 and its surroundings stay at 0; the curve is the remaining fraction of
 *   its heat (heat content; van den Berg and Davies, 1989: 1 - S sqrt(4 t / pi) / V + ..., S the surface). It measures
 *   local thickness. The second moment of the heat over the voxels equals this curve at twice the time.
 * - `displacement`: the mean squared displacement of heat in an insulated object, over r^2, from time 0 to time t
 *   (restricted diffusion; Mitra, Sen and Schwartz, 1993). 6 t / r^2 initially, and finally twice the squared radius of
 *   gyration,
 *   reached later in objects with longer internal paths.
 *
 * `spectrum`: the smallest eigenvalues above 0 of the Laplace-Beltrami operator of the surface, times its area
 * (Shape-DNA; Reuter, Wolter and Peinecke, 2006); for a disconnected object, computed from the largest shell.
 *
 * Mirror images have equal signatures.
 *
 * \ingroup ShapetonShapeSignature */
struct ShapetonShapeSignature_EXPORT ShapeSignature
{
  static constexpr std::size_t NumberOfTimes = 25;       // of each curve
  static constexpr std::size_t NumberOfEigenvalues = 20; // of the spectrum
  /** Radius of the ball with the same volume, in voxels of the grid on which signatures are computed. */
  static constexpr double RadiusInVoxels = 16.0;
  /** Smallest number of voxels for which a signature is computed. */
  static constexpr std::size_t LeastVoxels = 64;

  using Curve = std::array<double, NumberOfTimes>;

  double volume{ 0.0 };  ///< mm^3: voxels times their volume
  double surface{ 0.0 }; ///< mm^2, at level 0.5 of the smoothed object, all shells
  /** Ratios of the standard deviations along the principal axes: longest to middle, and middle to shortest; at least
   * 1. */
  double                                  elongation{ 1.0 };
  double                                  flatness{ 1.0 };
  Curve                                   remainingHeat{}; ///< descending from 1; 0 below 1e-9
  Curve                                   displacement{};  ///< above 0, ascending
  std::array<double, NumberOfEigenvalues> spectrum{};      ///< above 0, ascending; for a sphere the first one is 8 pi

  /** t / r^2: half octaves from 0.004 to 16.4. */
  static const Curve &
  Times();
};

/** The signature of a set of voxels of an image.
 *
 * The set is resampled as the filled fraction of each voxel of an isotropic grid along its principal axes, with voxels
 * r / RadiusInVoxels wide. Image voxels are spread by quadratic B-splines, which smooths stair steps and preserves the
 * volume. For the displacement, the conductance of a face is the smaller fraction of its two voxels; for the remaining
 * heat, the boundary is where the fraction crosses 0.5 (symmetric second order scheme; Gibou, Fedkiw, Cheng and Kang,
 * 2002). One Lanczos process yields the sums over the object for all times (Golub and Meurant, 1994), without time
 * steps. HeatDiffusionSolver is not suitable because its edges insulate and it computes the heat of each voxel.
 *
 * The run time is about half a second, more for millions of voxels. Results are bitwise identical for any number of
 * threads. Throws InputError if the set has fewer than LeastVoxels, is thinner than a grid voxel nearly everywhere, or
 * is so long that the grid does not fit into memory. Throws std::invalid_argument if its size is not that of the image.
 *
 * \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT ShapeSignature
ComputeShapeSignature(const VoxelRuns & shape, const itk::ImageBase<3> * image);
} // namespace shapeton

#endif
