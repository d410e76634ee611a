#ifndef shapetonConformalDomain_h
#define shapetonConformalDomain_h

namespace shapeton
{
/** Target domain of a conformal map. \ingroup ShapetonConformalFlattening */
enum class ConformalDomain
{
  /** For one boundary, a rectangle with four corners. For several, the logarithm of the slit map: a strip, cut open
   * from the outer to the inner boundary, with slits as segments of constant u. */
  Rectangle,
  /** One outer and one inner boundary: concentric circles. */
  Annulus,
  /** One outer and any number of inner boundaries: an annulus with concentric circular slits, one map for each choice
   * of the boundary that becomes the inner circle. */
  Slit
};
} // namespace shapeton

#endif
