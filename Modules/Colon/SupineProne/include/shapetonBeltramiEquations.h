#ifndef shapetonBeltramiEquations_h
#define shapetonBeltramiEquations_h

#include "ShapetonSupineProneExport.h"

#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <vector>

namespace shapeton
{
/** Positions (mm along and around) on one cylinder of the nodes of another, in row-major order. The coordinate around
 * the cylinder is unwrapped; the last node of a row is followed by the first one plus a turn.
 * \ingroup ShapetonSupineProne */
struct CylinderValues
{
  Eigen::VectorXd along;
  Eigen::VectorXd around;
};

/** \class BeltramiEquations
 * \brief Linear finite elements for maps between cylinders and for the Beltrami coefficients of these maps.
 *
 * A map f of z = x + iy, where x and y are mm along and around the source, satisfies the Beltrami equation df/dz* = mu
 * df/dz, with |mu| < 1 where f preserves orientation and mu = 0 where f is conformal. For a given mu, both coordinates
 * solve div(A grad f) = 0, where det A = 1:
 *
 *   (1 - |mu|^2) A = [ |1 - mu|^2, -2 Im mu; -2 Im mu, |1 + mu|^2 ].
 *
 * Rows are at arbitrary distances, the nodes of a row at equal angles. Each cell is split along the diagonal from (row,
 * angle) to (row + 1, angle + 1), as in CylinderMap. \ingroup ShapetonSupineProne */
class ShapetonSupineProne_EXPORT BeltramiEquations
{
public:
  using Coefficients = std::vector<std::complex<double>>;

  /** Corners of a triangle, with the number of turns (0 or 1) to add to the coordinate around the cylinder. */
  struct Triangle
  {
    std::array<int, 3> node;
    std::array<int, 3> turns;
  };

  /** A point in a triangle, given by barycentric coordinates whose sum is 1. */
  struct Place
  {
    int                   triangle;
    std::array<double, 3> share;
  };

  /** Stiffness matrix of both coordinates, and right-hand side for one turn of the coordinate around the cylinder. */
  struct System
  {
    Eigen::SparseMatrix<double> stiffness;
    Eigen::VectorXd             turn;
  };

  /** \param heights mm between consecutive rows of nodes, along the source.
   * \param angles number of nodes in a row, at least three.
   * \param sourceAround,targetAround circumferences, mm. */
  BeltramiEquations(std::vector<double> heights, int angles, double sourceAround, double targetAround);

  int
  Rows() const
  {
    return static_cast<int>(m_Heights.size()) + 1;
  }
  int
  Angles() const
  {
    return m_Angles;
  }
  int
  Nodes() const
  {
    return this->Rows() * m_Angles;
  }
  int
  Triangles() const
  {
    return 2 * static_cast<int>(m_Heights.size()) * m_Angles;
  }
  /** Circumference of the target, mm. */
  double
  TargetAround() const
  {
    return m_TargetAround;
  }
  /** Corners of even triangles: (row, angle), (row + 1, angle), (row + 1, angle + 1); of odd triangles: (row, angle),
   * (row + 1, angle + 1), (row, angle + 1). */
  Triangle
  TriangleOf(int triangle) const;
  /** Triangle and barycentric coordinates of a position: row in [0, Rows() - 1], angle in [0, Angles()). */
  Place
  PlaceOf(double row, double angle) const;
  /** Area, mm^2. */
  double
  AreaOf(int triangle) const;
  /** Beltrami coefficient of each triangle, with an absolute value above 1 for flipped triangles. `flips` counts
   * flipped and degenerate triangles. */
  Coefficients
  CoefficientsOf(const CylinderValues & values, int & flips) const;
  /** Assembles the system. Absolute values of the coefficients must be below 1. */
  System
  SystemOf(const Coefficients & mu) const;

private:
  using Gradients = Eigen::Matrix<double, 2, 3>;

  /** Gradients of the hat functions of the corners. */
  Gradients
  GradientsOf(int triangle) const;

  std::vector<double> m_Heights;
  int                 m_Angles;
  double              m_Width; ///< mm between nodes of a row
  double              m_TargetAround;
};
} // namespace shapeton

#endif
