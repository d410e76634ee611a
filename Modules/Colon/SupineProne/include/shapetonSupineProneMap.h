#ifndef shapetonSupineProneMap_h
#define shapetonSupineProneMap_h

namespace shapeton
{
/** Method that computes the map from correspondences. \ingroup ShapetonSupineProne */
enum class SupineProneMap
{
  /** Warping, correction by consistent folds and taeniae, projection to a bijection. */
  Default,
  /** As in the dissertation (4.3, 5.4.2; Zeng, Marino, Gurijala, Gu, Kaufman 2010): folds are matched once, per
   * segment, after a conformal map constrained by flexures and the main taenia. The final map is quasi-conformal with
   * hard constraints at flexures, this taenia and the ends of all matched folds, correct or not. Triangles may be
   * flipped. See FindQuasiConformalMap(). */
  Published
};
} // namespace shapeton

#endif
