#ifndef shapetonChecks_h
#define shapetonChecks_h

#include "shapetonEmbeddingVerification.h"
#include "shapetonTracedMap.h"

#include <algorithm>

namespace shapeton
{
using Measures = std::vector<std::pair<std::string, double>>;

/** \name Each throws Refusal when its part of the certificate does not hold, and appends what it measured. */
///@{
/** The packed map holds the graph: its edges, its paths and its rotation, with dummies inside its faces alone. */
void
CheckMap(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures);
/** On the sphere: the packed map is 3-connected, without which a pattern of circles does not exist. */
void
CheckPackingExists(const TracedMap & packed);
void
CheckSphere(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures);
void
CheckPlane(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures);
void
CheckDisk(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures);
/** Genus 1 and more: tree and generators cut the surface into a disk, whose boundary is the word; canonical words. */
void
CheckCutGraph(const EmbeddingCertificate & certificate, const TracedMap & packed);
///@}

/** The figure of a message: three digits. */
std::string
Figure(double value);

/** The first radius that is not in (least, most). */
void
RequireRadii(const std::vector<double> & radii, double least, double most, const std::string & what);

/** Throws Refusal unless at each node and each face the angles of the kites sum to 2 pi; `tolerance` is that of a
 * circle. Returns the largest deviation. */
double
RequireAngleSums(const std::vector<double> & angleSums,
                 const std::vector<double> & tolerance,
                 const std::string &         what);

/** A curved or flat direction: the sums of the angles of kites at the nodes and at the faces; `HalfAngle(r, s)` is half
 * the angle, at the centre of the circle of radius r, of the kite with a circle of radius s. */
template <typename HalfAngle>
void
SumKiteAngles(const EmbeddingCertificate & certificate,
              const TracedMap &            packed,
              const HalfAngle &            halfAngle,
              std::vector<double> &        ofNodes,
              std::vector<double> &        ofFaces)
{
  ofNodes.assign(certificate.nodeRadii.size(), 0.0);
  ofFaces.assign(certificate.faceRadii.size(), 0.0);
  for (int h = 0; h < packed.HalfEdges(); ++h)
  {
    const double ofNode = certificate.nodeRadii[packed.node[h]];
    const double ofFace = certificate.faceRadii[packed.face[h]];
    ofNodes[packed.node[h]] += 2.0 * halfAngle(ofNode, ofFace);
    ofFaces[packed.face[h]] += 2.0 * halfAngle(ofFace, ofNode);
  }
}

/** In plane and disk: the kites around each circle fit; radii are right to their scale there. Appends how well, and the
 * smallest radius of a node of the graph. */
template <typename HalfAngle>
void
CheckKiteAngles(const EmbeddingCertificate & certificate,
                const TracedMap &            packed,
                const HalfAngle &            halfAngle,
                Measures &                   measures)
{
  constexpr double    mostError = 1e-10;
  std::vector<double> ofNodes;
  std::vector<double> ofFaces;
  SumKiteAngles(certificate, packed, halfAngle, ofNodes, ofFaces);
  const double atNodes = RequireAngleSums(ofNodes, std::vector<double>(ofNodes.size(), mostError), "node");
  const double atFaces = RequireAngleSums(ofFaces, std::vector<double>(ofFaces.size(), mostError), "face");
  measures.emplace_back("angleSum", std::max(atNodes, atFaces));
  const auto end = certificate.nodeRadii.begin() + certificate.graph.nodes;
  measures.emplace_back("smallestRadius", *std::min_element(certificate.nodeRadii.begin(), end));
}

/** In plane and disk: the direction of each half-edge in the chart at its node, one kite after the other. */
template <typename HalfAngle>
std::vector<double>
DirectionsOfHalfEdges(const EmbeddingCertificate & certificate, const TracedMap & packed, const HalfAngle & halfAngle)
{
  std::vector<double> directions(packed.HalfEdges(), 0.0);
  for (int node = 0; node < packed.nodes; ++node)
  {
    const int first = packed.firstOfNode[node];
    double    angle = certificate.nodeAngles[node];
    int       h = first;
    do
    {
      directions[h] = angle;
      angle += 2.0 * halfAngle(certificate.nodeRadii[node], certificate.faceRadii[packed.face[h]]);
      h = packed.next[h];
    } while (h != first);
  }
  return directions;
}
} // namespace shapeton

#endif
