#ifndef shapetonEmbeddingVerification_h
#define shapetonEmbeddingVerification_h

#include "EmbeddingVerificationExport.h"
#include "shapetonEmbeddingCertificate.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** What a verification found.
 * \ingroup EmbeddingVerification */
struct EmbeddingVerdict
{
  /** Empty: the certificate holds. Else the first thing that is wrong, with node, edge or face and figures. */
  std::string refusal;
  /** What was measured until then, by name: genus, nodes, edges, dummyNodes, faces, tangency, orthogonality, angleSum,
   * smallestRadius, ... Lengths in the geometry of the certificate, angles in radians. */
  std::vector<std::pair<std::string, double>> measures;
};

/** Checks a certificate from its numbers alone; see README.md for what is checked in which order, and why this proves
 * that no two edges cross. Own code for all of it: nothing is shared with the program that computed the certificate.
 * \ingroup EmbeddingVerification */
EmbeddingVerification_EXPORT EmbeddingVerdict
VerifyEmbedding(const EmbeddingCertificate & certificate);
} // namespace shapeton

#endif
