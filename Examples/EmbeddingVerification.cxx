// Verifies the certificate of an embedding, and rejects one in which a circle is too large.
// Usage: ExampleEmbeddingVerification
#include "shapetonEmbeddingVerification.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"

#include <iostream>

int
main()
{
  const shapeton::Graph          graph = shapeton::CompleteGraph(8); // of genus 2: hyperbolic
  shapeton::EmbeddingCertificate certificate = shapeton::EmbedGraph(graph, shapeton::FindEmbedding(graph).map);
  for (int i = 0; i < 2; ++i)
  {
    const shapeton::EmbeddingVerdict verdict = shapeton::VerifyEmbedding(certificate);
    std::cout << (verdict.refusal.empty() ? "valid" : "refused: " + verdict.refusal) << '\n';
    for (const auto & [name, value] : verdict.measures)
    {
      std::cout << "  " << name << ' ' << value << '\n';
    }
    certificate.nodeRadii[3] *= 1.001;
  }
}
