// Writes the certificate of an embedding to a file and reads it back.
// Usage: ExampleEmbeddingCertificate CERTIFICATE.json
#include "shapetonEmbeddingCertificate.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " CERTIFICATE.json\n";
    return 2;
  }
  const shapeton::CombinatorialMap     torus = shapeton::TorusGridMap(5, 4);
  const shapeton::EmbeddingCertificate made = shapeton::EmbedGraph(torus.ToGraph(), torus);
  shapeton::WriteEmbeddingCertificate(made, argv[1]);

  const shapeton::EmbeddingCertificate read = shapeton::ReadEmbeddingCertificate(argv[1]);
  std::cout << shapeton::NameOf(read.geometry) << ", genus " << read.genus << ", " << read.graph.nodes << " nodes, "
            << read.faceRadii.size() << " faces, " << read.generators.size() << " deck transformations, "
            << (read.nodePositions == made.nodePositions ? "same" : "other") << " positions, rotation of the graph "
            << (shapeton::RotationOfGraph(read) == read.rotation ? "agrees" : "differs") << '\n';
}
