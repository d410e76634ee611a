#include "shapetonSurfaceRepair.h"
#include "shapetonInterruption.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"
#include "shapetonVertexMerging.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shapeton
{
namespace
{
void
DropFaces(SurfaceMesh & mesh, const std::vector<int> & dropped)
{
  std::vector<int> kept;
  std::size_t      next = 0;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (next < dropped.size() && dropped[next] == f)
    {
      ++next;
      continue;
    }
    kept.push_back(f);
  }
  const SurfaceMesh rest = FacesOfSurface(mesh, kept);
  mesh = rest;
}

void
CleanFaces(SurfaceMesh & mesh, SurfaceRepairReport & report)
{
  const int            vertices = mesh.NumberOfVertices();
  const SurfaceDefects defects = FindSurfaceDefects(mesh, SurfaceConnectivity(mesh));
  report.degenerateFaces = static_cast<int>(defects.degenerateFaces.size());
  std::vector<int> dropped = defects.degenerateFaces;
  for (const int f : defects.duplicateFaces)
  {
    if (!std::binary_search(defects.degenerateFaces.begin(), defects.degenerateFaces.end(), f))
    {
      dropped.push_back(f);
      ++report.duplicateFaces;
    }
  }
  std::sort(dropped.begin(), dropped.end());
  if (static_cast<int>(dropped.size()) == mesh.NumberOfFaces())
  {
    throw InputError("the surface: every face is degenerate; use triangles with three distinct vertices");
  }
  if (!dropped.empty() || !defects.unreferencedVertices.empty())
  {
    DropFaces(mesh, dropped);
  }
  report.unreferencedVertices = vertices - mesh.NumberOfVertices();
}

void
CopyRows(SurfaceMesh & mesh, const std::vector<int> & sources)
{
  const Eigen::Index before = mesh.V.rows();
  const Eigen::Index after = before + static_cast<Eigen::Index>(sources.size());
  mesh.V.conservativeResize(after, Eigen::NoChange);
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    mesh.V.row(before + static_cast<Eigen::Index>(i)) = mesh.V.row(sources[i]).eval();
  }
  for (SurfaceArray & array : mesh.pointArrays)
  {
    array.values.conservativeResize(after, Eigen::NoChange);
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      array.values.row(before + static_cast<Eigen::Index>(i)) = array.values.row(sources[i]).eval();
    }
  }
}

void
SplitVertices(SurfaceMesh & mesh, SurfaceRepairReport & report)
{
  const SurfaceConnectivity connectivity(mesh);
  std::vector<int>          sources;
  for (int v = 0; v < connectivity.NumberOfVertices(); ++v)
  {
    const IndexRange       faces = connectivity.FacesOfVertex(v);
    const std::vector<int> fan = connectivity.FanOfFaces(v, true);
    const int              fans = fan.empty() ? 0 : *std::max_element(fan.begin(), fan.end()) + 1;
    for (int i = 0; i < faces.size(); ++i)
    {
      for (int k = 0; k < 3 && fan[i] > 0; ++k)
      {
        if (mesh.F(faces[i], k) == v)
        {
          mesh.F(faces[i], k) = connectivity.NumberOfVertices() + static_cast<int>(sources.size()) + fan[i] - 1;
        }
      }
    }
    sources.insert(sources.end(), std::max(fans - 1, 0), v);
  }
  CopyRows(mesh, sources);
  report.addedVertices = static_cast<int>(sources.size());
}

/** Whether to flip all faces of a component: a closed one that points inward, or an open one if that flips fewer faces.
 */
std::vector<bool>
ComponentsToTurn(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  const auto &        components = connectivity.Components();
  std::vector<int>    turned(components.size(), 0);
  std::vector<double> volumes(components.size(), 0.0);
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const int             c = connectivity.ComponentOfFaces()[f];
    const double          sign = connectivity.TurnedFaces()[f] ? -1.0 : 1.0;
    const Eigen::Vector3d origin = mesh.V.row(mesh.F(components[c].firstFace, 0));
    const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 0)).transpose() - origin;
    const Eigen::Vector3d b = mesh.V.row(mesh.F(f, 1)).transpose() - origin;
    const Eigen::Vector3d d = mesh.V.row(mesh.F(f, 2)).transpose() - origin;
    volumes[c] += sign * a.dot(b.cross(d));
    turned[c] += connectivity.TurnedFaces()[f];
  }
  std::vector<bool> turn(components.size());
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    turn[c] = components[c].boundaryLoops == 0 ? volumes[c] < 0.0 : 2 * turned[c] > components[c].faces;
  }
  return turn;
}

