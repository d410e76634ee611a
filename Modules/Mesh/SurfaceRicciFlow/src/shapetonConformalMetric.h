#ifndef shapetonConformalMetric_h
#define shapetonConformalMetric_h

#include "shapetonIntrinsicTriangulation.h"
#include "shapetonRicciFlowWords.h"

namespace shapeton
{
/** Derivatives of curvatures on the pattern of a triangulation. */
struct CurvatureDerivatives
{
  Eigen::VectorXd diagonal; ///< for each vertex of the triangulation
  Eigen::VectorXd ofEdges;  ///< for each edge, between its two ends
};

/** \class ConformalMetric
 * \brief The metrics of a discrete conformal class, as functions of u at the vertices, with curvatures and derivatives.
 *
 * - VertexScaling: the edge with Penner coordinate c has the chord c exp((u_a + u_b) / 2), which is the length l
 *   (Euclidean) or 2 sinh(l / 2) (hyperbolic): Springborn, Schroeder, Pinkall 2008; Bobenko, Pinkall, Springborn 2015.
 *   SetFactors() makes the chords Delaunay by Ptolemy flips, which exist for all u. The condition cos + cos' >= 0 for
 *   the angles opposite to an edge is the same in both geometries: on its border, the chords of the two triangles have
 *   equal circumcircles.
 * - InversiveDistance: u = log r or log tanh(r / 2); l^2 = r_a^2 + r_b^2 + 2 I r_a r_b, or cosh l = cosh r_a cosh r_b +
 *   I sinh r_a sinh r_b (Bowers, Stephenson 2004; Guo 2011; dissertation 6.2.4 with cos of the intersection angle for
 *   I). No flips. */
class ConformalMetric
{
public:
  /** \param invariants for each edge: Penner coordinates or inversive distances. */
  ConformalMetric(IntrinsicTriangulation triangulation,
                  Eigen::VectorXd        invariants,
                  RicciScheme            scheme,
                  RicciGeometry          geometry);

  /** Flips edges until the Euclidean lengths, which are the invariants, are Delaunay. Returns the number of flips. */
  int
  MakeDelaunay();

  /** Applies `u`, one value per vertex. Returns false if an edge or a face violates its inequality; then only further
   * calls of SetFactors() are allowed. */
  bool
  SetFactors(const Eigen::VectorXd & u);

  /** Multiplies all lengths by a factor, that is, adds its logarithm to u. \pre Euclidean geometry. */
  void
  ScaleLengths(double factor)
  {
    m_Lengths *= factor;
    m_Chords *= factor;
  }

  /** Angle sums of the vertices. */
  Eigen::VectorXd
  AngleSums() const;

  /** Derivatives of the negative angle sums with respect to u. */
  CurvatureDerivatives
  Derivatives() const;

  const IntrinsicTriangulation &
  Triangulation() const
  {
    return m_Triangulation;
  }
  const Eigen::VectorXd &
  Invariants() const
  {
    return m_Invariants;
  }
  /** Lengths of the edges for the current u. */
  const Eigen::VectorXd &
  Lengths() const
  {
    return m_Lengths;
  }
  RicciGeometry
  Geometry() const
  {
    return m_Geometry;
  }
  /** Flipped sides, in their order. */
  const std::vector<int> &
  Flips() const
  {
    return m_Flips;
  }
  /** Number of times the triangulation changed. */
  int
  Changes() const
  {
    return m_Changes;
  }

private:
  double
  ConvexityOf(int edge) const;
  int
  FlipToDelaunay(bool isEuclidean);
  double
  LengthOfEdge(int edge, const Eigen::VectorXd & u, std::array<double, 2> & derivatives) const;

  IntrinsicTriangulation             m_Triangulation;
  Eigen::VectorXd                    m_Invariants;
  RicciScheme                        m_Scheme;
  RicciGeometry                      m_Geometry;
  Eigen::VectorXd                    m_Chords, m_Lengths;
  std::vector<std::array<double, 2>> m_LengthDerivatives; ///< with respect to u at origin and end of SideOf(edge)
  std::vector<std::array<double, 3>> m_Tangents;          ///< half-angle tangents of the faces
  std::vector<int>                   m_Flips;
  int                                m_Changes{ 0 };
};

/** Length of the other diagonal of the quadrilateral around a side's edge by Ptolemy's relation, for edge lengths that
 * are chords or Penner coordinates. */
double
PtolemyDiagonal(const IntrinsicTriangulation & triangulation, const Eigen::VectorXd & lengths, int side);

/** Inversive distances of circles around the vertices, and log r or log tanh(r / 2). The radius of a vertex is the mean
 * over its faces of (a + b - c) / 2 with the adjacent sides a and b and the opposite side c (Chow and Luo 2003, as in
 * Zeng and Gu 2013). */
struct InversivePacking
{
  Eigen::VectorXd distances;
  Eigen::VectorXd u;
};
InversivePacking
MakeInversivePacking(const IntrinsicTriangulation & triangulation,
                     const Eigen::VectorXd &        lengths,
                     RicciGeometry                  geometry);
} // namespace shapeton

#endif
