#ifndef shapetonTorusInSpace_h
#define shapetonTorusInSpace_h

#include "ShapetonGraphViewsExport.h"
#include "shapetonEmbeddingCertificate.h"

#include <array>
#include <vector>

namespace shapeton
{
/** \brief Maps a flat torus to the torus ((R + r cos v) cos u, (R + r cos v) sin u, r sin v) in space, the
 * formula printed in section 6.3.3, R = 1.
 *
 * Its conformal types are the rectangles of sides 1 and r / sqrt(R^2 - r^2); r is chosen so that the affine map from
 * the lattice of the graph has the least dilatation (the nearest rectangle in the upper half plane has the same
 * modulus). The longer period runs around the torus. Along the tube, v is a function of the isothermal parameter:
 * tan(v / 2) = sqrt((R + r) / (R - r)) tan(pi s). Orientation is preserved. \ingroup ShapetonGraphViews */
class ShapetonGraphViews_EXPORT TorusInSpace
{
public:
  using Point = std::array<double, 3>;

  /** \pre The certificate has genus 1. It must outlive this object. */
  explicit TorusInSpace(const EmbeddingCertificate & certificate);

  /** Image of a point of the plane. */
  Point
  operator()(const std::complex<double> & z) const;

  double
  TubeRadius() const
  {
    return m_TubeRadius;
  }
  /** Axis ratio of the images of infinitesimal circles under the affine map: 1 for a rectangular lattice. */
  double
  Dilatation() const
  {
    return m_Dilatation;
  }
  /** Period 0 or 1 of the lattice. */
  std::complex<double>
  Period(int i) const
  {
    return i == 0 ? m_W1 : m_W2;
  }
  /** Coordinates of a point of the plane in the basis of the periods. */
  std::array<double, 2>
  Coordinates(const std::complex<double> & z) const;
  /** Nodes and edges of the graph in the plane, see Nodes() and Edges(). */
  std::vector<std::complex<double>>
  FlatNodes() const;
  std::vector<std::vector<std::complex<double>>>
  FlatEdges(int pieces) const;
  /** Positions of the graph's nodes. */
  std::vector<Point>
  Nodes() const;
  /** Curves of the graph's edges, with `pieces` segments per packed edge: geodesics of the flat torus. */
  std::vector<std::vector<Point>>
  Edges(int pieces = 16) const;

private:
  std::complex<double>
  Place(int node) const;
  std::complex<double>
  Along(int halfEdge) const;

  const EmbeddingCertificate & m_Certificate;
  std::complex<double>         m_W1;
  std::complex<double>         m_W2;
  double                       m_TubeRadius;
  double                       m_Dilatation;
};
} // namespace shapeton

#endif
