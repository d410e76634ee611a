#ifndef shapetonRicciEnergy_h
#define shapetonRicciEnergy_h

#include "shapetonCircleState.h"

#include <utility>

namespace shapeton
{
/** The convex energy of a Ricci flow: its gradient (the curvature) and its Hessian, as functions of the unknowns u.
 *
 * \equation{6.6} by its first and second derivatives. */
class RicciEnergy
{
public:
  explicit RicciEnergy(const RicciUnknowns & unknowns);

  /** Moves the Hessian pattern out; may be called only once. */
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
  /** Largest curvature of an unknown circle. */
  double
  Residual() const
  {
    return m_State.Residual();
  }
  void
  Hessian(std::vector<double> & diagonal, std::vector<double> & offDiagonal);
  /** Radii of the last evaluation. */
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
  /** For the first m_EdgeElements pattern elements the edge of the map, for the others the half-edge of the kite. */
  std::vector<int> m_Source;
  std::size_t      m_EdgeElements{ 0 };
  /** For each half-edge, the contribution of its kite to the diagonal, and to the element of its edge or kite. */
  std::vector<double> m_KiteDiagonal;
  std::vector<double> m_KiteElement;
};
} // namespace shapeton

#endif
