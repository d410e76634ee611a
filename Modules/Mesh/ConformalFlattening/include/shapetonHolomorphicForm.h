#ifndef shapetonHolomorphicForm_h
#define shapetonHolomorphicForm_h

#include "ConformalFlatteningExport.h"

#include "shapetonConformalMap.h"

#include <vector>

namespace shapeton
{
/** A holomorphic 1-form df + i *df by its integral (dissertation 5.2.2, Figure 5.3 d to f): f is harmonic, 1 on one
 * inner boundary and 0 on all others (5.12), *df is its conjugate. \ingroup ConformalFlattening */
struct HolomorphicForm
{
  /** The element of the loops on which f is 1. */
  int inner{ -1 };
  /** The surface, cut open from the outer to each inner boundary: across these cuts the conjugate jumps. The vertices
   * of the surface keep their numbers. */
  SurfaceMesh mesh;
  /** For each vertex of `mesh` f and its conjugate, which is 0 at no particular place. */
  Eigen::MatrixX2d values;
};

/** The forms of all inner boundaries, in the order of the slit maps. f_j and its conjugate are sums of -logRadius and
 * -angle of the slit maps with the same weights, those with which f_j is 1 and 0 on the boundaries. Throws
 * ParameterError for a map of another domain than ConformalDomain::Slit, which does not hold all slit maps.
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT std::vector<HolomorphicForm>
                           HolomorphicFormsOf(const ConformalMap & map);
} // namespace shapeton

#endif