void
OrientFaces(SurfaceMesh & mesh, SurfaceRepairReport & report)
{
  const SurfaceConnectivity connectivity(mesh);
  const std::vector<bool>   turn = ComponentsToTurn(mesh, connectivity);
  for (const SurfaceComponent & component : connectivity.Components())
  {
    report.nonOrientableComponents += !component.isOrientable;
  }
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const int c = connectivity.ComponentOfFaces()[f];
    if (connectivity.Components()[c].isOrientable && connectivity.TurnedFaces()[f] != turn[c])
    {
      std::swap(mesh.F(f, 1), mesh.F(f, 2));
      ++report.turnedFaces;
    }
  }
}
} // namespace

std::vector<std::string>
SurfaceRepairReport::Words() const
{
  std::vector<std::string> words;
  const auto               add = [&](int number, const std::string & one, const std::string & many) {
    if (number)
    {
      words.push_back(std::to_string(number) + ' ' + (number == 1 ? one : many));
    }
  };
  add(mergedVertices, "coincident vertex was merged", "coincident vertices were merged");
  add(degenerateFaces, "degenerate face was dropped", "degenerate faces were dropped");
  add(duplicateFaces, "duplicate face was dropped", "duplicate faces were dropped");
  add(unreferencedVertices, "unreferenced vertex was dropped", "unreferenced vertices were dropped");
  add(addedVertices,
      "vertex was added where the surface was not manifold",
      "vertices were added where the surface was not manifold");
  add(turnedFaces, "face was flipped", "faces were flipped");
  add(nonOrientableComponents, "component cannot be oriented", "components cannot be oriented");
  return words;
}

SurfaceMesh
RepairSurface(const SurfaceMesh & mesh, const SurfaceRepairOptions & options, SurfaceRepairReport * report)
{
  RequireSound(mesh, "the surface");
  CheckOptions(options);
  SurfaceRepairReport done;
  SurfaceMesh         repaired = mesh;
  if (options.mergeVertices)
  {
    done.mergedVertices = MergeVertices(repaired, options.mergeDistance);
  }
  Interruption::Check();
  CleanFaces(repaired, done);
  if (options.split)
  {
    SplitVertices(repaired, done);
  }
  if (options.orient)
  {
    OrientFaces(repaired, done);
  }
  if (report)
  {
    *report = done;
  }
  return repaired;
}

SurfaceConnectivity
RequireManifold(const SurfaceMesh & mesh, const std::string & what)
{
  RequireSound(mesh, what);
  SurfaceConnectivity      connectivity(mesh);
  const std::vector<int> & components = connectivity.ComponentOfFaces();
  const bool               hasDegenerate = std::count(components.begin(), components.end(), -1) > 0;
  if (!hasDegenerate && connectivity.IsManifold() && connectivity.IsOriented())
  {
    return connectivity;
  }
  const SurfaceDefects defects = FindSurfaceDefects(mesh, connectivity); // takes longer
  const auto           refuse = [&](const std::vector<int> & found, const std::string & fault) {
    if (!found.empty())
    {
      throw InputError(what + ": " + std::to_string(found.size()) + ' ' + fault + ", the first is " +
                       std::to_string(found.front()) + "; repair the surface first");
    }
  };
  refuse(defects.degenerateFaces, "faces have a repeated vertex");
  refuse(defects.nonManifoldEdges, "edges have more than two faces");
  refuse(defects.nonManifoldVertices, "vertices have several fans of faces");
  refuse(defects.inconsistentEdges, "edges have faces of opposite orientation");
  return connectivity;
}
} // namespace shapeton
