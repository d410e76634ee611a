#ifndef shapetonRicciFlowWords_h
#define shapetonRicciFlowWords_h

namespace shapeton
{
/** Family of discrete conformal metrics. \ingroup ShapetonSurfaceRicciFlow */
enum class RicciScheme
{
  /** Edge lengths scaled by factors at both ends, with flips. */
  VertexScaling,
  /** Circles around the vertices whose inversive distances are preserved. */
  InversiveDistance
};

/** Geometry of the triangles. \ingroup ShapetonSurfaceRicciFlow */
enum class RicciGeometry
{
  /** By topology. */
  Auto,
  Euclidean,
  /** Curvature -1. */
  Hyperbolic,
  /** Curvature 1. */
  Spherical
};

/** Geodesic curvature of boundaries. \ingroup ShapetonSurfaceRicciFlow */
enum class RicciBoundary
{
  Auto,
  Straight,
  Even
};
} // namespace shapeton

#endif
