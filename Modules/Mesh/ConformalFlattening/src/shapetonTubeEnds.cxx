#include "shapetonTubeEnds.h"

#include "shapetonSurfaceRepair.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

namespace shapeton
{
namespace
{
/** Arrays of the wall with the vertices of its ends. */
constexpr const char * rectumName = "rectumLoop";
constexpr const char * cecumName = "cecumLoop";

bool
IsLoopArray(const SurfaceArray & array)
{
  return array.name == rectumName || array.name == cecumName;
}

/** Length, number of edges and center of each boundary. */
std::string
ListOfLoops(const SurfaceMesh & mesh, const std::vector<std::vector<int>> & loops)
{
  constexpr std::size_t mostListed = 5;
  std::ostringstream    text;
  text.precision(3);
  for (std::size_t i = 0; i < std::min(loops.size(), mostListed); ++i)
  {
    double             length = 0.0;
    Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
    for (std::size_t k = 0; k < loops[i].size(); ++k)
    {
      length += (mesh.V.row(loops[i][k]) - mesh.V.row(loops[i][(k + 1) % loops[i].size()])).norm();
      center += mesh.V.row(loops[i][k]) / static_cast<double>(loops[i].size());
    }
    text << (i > 0 ? ", " : "") << length << " mm (" << loops[i].size() << " edges around " << center[0] << ", "
         << center[1] << ", " << center[2] << ")";
  }
  text << (loops.size() > mostListed ? ", ..." : "");
  return text.str();
}

/** Advice for a surface that is not a tube. */
std::string
AdviceFor(const SurfaceMesh & mesh, const std::vector<std::vector<int>> & loops)
{
  const std::string needs = "a tube has two, one at each end";
  switch (loops.size())
  {
    case 0:
      return " has no boundary; " + needs + ": cut its ends open, as ColonSegmentation does";
    case 1:
      return " has one boundary of " + ListOfLoops(mesh, loops) + "; " + needs +
             ": open the other end, or map it as a disk with ConformalMap (the parameter \"domain\" = rectangle)";
    default:
      return " has " + std::to_string(loops.size()) + " boundaries of " + ListOfLoops(mesh, loops) + "; " + needs +
             ": close the holes, or map it with ConformalMap (the parameter \"domain\" = slit)";
  }
}

std::array<double, 3>
PositionOf(const SurfaceMesh & mesh, int vertex)
{
  return { mesh.V(vertex, 0), mesh.V(vertex, 1), mesh.V(vertex, 2) };
}
bool
IsSoundTube(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  if (!connectivity.IsManifold() || !connectivity.IsOriented() || connectivity.BoundaryLoops().size() != 2)
  {
    return false;
  }
  std::set<std::array<double, 3>> ends; // a seam is a boundary with vertices at one position
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    for (const int v : loop)
    {
      if (!ends.insert(PositionOf(mesh, v)).second)
      {
        return false;
      }
    }
  }
  for (int v = 0; v < connectivity.NumberOfVertices(); ++v)
  {
    if (connectivity.FacesOfVertex(v).size() == 0)
    {
      return false;
    }
  }
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const auto & ends = connectivity.VerticesOfEdge(edge);
    if (mesh.V.row(ends[0]) == mesh.V.row(ends[1]))
    {
      return false;
    }
  }
  const auto & components = connectivity.ComponentOfFaces();
  return std::find(components.begin(), components.end(), -1) == components.end();
}

/** Six times the volume between the surface and its ends, each closed by a fan around its center. */
double
SixfoldVolume(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  const Eigen::RowVector3d origin = mesh.V.colwise().mean();
  const auto               tetrahedron =
    [&](const Eigen::RowVector3d & a, const Eigen::RowVector3d & b, const Eigen::RowVector3d & c) {
      return (a - origin).dot((b - origin).cross(c - origin));
    };
  double volume = 0.0;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    volume += tetrahedron(mesh.V.row(mesh.F(f, 0)), mesh.V.row(mesh.F(f, 1)), mesh.V.row(mesh.F(f, 2)));
  }
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
    for (const int v : loop)
    {
      center += mesh.V.row(v) / static_cast<double>(loop.size());
    }
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      // The face runs along the loop, so its neighbor in the cap runs against it.
      volume += tetrahedron(mesh.V.row(loop[(k + 1) % loop.size()]), mesh.V.row(loop[k]), center);
    }
  }
  return volume;
}

} // namespace

