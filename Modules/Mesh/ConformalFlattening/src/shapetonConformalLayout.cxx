#include "shapetonConformalLayout.h"

#include "shapetonConformalTube.h"
#include "shapetonPi.h"
#include "shapetonSurfaceQuality.h"

#include <cmath>

namespace shapeton
{
namespace
{

/** Points of the annulus of the given area (mm). \equation{5.17} from the real and imaginary parts of its logarithm. */
Eigen::MatrixX2d
PlacesInAnnulus(const SlitMap & map, double area)
{
  const double     innermost = std::exp(map.logRadiusOfLoops.minCoeff());
  const double     radius = std::sqrt(area / (Pi * (1.0 - innermost * innermost)));
  Eigen::MatrixX2d places(map.angle.size(), 2);
  for (Eigen::Index i = 0; i < map.angle.size(); ++i)
  {
    const double r = radius * std::exp(map.logRadius[i]);
    places.row(i) << r * std::cos(map.angle[i]), r * std::sin(map.angle[i]);
  }
  return places;
}

bool
AreOnOneSide(const Eigen::VectorXd & x, const Eigen::Vector3i & face, double value)
{
  return x[face[0]] == value && x[face[1]] == value && x[face[2]] == value;
}
} // namespace

std::vector<int>
EarsOfSides(const FaceMatrix & F, const QuadrilateralMap & map)
{
  std::vector<int> ears;
  for (Eigen::Index face = 0; face < F.rows(); ++face)
  {
    const Eigen::Vector3i corners = F.row(face);
    if (AreOnOneSide(map.u, corners, 0.0) || AreOnOneSide(map.u, corners, 1.0) || AreOnOneSide(map.v, corners, 0.0) ||
        AreOnOneSide(map.v, corners, 1.0))
    {
      ears.push_back(static_cast<int>(face));
    }
  }
  return ears;
}

SurfaceMesh
LayOutRectangle(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const QuadrilateralMap & map)
{
  const double     area = SurfaceArea(mesh.V, mesh.F);
  const double     modulus = std::sqrt(map.modulusU * map.modulusV);
  Eigen::MatrixX2d uv(map.u.size(), 2);
  uv << std::sqrt(area / modulus) * map.u, std::sqrt(area * modulus) * map.v;
  return MakeFlatSurface(CutAlongPaths(mesh, connectivity, {}), uv);
}

SurfaceMesh
LayOutStrip(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const SlitMap & map)
{
  const double     depth = -map.logRadiusOfLoops.minCoeff();
  const double     circumference = MeanLevelLength(mesh, map.logRadius / depth);
  const double     length = circumference / std::sqrt(map.modulusU * map.modulusV);
  CutSurface       cut = CutAlongPaths(mesh, connectivity, { map.cut });
  const double     atCut = map.angle[map.cut.front()];
  Eigen::VectorXd  turns = Eigen::VectorXd::Zero(cut.mesh.NumberOfVertices());
  Eigen::MatrixX2d uv(cut.mesh.NumberOfVertices(), 2);
  for (const int corner : cut.leftCorners.front())
  {
    turns[cut.mesh.F(corner / 3, corner % 3)] = 1.0;
  }
  for (Eigen::Index i = 0; i < uv.rows(); ++i)
  {
    const int source = cut.sourcePointId[i];
    uv.row(i) << -length / depth * map.logRadius[source],
      circumference * (1.0 - turns[i] - (map.angle[source] - atCut) / (2.0 * Pi));
  }
  SurfaceMesh flat = MakeFlatSurface(std::move(cut), uv);
  SetFlatExtent(flat, circumference, length);
  return flat;
}

SurfaceMesh
LayOutAnnulus(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const SlitMap & map)
{
  return MakeFlatSurface(CutAlongPaths(mesh, connectivity, {}), PlacesInAnnulus(map, SurfaceArea(mesh.V, mesh.F)));
}

void
AddSlitMaps(const std::vector<SlitMap> & maps, SurfaceMesh & flat)
{
  const double area = SurfaceArea(flat.V, flat.F);
  for (const SlitMap & map : maps)
  {
    flat.pointArrays.push_back({ "slitMap" + std::to_string(map.inner + 1), PlacesInAnnulus(map, area) });
  }
}
} // namespace shapeton
