#ifndef shapetonShapeSignature_h
#define shapetonShapeSignature_h

#include "ShapeSignatureExport.h"
#include "shapetonVoxelRuns.h"

#include "itkImageBase.h"

#include <array>

namespace shapeton
{
/** \class ShapeSignature
 * \brief What the shape of a binary object is like, in numbers that neither place, rotation nor sampling change much.
 *
 * Volume and surface are in mm^3 and mm^2; all else has no unit and does not change with scale. Times are t / r^2, r
 * the radius of the ball of the same volume, and those of Times().
 *
 * Two curves of heat over logarithmic time tell two things apart:
 * - `remainingHeat`: the object is at heat 1, all around at heat 0; the share of its heat that has not left yet (heat
 *   content; van den Berg and Davies, 1989: 1 - S sqrt(4 t / pi) / V + ..., S the surface). It tells how thick the
 *   object is where. The second moment of the heat over the voxels is the same curve at twice the time.
 * - `displacement`: no heat leaves; the mean square of the way, over r^2, between the places where heat is at time 0
 *   and at time t (restricted diffusion; Mitra, Sen and Schwartz, 1993). 6 t / r^2 at first, and in the end twice the
 *   square of the radius of gyration, reached the later the longer the ways within the object are.
 *
 * `spectrum`: the smallest eigenvalues above 0 of the Laplace-Beltrami operator of the surface, times its area
 * (Shape-DNA; Reuter, Wolter and Peinecke, 2006); of an object in pieces, those of the greatest shell.
 *
 * No number tells an object from its mirror image.
 *
 * \ingroup ShapeSignature
 */
struct ShapeSignature_EXPORT ShapeSignature
{
  static constexpr std::size_t NumberOfTimes = 25;
  static constexpr std::size_t NumberOfEigenvalues = 20;
  /** Voxels of the grid that signatures are computed on, in the radius of the ball of the same volume. */
  static constexpr double RadiusInVoxels = 16.0;
  /** Fewer voxels have no shape. */
  static constexpr std::size_t LeastVoxels = 64;

  using Curve = std::array<double, NumberOfTimes>;

  double volume{ 0.0 };  ///< mm^3: voxels times their volume
  double surface{ 0.0 }; ///< mm^2: of the level 0.5 of the smoothed object, all shells
  /** Standard deviations of the object along its principal axes, the longest over the middle and the middle over the
   * shortest; from 1. */
  double                                  elongation{ 1.0 };
  double                                  flatness{ 1.0 };
  Curve                                   remainingHeat{}; ///< from 1 down; 0 below 1e-9
  Curve                                   displacement{};  ///< above 0, ascending
  std::array<double, NumberOfEigenvalues> spectrum{};      ///< above 0, ascending; 8 pi is the first one of a sphere

  /** t / r^2: half octaves from 0.004 to 16.4. */
  static const Curve &
  Times();
};

/** The signature of a set of voxels of an image.
 *
 * The set is sampled on an isotropic grid along its principal axes, whose voxels are r / RadiusInVoxels wide, as the
 * share of each voxel that it fills: voxels of the image are spread by quadratic B-splines, so that stairs are smooth
 * and the volume is kept. Heat flows there as the share allows: where it stays, a face conducts as much as the emptier
 * of its voxels is filled; where it leaves, the boundary lies where the share passes 0.5 (symmetric second order
 * scheme; Gibou, Fedkiw, Cheng and Kang, 2002). Sums over the object for all times follow from one Lanczos process
 * (Golub and Meurant, 1994), so no time step is taken: HeatDiffusionSolver, whose edges insulate and which gives the
 * heat of each voxel, serves neither.
 *
 * It takes about half a second; more for sets of millions of voxels. Any number of threads gives the same bytes. Throws
 * InputError when the set has fewer than LeastVoxels, is thinner than a voxel of the grid nearly everywhere, or so long
 * that the grid does not fit into memory; std::invalid_argument when its size is not that of the image.
 *
 * \ingroup ShapeSignature */
ShapeSignature_EXPORT ShapeSignature
ComputeShapeSignature(const VoxelRuns & shape, const itk::ImageBase<3> * image);
} // namespace shapeton

#endif
