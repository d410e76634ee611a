#ifndef itkRicciEnergy_h
#define itkRicciEnergy_h

#include "itkCirclePacking.h"

#include <array>
#include <vector>

namespace itk
{
/** A circle by sinh and cosh of its radius; in Euclidean geometry by the radius and 1. Then the formulae of both
 * geometries are the same. */
struct CircleSize
{
  double sinh{ 0.0 };
  double cosh{ 1.0 };
};

/** The convex energy of a Ricci flow: its gradient, which is the curvature, and its Hessian, as functions of the
 * unknowns u. Unknown are the finite nodes, in Euclidean geometry but the one of highest degree, and the finite faces
 * that are not eliminated. */
class RicciEnergy
{
public:
  RicciEnergy(const CombinatorialMap & map, FlowGeometry geometry, const CirclesAtInfinity & infinite);

  int
  Unknowns() const
  {
    return m_Unknowns;
  }
  /** The pattern of the Hessian. */
  const std::vector<std::array<int, 2>> &
  Pattern() const
  {
    return m_Pattern;
  }
  std::vector<double>
  StartingPoint() const;
  /** Computes radii and curvatures. */
  void
  Evaluate(const std::vector<double> & u);
  const std::vector<double> &
  Gradient() const
  {
    return m_Gradient;
  }
  /** The largest curvature of an unknown circle. */
  double
  Residual() const;
  void
  Hessian(std::vector<double> & diagonal, std::vector<double> & offDiagonal);
  /** The radii of the last evaluation. */
  CirclePacking
  Packing() const;

private:
  enum class Kind : char
  {
    Unknown,
    Fixed,
    Eliminated,
    Line,
    Horocycle
  };
  void
  FindKinds(const CirclesAtInfinity & infinite);
  void
  NumberUnknowns();
  void
  BuildPattern();
  bool
  IsEliminated(int face) const
  {
    return m_FaceKind[face] == Kind::Eliminated;
  }
  CircleSize
  SizeOf(double u) const;
  double
  RadiusOf(const CircleSize & size) const;
  CircleSize
  SizeOfEliminated(int face) const;
  double
  CurvatureOfNode(int node) const;
  double
  CurvatureOfFace(int face) const;
  void
  KitesOfFace(int face);
  void
  KitesOfEliminated(int face);
  void
  GatherDiagonal(std::vector<double> & diagonal) const;

  const CombinatorialMap &        m_Map;
  FlowGeometry                    m_Geometry;
  std::vector<Kind>               m_NodeKind;
  std::vector<Kind>               m_FaceKind;
  std::vector<int>                m_NodeUnknown; ///< -1: none
  std::vector<int>                m_FaceUnknown;
  int                             m_Unknowns{ 0 };
  std::vector<std::array<int, 2>> m_Pattern;
  /** The map's edge of each element of the pattern up to m_EdgeElements, then the half-edge of its kite. */
  std::vector<int>        m_Source;
  std::size_t             m_EdgeElements{ 0 };
  std::vector<CircleSize> m_Node;
  std::vector<CircleSize> m_Face;
  std::vector<double>     m_Gradient;
  /** Of each half-edge: what its kite adds to the diagonal, and to the element of its edge or kite. */
  std::vector<double> m_KiteDiagonal;
  std::vector<double> m_KiteElement;
};
} // namespace itk

#endif
