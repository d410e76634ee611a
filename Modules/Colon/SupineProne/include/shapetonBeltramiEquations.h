#ifndef shapetonBeltramiEquations_h
#define shapetonBeltramiEquations_h

#include "ShapetonSupineProneExport.h"

#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <vector>

namespace shapeton
{
/** Positions of the nodes of one cylinder on another, along each row, row by row: mm along and around. The coordinate
 * around is continuous; the node after the last one of a row is the first one, a whole turn farther.
 * \ingroup ShapetonSupineProne */
struct CylinderValues
{
  Eigen::VectorXd along;
  Eigen::VectorXd around;
};

/** \class BeltramiEquations
 * \brief Maps between cylinders and their Beltrami coefficients, by linear finite elements.
 *
 * A map f of z = x + iy, x mm along the source and y mm around it, has the Beltrami coefficient mu with
 * df/dz* = mu df/dz; |mu| < 1 where it preserves the orientation, 0 where it is conformal. Both coordinates of the map
 * with a given mu solve div(A grad f) = 0, with A of determinant 1:
 *
 *   (1 - |mu|^2) A = [ |1 - mu|^2, -2 Im mu; -2 Im mu, |1 + mu|^2 ].
 *
 * Nodes are in rows at any distance, at equal angles; each cell is cut along the diagonal from (row, angle) to
 * (row + 1, angle + 1), as in CylinderMap. \ingroup ShapetonSupineProne */
class ShapetonSupineProne_EXPORT BeltramiEquations
{
public:
  using Coefficients = std::vector<std::complex<double>>;

  /** Corners of a triangle, and for each the whole turns (0 or 1) to add to its coordinate around. */
  struct Triangle
  {
    std::array<int, 3> node;
    std::array<int, 3> turns;
  };

  /** A point in a triangle: barycentric coordinates, with sum 1. */
  struct Place
  {
    int                   triangle;
    std::array<double, 3> share;
  };

  /** Stiffness matrix of both coordinates, and the right-hand side of one turn for the coordinate around. */
  struct System
  {
    Eigen::SparseMatrix<double> stiffness;
    Eigen::VectorXd             turn;
  };

  /** \param heights mm between consecutive rows of nodes, along the source.
   * \param angles number of nodes of a row, at least three.
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
  /** Even triangles have the corners (row, angle), (row + 1, angle), (row + 1, angle + 1), odd ones (row, angle),
   * (row + 1, angle + 1), (row, angle + 1). */
  Triangle
  TriangleOf(int triangle) const;
  /** The triangle and coordinates of a place between nodes: row in [0, Rows() - 1], angle in [0, Angles()). */
  Place
  PlaceOf(double row, double angle) const;
  /** Area, mm^2. */
  double
  AreaOf(int triangle) const;
  /** Beltrami coefficient of each triangle; its absolute value is above 1 where the map flips it. `flips` counts
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
