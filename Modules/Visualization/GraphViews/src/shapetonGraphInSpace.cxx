#include "shapetonGraphInSpace.h"

#include "shapetonCurveSet.h"
#include "shapetonGraphPictures.h"
#include "shapetonSpaceCells.h"
#include "shapetonSurfaceWithHandles.h"
#include "shapetonTorusInSpace.h"

namespace shapeton
{
namespace
{
Eigen::VectorXd
Column(const std::vector<double> & values)
{
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

VertexMatrix
VerticesOf(const std::vector<std::array<double, 3>> & points)
{
  return Eigen::Map<const VertexMatrix>(points.front().data(), static_cast<Eigen::Index>(points.size()), 3);
}

void
WriteOnTorus(const EmbeddingCertificate & certificate, const Provenance & facts, const std::string & path)
{
  const TorusInSpace               torus(certificate);
  const auto                       edges = torus.Edges();
  std::vector<TorusInSpace::Point> points = torus.Nodes();
  CurveSet                         set;
  set.curves = CurvesInSpace(edges, points);
  set.V = VerticesOf(points);
  set.cellArrays = CellArraysInSpace({ torus.Nodes().size(), edges.size(), 0 });
  set.fieldArrays = { { "tubeRadius", Column({ torus.TubeRadius() }), false },
                      { "dilatation", Column({ torus.Dilatation() }), false } };
  set.facts = facts;
  WriteCurves(std::move(set), path);
}

void
WriteOnSurfaceWithHandles(const EmbeddingCertificate & certificate, const Provenance & facts, const std::string & path)
{
  const SurfaceWithHandles surface(MapOfRotation(certificate.graph, certificate.rotation));
  const std::size_t        nodes = certificate.graph.nodes;
  CurveSet                 set;
  set.V = VerticesOf(surface.Vertices());
  for (std::size_t node = 0; node < nodes; ++node)
  {
    set.curves.push_back({ static_cast<int>(node) });
  }
  set.curves.insert(set.curves.end(), surface.Edges().begin(), surface.Edges().end());
  const auto & triangles = surface.Triangles();
  set.cellArrays = CellArraysInSpace({ nodes, surface.Edges().size(), triangles.size() });
  set.fieldArrays = { { "twist", Column(surface.Twists()), false } };
  set.facts = facts;
  WriteCurvesOnSurface(
    std::move(set),
    Eigen::Map<const FaceMatrix>(triangles.front().data(), static_cast<Eigen::Index>(triangles.size()), 3),
    path);
}
} // namespace

void
WriteGraphInSpace(const EmbeddingCertificate & certificate, const Provenance & facts, const std::string & path)
{
  if (certificate.genus == 0)
  {
    WriteGraphVtp(certificate, facts, path);
  }
  else if (certificate.genus == 1)
  {
    WriteOnTorus(certificate, facts, path);
  }
  else
  {
    WriteOnSurfaceWithHandles(certificate, facts, path);
  }
}
} // namespace shapeton