std::vector<int>
TubeEnds::Vertices() const
{
  std::vector<int> all = first;
  all.insert(all.end(), second.begin(), second.end());
  return all;
}

TubeEnds
FindTubeEnds(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const std::string & what)
{
  if (connectivity.Components().size() != 1)
  {
    throw InputError(what + " has " + std::to_string(connectivity.Components().size()) +
                     " components after cutting where it is not manifold or touches itself, but a tube has one; remesh "
                     "the surface, or use one component");
  }
  if (!connectivity.IsManifold())
  {
    throw InputError(what + " is not manifold; repair it");
  }
  if (!connectivity.Components().front().isOrientable)
  {
    throw InputError(what + " is one-sided (not orientable), like a Moebius strip, but a tube has two sides; cut it "
                            "open so that it has two sides");
  }
  if (!connectivity.IsOriented())
  {
    throw InputError(what + " has flipped faces; repair it");
  }
  const auto & loops = connectivity.BoundaryLoops();
  if (loops.size() != 2)
  {
    throw InputError(what + AdviceFor(mesh, loops));
  }
  TubeEnds                   ends{ loops[0], loops[1], false };
  const SurfaceArray * const rectum = FindSurfaceArray(mesh.fieldArrays, rectumName);
  if (rectum && rectum->values.size() > 0)
  {
    const int vertex = static_cast<int>(rectum->values(0, 0));
    for (const std::vector<int> & loop : loops)
    {
      if (std::find(loop.begin(), loop.end(), vertex) != loop.end())
      {
        ends = { loop, &loop == &loops[0] ? loops[1] : loops[0], true };
      }
    }
  }
  return ends;
}

void
RenumberLoopArrays(const SurfaceMesh & before, SurfaceMesh & after)
{
  std::map<std::array<double, 3>, int> vertexAt;
  for (int v = 0; v < after.NumberOfVertices() && !after.fieldArrays.empty(); ++v)
  {
    vertexAt.emplace(PositionOf(after, v), v);
  }
  const auto isLost = [&](SurfaceArray & array) {
    bool lost = false;
    for (Eigen::Index i = 0; i < array.values.rows() && IsLoopArray(array); ++i)
    {
      const int  vertex = static_cast<int>(array.values(i, 0));
      const bool exists = vertex >= 0 && vertex < before.NumberOfVertices();
      const auto found = exists ? vertexAt.find(PositionOf(before, vertex)) : vertexAt.end();
      lost = lost || found == vertexAt.end();
      array.values(i, 0) = lost ? -1.0 : found->second;
    }
    return lost;
  };
  auto & arrays = after.fieldArrays;
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(), isLost), arrays.end());
}

PreparedTube
PrepareTube(SurfaceMesh mesh, const std::string & what)
{
  RequireSound(mesh, what);
  PreparedTube tube{ std::move(mesh), {} };
  if (!IsSoundTube(tube.mesh, SurfaceConnectivity(tube.mesh)))
  {
    SurfaceRepairReport report;
    SurfaceMesh         repaired = RepairSurface(tube.mesh, {}, &report);
    for (const std::string & words : report.Words())
    {
      tube.warnings.push_back("the surface: " + words);
    }
    RenumberLoopArrays(tube.mesh, repaired);
    tube.mesh = std::move(repaired);
  }
  const SurfaceConnectivity connectivity(tube.mesh);
  FindTubeEnds(tube.mesh, connectivity, what);
  if (SixfoldVolume(tube.mesh, connectivity) < 0.0)
  {
    tube.mesh.F.col(1).swap(tube.mesh.F.col(2));
    tube.warnings.emplace_back("the surface: its faces pointed inward and were flipped");
  }
  return tube;
}
} // namespace shapeton
