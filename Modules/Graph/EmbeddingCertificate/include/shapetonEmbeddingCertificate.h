#ifndef shapetonEmbeddingCertificate_h
#define shapetonEmbeddingCertificate_h

#include "EmbeddingCertificateExport.h"
#include "shapetonRemarks.h"
#include "shapetonCombinatorialMap.h"

#include <array>
#include <complex>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** The geometry of the surface: that of the unit sphere (genus 0), of the plane (genus 1) or of the hyperbolic plane of
 * curvature -1 (genus 2 and more).
 * \ingroup EmbeddingCertificate */
enum class EmbeddingGeometry
{
  Spherical,
  Euclidean,
  Hyperbolic
};

/** \brief A side of the fundamental polygon: the deck transformation that is met when a half-edge is crossed.
 *
 * `z -> (a z + b) / (conj(b) z + conj(a))` with |a|^2 - |b|^2 = 1 in the Poincare disk, `z -> z + b` (a = 1) in the
 * plane. It takes the frame of the end node of `halfEdge` to the frame that is reached when one walks along `halfEdge`
 * from the frame of its start node.
 * \ingroup EmbeddingCertificate */
struct DeckTransformation
{
  /** Of the packed map. */
  int                  halfEdge{ -1 };
  std::complex<double> a{ 1.0 };
  std::complex<double> b{ 0.0 };
};

/** \brief A graph on a surface and the pattern of circles that carries it: all that a verifier or a picture needs.
 *
 * Half-edge 2e leaves the first node of edge e, 2e + 1 the second one; a face lies to the left of its half-edges. A
 * rotation lists, node after node, the half-edges that leave the node, counter-clockwise; the length of a node's
 * list is its degree, a loop counted twice.
 *
 * **The packed map** is the graph with dummy nodes and edges that make it 3-connected. It is connected and its genus is
 * that of the surface. Nodes below `graph.nodes` are those of the graph, the others are dummies. Edge e below the
 * number of edges of the graph has the same start node as edge e of the graph, and also the same end node unless a path
 * in `subdivided` says otherwise (a loop or one of several parallel edges, which no circle packing of the sphere has).
 * All other edges are dummies. Without dummies the packed map equals the graph.
 *
 * **Circles**: one for each packed node and one for each face. Faces are numbered in the order of their lowest
 * half-edge. The circles of the ends of an edge are tangent, so are those of the faces beside it, at the same point;
 * the circle of a node and that of a face that meet are orthogonal. A place is
 * - on the sphere a unit vector, the centre of a cap, and the radius is its angle in (0, pi);
 * - in the plane and in the Poincare disk a complex number (x, y), the radius a length in the plane, or of hyperbolic
 *   geometry. A node has one place, its lift; a face lies beside the lift of the start node of its lowest half-edge.
 *
 * Units: radians on the sphere; in the plane any unit.
 * \ingroup EmbeddingCertificate */
struct EmbeddingCertificate
{
  std::vector<std::pair<std::string, std::string>> provenance;
  Remarks                                          warnings;

  Graph            graph;
  std::vector<int> rotation; /**< of the half-edges of `graph` */
  int              genus{ 0 };

  EmbeddingGeometry geometry{ EmbeddingGeometry::Spherical };

  Graph            packed;         /**< without names */
  std::vector<int> packedRotation; /**< of the half-edges of `packed` */
  /** For an edge of the graph that is a path of the packed map: the half-edges from its start node to its end node; the
   * first is 2e for edge e. Its inner nodes are dummies. */
  std::vector<std::vector<int>> subdivided;

  std::vector<double> nodeRadii;     /**< one for each packed node */
  std::vector<double> nodePositions; /**< 3 (sphere) or 2 numbers for each packed node */
  std::vector<double> faceRadii;     /**< one for each face of the packed map */
  std::vector<double> facePositions; /**< 3 or 2 numbers for each face */

  /** \name Plane and disk alone; empty on the sphere. */
  ///@{
  /** For each packed node the direction, in the chart at its place, of the first half-edge of its rotation. Radians. */
  std::vector<double> nodeAngles;
  /** For each packed node the half-edge that leads to it from its parent, -1 for the root. The lifts of the nodes
   * follow this tree: walking along it one meets no deck transformation. */
  std::vector<int> tree;
  /** 2g transformations. With the tree, their edges cut the surface into one disk. */
  std::vector<DeckTransformation> generators;
  /** The boundary of that disk, 4g letters: k + 1 for generator k, -(k + 1) for its inverse. The product of the
   * transformations in this order is the identity. */
  std::vector<int> word;
  /** Words A1, B1, ..., Ag, Bg in the letters of `word`: A1 B1 A1^-1 B1^-1 ... is freely equal to `word` or to a cyclic
   * rotation of it. Empty where no canonical polygon was asked for. */
  std::vector<std::vector<int>> canonicalWords;
  /** In the plane: a reduced basis w1, w2 of the lattice, Im(conj(w1) w2) > 0, as numbers x1, y1, x2, y2. */
  std::vector<double> periods;
  ///@}

  /** Facts that are stated for readers and that a verifier measures itself: residual, smallestRadius, ... */
  std::vector<std::pair<std::string, double>> statistics;
};

/** The number of coordinates of a place: 3 on the sphere, else 2.
 * \ingroup EmbeddingCertificate */
inline int
CoordinatesOf(EmbeddingGeometry geometry)
{
  return geometry == EmbeddingGeometry::Spherical ? 3 : 2;
}

/** What circles are small beside: a period of the torus, else 1.
 * \ingroup EmbeddingCertificate */
EmbeddingCertificate_EXPORT double
UnitOfSurface(const EmbeddingCertificate & certificate);

/** The radius of the smallest circle of a node of the graph, in that unit.
 * \ingroup EmbeddingCertificate */
EmbeddingCertificate_EXPORT double
SmallestCircle(const EmbeddingCertificate & certificate);

/** "spherical", "euclidean", "hyperbolic".
 * \ingroup EmbeddingCertificate */
EmbeddingCertificate_EXPORT std::string
                            NameOf(EmbeddingGeometry geometry);

/** The rotation of the half-edges of the graph that a rotation of the packed map implies: dummies left out, subdivided
 * edges taken as one. Throws InputError when the packed map does not fit the graph.
 * \ingroup EmbeddingCertificate */
EmbeddingCertificate_EXPORT std::vector<int>
                            RotationOfGraph(const EmbeddingCertificate & certificate);

/** The rotation of a map as one list; the map of a list that names each half-edge once. The second throws InputError
 * when the list is no rotation of the graph. \ingroup EmbeddingCertificate */
///@{
EmbeddingCertificate_EXPORT std::vector<int>
                            FlatRotation(const CombinatorialMap & map);
EmbeddingCertificate_EXPORT CombinatorialMap
MapOfRotation(const Graph & graph, const std::vector<int> & rotation);
///@}

/** Writes a certificate as JSON, number by number, so that a million nodes need no copy in memory. Numbers read back as
 * they were. Throws OutputError, and std::invalid_argument for a number that is not finite.
 * \ingroup EmbeddingCertificate */
EmbeddingCertificate_EXPORT void
WriteEmbeddingCertificate(const EmbeddingCertificate & certificate, const std::string & path);

/** Reads what WriteEmbeddingCertificate wrote. The sizes of all lists are checked against each other and all indices
 * are in range; nothing else is. Throws InputError that names the file and the place or the entry.
 * \ingroup EmbeddingCertificate */
EmbeddingCertificate_EXPORT EmbeddingCertificate
ReadEmbeddingCertificate(const std::string & path);
} // namespace shapeton

#endif
