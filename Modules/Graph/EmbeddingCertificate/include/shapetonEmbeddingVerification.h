#ifndef shapetonEmbeddingVerification_h
#define shapetonEmbeddingVerification_h

#include "ShapetonEmbeddingCertificateExport.h"
#include "shapetonEmbeddingCertificate.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Result of a verification. \ingroup ShapetonEmbeddingCertificate */
struct EmbeddingVerdict
{
  /** Empty if the certificate is valid; otherwise the first error, with its node, edge or face and the measured values.
   */
  std::string refusal;
  /** Values measured before the first error, by name: genus, nodes, edges, dummyNodes, faces, tangency, orthogonality,
   * angleSum, smallestRadius, ... Lengths are in the geometry of the certificate, angles in radians. */
  std::vector<std::pair<std::string, double>> measures;
};

/** Verifies a certificate from its numbers alone; see README.md for the checks and for the proof that no two edges
 * cross. The implementation is independent of the embedding code.
 * \ingroup ShapetonEmbeddingCertificate */
ShapetonEmbeddingCertificate_EXPORT EmbeddingVerdict
VerifyEmbedding(const EmbeddingCertificate & certificate);
} // namespace shapeton

#endif
