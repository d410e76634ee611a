#ifndef shapetonVolumeGradientOperator_h
#define shapetonVolumeGradientOperator_h

#include "shapetonPaddedGrid.h"
#include "shapetonProgress.h"
#include "shapetonVolumeGradientOptions.h"

#include <array>
#include <cmath>
#include <vector>

namespace shapeton
{
/** \class VolumeGradientOperator
 * \brief Edge weights for the diffusion of heat or particles, computed from the intensities of a volume.
 *
 * Between neighbors i and j along axis k, with intensities scaled to [0, 1] by a window,
 *
 *   halfGradient = |I_i - I_j| / res_k,   weight = clamp(1 - p * halfGradient, 0, 1)      (2.5, 2.6)
 *
 * where res_k = h_k / h_min is the distance between the neighbors relative to the smallest spacing, which makes p
 * independent of the unit. On anisotropic grids the Laplacian does not reduce to (2.4):
 * the conductance of an edge is weight * (h_min / h_k)^2 (Physical, the default; (2.4) writes a sum instead of a
 * product) or the weight alone (Published). The diffusion uses the conductances; the initial heat uses the weights.
 *
 * The volume is extended by one layer that repeats the border intensities (weight 1) and stays at heat 0.
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
    Published
  };

  struct Parameters
  {
    /** Steepness; non-negative. An edge insulates if the half gradient reaches 1 / p. */
    double p{ VolumeGradientOptions().p };
    /** Intensities that map to 0 and to 1 (lower < upper); intensities outside are clamped. */
    double lower{ 0.0 };
    double upper{ 1.0 };
    /** Voxel spacing in mm along x, y, z; positive. Use {1, 1, 1} to ignore it. */
    std::array<double, 3> spacing{ { 1.0, 1.0, 1.0 } };
    Conductance           conductance{ Conductance::Physical };
    /** Weight of an edge with half gradient 1 / p, in [0, 1]; beyond, it decreases with the square of the gradient.
     * With 0, as in (2.5), such edges insulate. Default 0. */
    double leastWeight{ 0.0 };
  };

  /** \param intensities size[0] * size[1] * size[2] values, x fastest. Throws std::invalid_argument for parameters out
   * of range and for non-finite intensities. If lower == upper the volume is treated as constant. `progress` may
   * throw to abort. */
  VolumeGradientOperator(const float *                      intensities,
                         const std::array<std::size_t, 3> & size,
                         const Parameters &                 parameters,
                         const Progress &                   progress = {});

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
  const Parameters &
  GetParameters() const
  {
    return m_Parameters;
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
  ComputeConductances(const float * intensities, const Progress & progress);

  PaddedGrid                 m_Grid;
  Parameters                 m_Parameters;
  std::array<double, 3>      m_Resolution{};
  std::array<double, 3>      m_Factors{};
  std::array<PaddedField, 3> m_Conductances;
};

/** The intensity window of the options, or the minimum and maximum of `number` intensities; {0, 0} for none.
 * \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::array<double, 2>
                    WindowOf(const VolumeGradientOptions & options, const float * intensities, std::size_t number);
} // namespace shapeton

#endif
