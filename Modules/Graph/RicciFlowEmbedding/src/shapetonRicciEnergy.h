#ifndef shapetonRicciEnergy_h
#define shapetonRicciEnergy_h

#include "shapetonCircleState.h"

#include <utility>

namespace shapeton
{
/** The convex energy of a Ricci flow: its gradient, which is the curvature, and its Hessian, as functions of the
 * unknowns u.
 *
 * \equation{6.6} by its first and second derivatives. */
class RicciEnergy
{
public:
  explicit RicciEnergy(const RicciUnknowns & unknowns);

  /** The pattern of the Hessian, once: nothing else needs it. */
  std::vector<std::array<int, 2>>
  TakePattern()
  {
    return std::move(m_Pattern);
  }
  /** Computes radii and curvatures. */
  void
  Evaluate(const std::vector<double> & u)
  {
    m_State.Evaluate(u);
  }
  const std::vector<double> &
  Gradient() const
  {
    return m_State.Gradient();
  }
  /** The largest curvature of an unknown circle. */
  double
  Residual() const
  {
    return m_State.Residual();
  }
  void
  Hessian(std::vector<double> & diagonal, std::vector<double> & offDiagonal);
  /** The radii of the last evaluation. */
  CirclePacking
  Packing() const
  {
    return m_State.Packing();
  }

private:
  void
  BuildPattern();
  void
  KitesOfFace(int face);
  void
  KitesOfEliminated(int face);
  void
  GatherDiagonal(std::vector<double> & diagonal) const;

  const RicciUnknowns &           m_Unknowns;
  const CombinatorialMap &        m_Map;
  CircleState<double>             m_State;
  std::vector<std::array<int, 2>> m_Pattern;
  /** The map's edge of each element of the pattern up to m_EdgeElements, then the half-edge of its kite. */
  std::vector<int> m_Source;
  std::size_t      m_EdgeElements{ 0 };
  /** Of each half-edge: what its kite adds to the diagonal, and to the element of its edge or kite. */
  std::vector<double> m_KiteDiagonal;
  std::vector<double> m_KiteElement;
};
} // namespace shapeton

#endif
