// K7 on the torus: its circle packing as SVG, and nodes and edges on a torus in space as VTP.
// Usage: ExampleGraphViews PICTURE.svg SPACE.vtp
#include "shapetonCurveSet.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"
#include "shapetonGraphInSpace.h"
#include "shapetonGraphPictures.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " PICTURE.svg SPACE.vtp\n";
    return 2;
  }
  const shapeton::Graph                graph = shapeton::CompleteGraph(7);
  const shapeton::EmbeddingCertificate certificate = shapeton::EmbedGraph(graph, shapeton::FindEmbedding(graph).map);

  const shapeton::GraphView view{ "K7", &certificate, shapeton::DistinctColors(graph.nodes), true };
  shapeton::WriteGraphSvg(view, {}, argv[1]);
  shapeton::WriteGraphInSpace(certificate, { { "source", "ExampleGraphViews" } }, argv[2]);

  const shapeton::CurveSet curves = shapeton::ReadCurves(argv[2]);
  int                      nodes = 0;
  double                   length = 0.0;
  for (const auto & curve : curves.curves)
  {
    nodes += curve.size() == 1;
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      length += (curves.V.row(curve[i]) - curves.V.row(curve[i - 1])).norm();
    }
  }
  std::cout << nodes << " nodes and " << curves.curves.size() - nodes << " edges on a torus, " << length
            << " times its radius long\n";
}
