#ifndef shapetonEmbeddingCertificate_h
#define shapetonEmbeddingCertificate_h

#include "ShapetonEmbeddingCertificateExport.h"
#include "shapetonRemarks.h"
#include "shapetonCombinatorialMap.h"

#include <complex>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Geometry of the surface: unit sphere (genus 0), plane (genus 1) or hyperbolic plane of curvature -1 (genus 2 or
 * higher). \ingroup ShapetonEmbeddingCertificate */
enum class EmbeddingGeometry
{
  Spherical,
  Euclidean,
  Hyperbolic
};

/** \brief A side of the fundamental polygon: the deck transformation applied when a half-edge is crossed.
 *
 * `z -> (a z + b) / (conj(b) z + conj(a))` with |a|^2 - |b|^2 = 1 in the Poincare disk, `z -> z + b` (a = 1) in the
 * plane. It maps the frame of the end node of `halfEdge` to the frame reached from its start node along `halfEdge`.
 * \ingroup ShapetonEmbeddingCertificate */
struct DeckTransformation
{
  /** A half-edge of the packed map. */
  int                  halfEdge{ -1 };
  std::complex<double> a{ 1.0 };
  std::complex<double> b{ 0.0 };
};

/** \brief An embedded graph and its circle pattern: all data needed to verify or draw it.
 *
 * Half-edge 2e starts at the first node of edge e, half-edge 2e + 1 at the second; each face is to the left of its
 * half-edges. A rotation lists the outgoing half-edges of one node after another, each in counter-clockwise order. Each
 * node's list has as many entries as its degree; loops count twice.
 *
 * **The packed map** is the graph plus dummy nodes and edges that make it 3-connected. It is connected and has the
 * genus of the surface. Nodes below `graph.nodes` are graph nodes, the others are dummies. Edge e of the graph and edge
 * e of the packed map have the same start node. They also have the same end node unless `subdivided` contains a path
 * for e (a loop or a parallel edge, which circle packings do not allow). All other edges are dummies. If there are no
 * dummies, the packed map equals the graph.
 *
 * **Circles**: one for each packed node and one for each face. Faces are numbered by their lowest half-edge. The two
 * end circles and the two face circles of an edge are tangent at the same point. Node and face circles that meet are
 * orthogonal. A place is
 * - on the sphere a unit vector, the center of a cap, with the cap angle in (0, pi) as radius;
 * - in the plane and in the Poincare disk a complex number (x, y), with a Euclidean or hyperbolic length as radius.
 *   Each node has one lift; a face is placed next to the lift of the node where its lowest half-edge starts.
 *
 * Units: radians on the sphere; in the plane any unit.
 * \ingroup ShapetonEmbeddingCertificate */
struct EmbeddingCertificate
{
  std::vector<std::pair<std::string, std::string>> provenance;
  Remarks                                          warnings;

  Graph            graph;
  std::vector<int> rotation; /**< rotation of the half-edges of `graph` */
  int              genus{ 0 };

  EmbeddingGeometry geometry{ EmbeddingGeometry::Spherical };

  Graph            packed;         /**< without names */
  std::vector<int> packedRotation; /**< rotation of the half-edges of `packed` */
  /** Path of a graph edge in the packed map: the half-edges from its start node to its end node. The first is 2e for
   * edge e; inner nodes are dummies. */
  std::vector<std::vector<int>> subdivided;

  std::vector<double> nodeRadii;     /**< one for each packed node */
  std::vector<double> nodePositions; /**< 3 (sphere) or 2 numbers for each packed node */
  std::vector<double> faceRadii;     /**< one for each face of the packed map */
  std::vector<double> facePositions; /**< 3 or 2 numbers for each face */

  /** \name Plane and disk only; empty on the sphere. */
  ///@{
  /** For each packed node, the direction of the first half-edge in its rotation, in the chart at the node's place
   * (radians). */
  std::vector<double> nodeAngles;
  /** For each packed node, the half-edge from its parent in the tree of lifts, or -1 for the root. No deck
   * transformation applies along the tree. */
  std::vector<int> tree;
  /** The 2g deck transformations. Together with the tree, their edges cut the surface into one disk. */
  std::vector<DeckTransformation> generators;
  /** Boundary word of that disk, 4g letters: k + 1 for generator k, -(k + 1) for its inverse. The product of the
   * transformations in this order is the identity. */
  std::vector<int> word;
  /** Words A1, B1, ..., Ag, Bg in the letters of `word`: A1 B1 A1^-1 B1^-1 ... is freely equal to `word` up to cyclic
   * rotation. Empty if no canonical polygon was requested. */
  std::vector<std::vector<int>> canonicalWords;
  /** Plane: a reduced basis w1, w2 of the lattice, Im(conj(w1) w2) > 0, as numbers x1, y1, x2, y2. */
  std::vector<double> periods;
  ///@}

  /** Informational statistics, recomputed by a verifier: residual, smallestRadius, ... */
  std::vector<std::pair<std::string, double>> statistics;
};

/** Number of coordinates of a place: 3 on the sphere, else 2. \ingroup ShapetonEmbeddingCertificate */
inline int
CoordinatesOf(EmbeddingGeometry geometry)
{
  return geometry == EmbeddingGeometry::Spherical ? 3 : 2;
}

/** Reference length for circle sizes: a torus period, otherwise 1. \ingroup ShapetonEmbeddingCertificate */
ShapetonEmbeddingCertificate_EXPORT double
UnitOfSurface(const EmbeddingCertificate & certificate);

/** Radius of the smallest node circle of the graph, in units of UnitOfSurface().
 * \ingroup ShapetonEmbeddingCertificate */
ShapetonEmbeddingCertificate_EXPORT double
SmallestCircle(const EmbeddingCertificate & certificate);

/** "spherical", "euclidean", "hyperbolic".
 * \ingroup ShapetonEmbeddingCertificate */
ShapetonEmbeddingCertificate_EXPORT std::string
                                    NameOf(EmbeddingGeometry geometry);

/** Rotation of the graph implied by a rotation of the packed map: skips dummies and contracts subdivided edges. Throws
 * InputError if the packed map does not match the graph. \ingroup ShapetonEmbeddingCertificate */
ShapetonEmbeddingCertificate_EXPORT std::vector<int>
                                    RotationOfGraph(const EmbeddingCertificate & certificate);

/** Converts between a map and its rotation as one list of half-edges. The second function throws InputError if the list
 * is not a rotation of the graph. \ingroup ShapetonEmbeddingCertificate */
///@{
ShapetonEmbeddingCertificate_EXPORT std::vector<int>
                                    FlatRotation(const CombinatorialMap & map);
ShapetonEmbeddingCertificate_EXPORT CombinatorialMap
MapOfRotation(const Graph & graph, const std::vector<int> & rotation);
///@}

/** Writes a certificate as JSON in a streaming fashion, without a copy in memory. Numbers are round-trip exact. Throws
 * OutputError, and std::invalid_argument if a number is not finite. \ingroup ShapetonEmbeddingCertificate */
ShapetonEmbeddingCertificate_EXPORT void
WriteEmbeddingCertificate(const EmbeddingCertificate & certificate, const std::string & path);

/** Reads a file written by WriteEmbeddingCertificate. Checks only that list sizes are consistent and indices are in
 * range. Throws InputError with the file name and the location or entry. \ingroup ShapetonEmbeddingCertificate */
ShapetonEmbeddingCertificate_EXPORT EmbeddingCertificate
ReadEmbeddingCertificate(const std::string & path);
} // namespace shapeton

#endif
