#ifndef shapetonPrincipalAxes_h
#define shapetonPrincipalAxes_h

#include "ShapetonColonLumenExport.h"

#include <Eigen/Core>

namespace shapeton
{
/** \class PrincipalAxes
 * \brief Eigenvalues and unit eigenvectors of a symmetric 2 x 2 matrix, such as a covariance, smallest first.
 *
 * A separate class, to compile Eigen's solver only once.
 *
 * \ingroup ShapetonColonLumen */
class ShapetonColonLumen_EXPORT PrincipalAxes
{
public:
  /** Uses only the lower triangle. */
  explicit PrincipalAxes(const Eigen::Matrix2d & symmetric);

  Eigen::Vector2d values;  ///< ascending
  Eigen::Matrix2d vectors; ///< one per column
};
} // namespace shapeton

#endif
