#ifndef shapetonHolomorphicForm_h
#define shapetonHolomorphicForm_h

#include "ShapetonConformalFlatteningExport.h"

#include "shapetonConformalMap.h"

#include <vector>

namespace shapeton
{
/** A holomorphic 1-form df + i *df, stored as its integral (dissertation 5.2.2, Figure 5.3 d to f). f is harmonic, 1 on
 * one inner boundary and 0 on all others (5.12); *df is its conjugate. \ingroup ShapetonConformalFlattening */
struct HolomorphicForm
{
  /** Index of the loop on which f is 1. */
  int inner{ -1 };
  /** The surface, cut open from the outer to each inner boundary; the conjugate jumps across these cuts. The surface
   * vertices keep their indices. */
  SurfaceMesh mesh;
  /** f and its conjugate at each vertex of `mesh`. The additive constant of the conjugate is arbitrary. */
  Eigen::MatrixX2d values;
};

/** The forms of all inner boundaries, in the order of the slit maps. f_j and its conjugate are sums of -logRadius and
 * -angle of the slit maps, with the weights that make f_j 1 and 0 on the boundaries. Throws ParameterError unless the
 * domain of the map is ConformalDomain::Slit, because other maps do not include all slit maps.
 * \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT std::vector<HolomorphicForm>
                                   HolomorphicFormsOf(const ConformalMap & map);
} // namespace shapeton

#endif
