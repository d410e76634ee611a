#ifndef shapetonSpectralMeasure_h
#define shapetonSpectralMeasure_h

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** A sparse symmetric matrix: a diagonal, and the subtracted weights of pairs of rows. */
struct SymmetricMatrix
{
  struct Entry
  {
    int    row;
    int    column;
    double weight;
  };
  Eigen::VectorXd    diagonal;
  std::vector<Entry> entries; ///< A(row, column) = A(column, row) = -weight

  Eigen::VectorXd
  operator*(const Eigen::VectorXd & x) const;
};

/** \class SpectralMeasure
 * \brief b^T f(A) b as the sum of weight * f(node), for any f: Gauss quadrature by the Lanczos process (Golub and
 * Meurant: Matrices, moments and quadrature, 1994). */
class SpectralMeasure
{
public:
  SpectralMeasure(const SymmetricMatrix & A, const Eigen::VectorXd & b);

  /** b^T exp(-t A) b. */
  double
  Remaining(double t) const;
  /** b^T (1 - exp(-t A)) b, exact to rounding even for small t. */
  double
  Gone(double t) const;

private:
  Eigen::VectorXd m_Nodes;
  Eigen::VectorXd m_Weights;
};
} // namespace shapeton

#endif
