#ifndef shapetonChecks_h
#define shapetonChecks_h

#include "shapetonEmbeddingVerification.h"
#include "shapetonTracedMap.h"

#include <algorithm>

namespace shapeton
{
using Measures = std::vector<std::pair<std::string, double>>;

/** \name Each check throws Refusal if its part of the certificate is invalid, and appends its measurements. */
///@{
/** Checks that the packed map contains the graph: edges, paths and rotation, with dummies only inside its faces. */
void
CheckMap(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures);
/** Checks, for the sphere, that the packed map is 3-connected, which is necessary for a circle pattern. */
void
CheckPackingExists(const TracedMap & packed);
void
CheckSphere(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures);
void
CheckPlane(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures);
void
CheckDisk(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures);
/** Checks, for genus 1 or higher, that the tree and the generators cut the surface into a disk bounded by the word;
 * also checks the canonical words. */
void
CheckCutGraph(const EmbeddingCertificate & certificate, const TracedMap & packed);
///@}

/** Formats a number with three digits, for a message. */
std::string
Figure(double value);

/** Throws Refusal for the first radius outside (least, most). */
void
RequireRadii(const std::vector<double> & radii, double least, double most, const std::string & what);

/** Throws Refusal unless the kite angles at each node and each face sum to 2 pi within `tolerance` per circle. Returns
 * the largest deviation. */
double
RequireAngleSums(const std::vector<double> & angleSums,
                 const std::vector<double> & tolerance,
                 const std::string &         what);

/** Sums of kite angles at the nodes and at the faces, in flat or hyperbolic geometry. `HalfAngle(r, s)` is half the
 * kite angle at the center of a circle of radius r, for an orthogonal circle of radius s. */
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

/** Checks, in the plane and the disk, that the kites around each circle close up. Appends the deviation and the
 * smallest node radius of the graph. */
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

/** Direction of each half-edge in the chart at its node, in the plane or the disk, obtained by adding kite angles. */
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
