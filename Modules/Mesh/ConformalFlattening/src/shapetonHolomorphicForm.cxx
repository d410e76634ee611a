#include "shapetonHolomorphicForm.h"

#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonSurfaceCut.h"

#include <Eigen/LU>

namespace shapeton
{
namespace
{

/** Column j: weight of each slit map in f_j. */
Eigen::MatrixXd
WeightsOfForms(const std::vector<SlitMap> & maps)
{
  const auto      n = static_cast<Eigen::Index>(maps.size());
  Eigen::MatrixXd levels(n, n); // -logRadius on the inner boundaries, one column per map
  for (Eigen::Index k = 0; k < n; ++k)
  {
    for (Eigen::Index i = 0; i < n; ++i)
    {
      levels(i, k) = -maps[k].logRadiusOfLoops[maps[i].inner];
    }
  }
  return levels.inverse();
}

/** -logRadius and -angle of a slit map at the vertices of the cut surface. */
Eigen::MatrixX2d
ValuesOnCutSurface(const SlitMap & map, const CutSurface & cut, const std::vector<int> & leftCorners)
{
  std::vector<char> isLeft(cut.sourcePointId.size(), 0);
  for (const int corner : leftCorners)
  {
    isLeft[cut.mesh.F(corner / 3, corner % 3)] = 1;
  }
  Eigen::MatrixX2d values(cut.mesh.NumberOfVertices(), 2);
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    const int source = cut.sourcePointId[i];
    values.row(i) << -map.logRadius[source], -(map.angle[source] + (isLeft[i] ? TwoPi : 0.0));
  }
  return values;
}
} // namespace

std::vector<HolomorphicForm>
HolomorphicFormsOf(const ConformalMap & map)
{
  RequireParameter(map.domain == ConformalDomain::Slit,
                   "1-forms require the slit maps of all inner boundaries; set the parameter \"domain\" = slit");
  std::vector<std::vector<int>> paths;
  for (const SlitMap & slitMap : map.slitMaps)
  {
    paths.push_back(slitMap.cut);
  }
  const CutSurface             cut = CutAlongPaths(map.flat, SurfaceConnectivity(map.flat), paths);
  const Eigen::MatrixXd        weights = WeightsOfForms(map.slitMaps);
  std::vector<HolomorphicForm> forms;
  for (const SlitMap & slitMap : map.slitMaps)
  {
    forms.push_back({ slitMap.inner, cut.mesh, Eigen::MatrixX2d::Zero(cut.mesh.NumberOfVertices(), 2) });
  }
  for (std::size_t k = 0; k < map.slitMaps.size(); ++k)
  {
    const Eigen::MatrixX2d values = ValuesOnCutSurface(map.slitMaps[k], cut, cut.leftCorners[k]);
    for (std::size_t j = 0; j < forms.size(); ++j)
    {
      forms[j].values += weights(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) * values;
    }
  }
  return forms;
}
} // namespace shapeton
