#include "itkGraphInSpace.h"

#include "itkCurveSet.h"
#include "itkGraphPictures.h"
#include "itkToolError.h"
#include "itkTorusInSpace.h"

namespace itk
{
namespace
{
Eigen::VectorXd
Column(const std::vector<double> & values)
{
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/** Curves of nodes and edges, one after the other. */
CurveSet
CurvesOf(const TorusInSpace & torus)
{
  CurveSet                                      set;
  std::vector<double>                           kinds;
  std::vector<double>                           ids;
  std::vector<std::vector<TorusInSpace::Point>> curves;
  for (const TorusInSpace::Point & node : torus.Nodes())
  {
    ids.push_back(static_cast<double>(curves.size()));
    kinds.push_back(0.0);
    curves.push_back({ node });
  }
  const std::size_t firstEdge = curves.size();
  for (const std::vector<TorusInSpace::Point> & edge : torus.Edges())
  {
    ids.push_back(static_cast<double>(curves.size() - firstEdge));
    kinds.push_back(1.0);
    curves.push_back(edge);
  }
  std::size_t vertices = 0;
  for (const auto & curve : curves)
  {
    vertices += curve.size();
  }
  set.V.resize(static_cast<Eigen::Index>(vertices), 3);
  int next = 0;
  for (const auto & curve : curves)
  {
    set.curves.emplace_back();
    for (const TorusInSpace::Point & point : curve)
    {
      set.V.row(next) << point[0], point[1], point[2];
      set.curves.back().push_back(next++);
    }
  }
  set.cellArrays = { { "kind", Column(kinds), true }, { "id", Column(ids), true } };
  set.fieldArrays = { { "tubeRadius", Column({ torus.TubeRadius() }), false },
                      { "dilatation", Column({ torus.Dilatation() }), false } };
  return set;
}
} // namespace

void
RequireSurfaceInSpace(int genus)
{
  if (genus > 1)
  {
    throw InputError(
      "a surface of genus " + std::to_string(genus) +
      " in space is not implemented, only sphere and torus; leave --surface out and see the tiles of the "
      "Poincare disk with --svg or --report");
  }
}

void
WriteGraphInSpace(const EmbeddingCertificate &                             certificate,
                  const std::vector<std::pair<std::string, std::string>> & facts,
                  const std::string &                                      path)
{
  RequireSurfaceInSpace(certificate.genus);
  if (certificate.genus == 0)
  {
    WriteGraphVtp(certificate, facts, path);
    return;
  }
  CurveSet set = CurvesOf(TorusInSpace(certificate));
  set.facts = facts;
  WriteCurves(set, path);
}
} // namespace itk
