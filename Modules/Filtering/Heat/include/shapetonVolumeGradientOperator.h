#ifndef shapetonVolumeGradientOperator_h
#define shapetonVolumeGradientOperator_h

#include "shapetonPaddedGrid.h"
#include "shapetonProgress.h"
#include "shapetonRemarks.h"
#include "shapetonVolumeGradientOptions.h"
#include "shapetonVolumeView.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace shapeton
{
/** Throws ParameterError unless a given window has two finite numbers, the lower one first. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT void
RequireWindow(const std::optional<std::array<double, 2>> & window);

/** The intensity window of the options, or the minimum and maximum of the volume; {0, 0} for an empty one.
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::array<double, 2>
                    WindowOf(const VolumeGradientOptions & options, const VolumeView & volume);

/** Warns if the intensities in the domain span less than 1 % of the window, which leaves no edges to find. The list is
 * empty otherwise. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT Remarks
RemarksOnWindow(const VolumeView & volume, const std::array<double, 2> & window);

/** \class EdgeVolume
 * \brief The smoothed volume in which edges are found, and options with the window set, so that it and any part of it
 * have the same edges as the given volume.
 *
 * \ingroup ShapetonHeat */
struct ShapetonHeat_EXPORT EdgeVolume
{
  EdgeVolume(const VolumeView & given, const VolumeGradientOptions & givenOptions);

  VolumeView            volume;
  VolumeGradientOptions options;
};

/** \class VolumeGradientOperator
 * \brief Edge weights for the diffusion of heat or particles, computed from the intensities of a volume.
 *
 * Between neighbors i and j along axis k, with intensities scaled to [0, 1] by a window,
 *
 *   halfGradient = |I_i - I_j| / res_k,   weight = clamp(1 - p * halfGradient, 0, 1)      (2.5, 2.6)
 *
 * where res_k = h_k / h_min is the distance between the neighbors relative to the smallest spacing, which makes p
 * independent of the unit. On anisotropic grids the Laplacian does not reduce to (2.4):
 * the conductance of an edge is weight * (h_min / h_k)^2 (Physical, the default), the weight alone (Published), or, as
 * printed in (2.4), clamp(D + weight, 0, 1) (Sum). Here D = (h_min / h_k)^2 - 1 is the Laplacian relative to that of a
 * regular grid, where the source drops it. The diffusion uses the conductances; the initial heat uses the weights, or
 * the sums.
 *
 * The volume is extended by one layer that repeats the border intensities (weight 1) and stays at heat 0. The domain of
 * a volume, if it has one, is insulated: edges to other voxels have conductance 0, and weight 1 in the initial heat, so
 * the border of the domain is not an edge. Voxels outside have heat 0.
 *
 * Source: Gurijala, Shape-based analysis, chapter 2. The source does not specify the scaling of I; the window is our
 * interpretation.
 *
 * \ingroup ShapetonHeat */
class ShapetonHeat_EXPORT VolumeGradientOperator
{
public:
  enum class Conductance
  {
    Physical,
    Published,
    Sum
  };

  /** The edges of a volume for the given p, window and smoothing. Throws ParameterError for options out of range,
   * InputError for an empty volume, a spacing that is not positive and intensities that are not finite. If both ends of
   * the window are equal, the volume is treated as constant.
   * \param conductance how the conductances depend on the spacing
   * \param leastWeight weight of an edge with half gradient 1 / p, in [0, 1]; for larger gradients, it decreases with
   * the square of the gradient. With 0, as in (2.5), such edges insulate.
   * \param progress may throw to abort */
  explicit VolumeGradientOperator(const VolumeView &            volume,
                                  const VolumeGradientOptions & options = {},
                                  Conductance                   conductance = Conductance::Physical,
                                  double                        leastWeight = 0.0,
                                  const Progress &              progress = {});

  /** The half gradient for intensities in [0, 1]; `resolution` is res_k >= 1.
   *
   * \equation{2.6}
   *
   * \equation{3.3} */
  static double
  HalfGradient(double a, double b, double resolution)
  {
    return std::abs(a - b) / resolution;
  }

  /** The edge weight in [0, 1]. Rounding residues of a zero weight are set to 0 because they would be leaks. The
   * minimum is leastWeight / max(1, p halfGradient)^2, so an insulated voxel still prefers its more similar neighbors.
   *
   * \equation{2.5}
   *
   * \equation{3.2} */
  static double
  EdgeWeight(double halfGradient, double p, double leastWeight = 0.0)
  {
    const double steps = p * halfGradient;
    const double weight = 1.0 - steps;
    const double least = leastWeight / (steps > 1.0 ? steps * steps : 1.0);
    return std::max(weight > 1e-12 ? weight : 0.0, least);
  }

  const PaddedGrid &
  GetGrid() const
  {
    return m_Grid;
  }
  /** 0 for each voxel outside the domain; null: all voxels are in it. */
  const std::vector<unsigned char> *
  GetDomain() const
  {
    return m_Domain.get();
  }
  /** In the domain. */
  std::size_t
  GetNumberOfVoxels() const;
  /** Distance between neighbors along an axis relative to the smallest spacing. */
  double
  GetResolution(unsigned int axis) const
  {
    return m_Resolution[axis];
  }
  double
  GetLeastWeight() const
  {
    return m_LeastWeight;
  }

  /** Conductances along an axis on the padded grid: entry i belongs to the edge from voxel i to its successor. */
  const float *
  GetConductances(unsigned int axis) const
  {
    return m_Conductances[axis].GetData();
  }
  /** Conductance / weight of the edges along an axis. */
  double
  GetFactor(unsigned int axis) const
  {
    return m_Factors[axis];
  }

  /** (2.3): 1 - S_i / max S, S the sum of the six weights; in [0, 1], 0 everywhere in a constant volume. */
  void
  ComputeInitialHeat(PaddedField & heat) const;

  /** An upper bound of the eigenvalues of the diffusion operator L, (L f)_i = sum_j c_ij (f_i - f_j): 12 on a cubic
   * grid. Gershgorin: twice the largest possible sum of conductances on the grid. */
  double
  GetEigenvalueBound() const;

private:
  void
  ComputeConductances(const EdgeVolume & edges, const Progress & progress);
  void
  InsulateDomain();
  bool
  IsInDomain(std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) const;
  /** Number of faces of a voxel of the domain to voxels outside. */
  float
  FacesOfDomain(std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) const;

  PaddedGrid                                        m_Grid;
  std::shared_ptr<const std::vector<unsigned char>> m_Domain; ///< null: all voxels
  double                                            m_LeastWeight;
  std::array<double, 3>                             m_Resolution{};
  std::array<double, 3>                             m_Factors{};
  std::array<double, 3>                             m_Summands{};
  std::array<PaddedField, 3>                        m_Conductances;
};
} // namespace shapeton

#endif
