#include "shapetonSurfaceReader.h"
#include "shapetonCsvTable.h"
#include "shapetonDisjointSets.h"
#include "shapetonSha256.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonVertexMerging.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr double      LeastExtent = 5.0;       // mm
constexpr double      GreatestExtent = 5000.0; // mm; larger surfaces are implausible
constexpr std::size_t LongestList = 12;        // names in a message; chosen

double
MillimetersOf(SurfaceUnit unit)
{
  return unit == SurfaceUnit::Meter ? 1000.0 : unit == SurfaceUnit::Micrometer ? 0.001 : 1.0;
}

std::string
TextOfExtent(const Eigen::Vector3d & extent)
{
  return CsvTable::Rounded(extent[0], 4) + " x " + CsvTable::Rounded(extent[1], 4) + " x " +
         CsvTable::Rounded(extent[2], 4) + " mm";
}

Eigen::Vector3d
ExtentOf(const SurfaceMesh & mesh)
{
  const auto corners = CornersOfFaces(mesh);
  return (corners[1] - corners[0]).transpose();
}

/** Joins items by semicolons; a long list ends with the number of omitted items. */
std::string
Join(const std::vector<std::string> & items)
{
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), LongestList); ++i)
  {
    text += (i ? "; " : "") + items[i];
  }
  return text + (items.size() > LongestList ? "; and " + std::to_string(items.size() - LongestList) + " more" : "");
}

std::string
ListOfParts(const SurfaceFile & file)
{
  std::vector<std::string> items;
  for (const SurfacePart & part : file.parts)
  {
    items.push_back(part.name + " (" + std::to_string(part.numberOfFaces) + " faces)");
  }
  return Join(items);
}

void
ScaleToUnit(SurfaceFile & file, const SurfaceReadOptions & options, const std::string & path)
{
  if (options.unit != SurfaceUnit::File)
  {
    file.mesh.V *= MillimetersOf(options.unit) / MillimetersOf(file.unit);
    return;
  }
  const Eigen::Vector3d extent = ExtentOf(file.mesh);
  if (extent.maxCoeff() >= LeastExtent && extent.maxCoeff() <= GreatestExtent)
  {
    return;
  }
  const std::string measures = "read in " + std::string(file.unit == SurfaceUnit::Meter ? "m" : "mm") +
                               " it measures " + TextOfExtent(extent) +
                               ", which is implausible (5 mm to 5 m are plausible)";
  const std::string advice = "state its unit: the parameter \"unit\" = m, mm or um";
  if (!options.anyExtent)
  {
    RefuseSurface(path, measures, advice);
  }
  file.notes.push_back(measures + "; if it matters, " + advice);
}

void
TakePart(SurfaceFile & file, const std::string & name, const std::string & path)
{
  const auto part =
    std::find_if(file.parts.begin(), file.parts.end(), [&](const SurfacePart & p) { return p.name == name; });
  if (part == file.parts.end())
  {
    RefuseSurface(path,
                  file.parts.empty() ? "it has no named parts"
                                     : "part \"" + name + "\" does not exist; parts: " + ListOfParts(file),
                  file.parts.empty() ? "omit the parameter \"part\"" : "choose one with the parameter \"part\" = NAME");
  }
  std::vector<int> faces(part->numberOfFaces);
  std::iota(faces.begin(), faces.end(), part->firstFace);
  const SurfaceMesh mesh = FacesOfSurface(file.mesh, faces);
  file.mesh = mesh;
}

std::string
TextOfPlace(const SurfaceMesh & mesh, int vertex)
{
  return "(" + CsvTable::Rounded(mesh.V(vertex, 0), 4) + ", " + CsvTable::Rounded(mesh.V(vertex, 1), 4) + ", " +
         CsvTable::Rounded(mesh.V(vertex, 2), 4) + ")";
}

/** Number of edges with more than two faces and position of the first one; empty if there are none. */
std::string
TextOfNonManifoldEdges(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  int count = 0;
  int first = -1;
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    if (connectivity.IsNonManifoldEdge(edge))
    {
      first = count++ == 0 ? edge : first;
    }
  }
  if (count == 0)
  {
    return {};
  }
  const auto & ends = connectivity.VerticesOfEdge(first);
  return "it is not manifold: " + std::to_string(count) + (count == 1 ? " edge has" : " edges have") +
         " more than two faces, the first from " + TextOfPlace(mesh, ends[0]) + " to " + TextOfPlace(mesh, ends[1]) +
         " mm";
}

/** Joins faces along seams: pairs of boundary edges with separate vertices at the same positions. */
void
JoinSeams(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, DisjointSets<> & sets)
{
  const std::vector<int>                          firsts = FirstAtPosition(mesh);
  std::map<std::pair<int, int>, std::vector<int>> facesBetween;
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    if (connectivity.IsBoundaryEdge(edge))
    {
      const auto & ends = connectivity.VerticesOfEdge(edge);
      facesBetween[std::minmax(firsts[ends[0]], firsts[ends[1]])].push_back(connectivity.FacesOfEdge(edge)[0]);
    }
  }
  for (const auto & between : facesBetween)
  {
    if (between.second.size() == 2)
    {
      sets.Join(between.second[0], between.second[1]);
    }
  }
}

/** The faces kept by RepairSurface() if a surface is not manifold. */
std::vector<int>
FacesKept(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  std::vector<int> dropped;
  if (!connectivity.IsManifold())
  {
    dropped = FindSurfaceDefects(mesh, connectivity).duplicateFaces;
  }
  std::vector<int> kept;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const bool isDegenerate = connectivity.ComponentOfFaces()[f] < 0;
    if (!isDegenerate && !std::binary_search(dropped.begin(), dropped.end(), f))
    {
      kept.push_back(f);
    }
  }
  return kept;
}

/** Faces of each component, largest component first. Components as returned by RepairSurface(): faces are connected
 * across seams and edges of two faces, but not across edges of more faces. */
std::vector<std::vector<int>>
FacesOfComponents(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  const std::vector<int>    kept = FacesKept(mesh, connectivity);
  const SurfaceMesh         sound = FacesOfSurface(mesh, kept);
  const SurfaceConnectivity edges(sound);
  DisjointSets<>            sets(kept.size());
  for (int edge = 0; edge < edges.NumberOfEdges(); ++edge)
  {
    const IndexRange faces = edges.FacesOfEdge(edge);
    if (faces.size() == 2)
    {
      sets.Join(faces[0], faces[1]);
    }
  }
  JoinSeams(sound, edges, sets);
  std::vector<std::vector<int>> components;
  std::vector<std::size_t>      componentOf(kept.size());
  for (std::size_t f = 0; f < kept.size(); ++f)
  {
    const auto first = static_cast<std::size_t>(sets.Find(static_cast<int>(f))); // at most f
    componentOf[f] = first == f ? components.size() : componentOf[first];
    components.resize(std::max(components.size(), componentOf[f] + 1));
    components[componentOf[f]].push_back(kept[f]);
  }
  std::stable_sort(
    components.begin(), components.end(), [](const auto & a, const auto & b) { return a.size() > b.size(); });
  return components;
}

std::string
ListOfComponents(const SurfaceMesh & mesh, const std::vector<std::vector<int>> & components)
{
  std::vector<std::string> items;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    const std::string extent = i < LongestList ? TextOfExtent(ExtentOf(FacesOfSurface(mesh, components[i]))) : "";
    items.push_back(std::to_string(i + 1) + ": " + std::to_string(components[i].size()) + " faces, " + extent);
  }
  return Join(items);
}

[[noreturn]] void
RefuseSeveral(const SurfaceFile &                   file,
              const SurfaceReadOptions &            options,
              const SurfaceConnectivity &           connectivity,
              const std::vector<std::vector<int>> & components,
              const std::string &                   path)
{
  const std::string defects = TextOfNonManifoldEdges(file.mesh, connectivity);
  const bool        isPartOpen = options.part.empty() && file.parts.size() > 1;
  RefuseSurface(path,
                (defects.empty() ? "it" : defects + "; after cutting there it") + " has " +
                  std::to_string(components.size()) + " components: " + ListOfComponents(file.mesh, components) +
                  (isPartOpen ? ". Parts: " + ListOfParts(file) : ""),
                std::string("choose one with the parameter \"component\" = N") +
                  (isPartOpen ? " or the parameter \"part\" = NAME" : "") +
                  (defects.empty() ? "" : ", or repair the surface there") +
                  (options.takesOneComponent ? "" : ", or all with the parameter \"component\" = -1"));
}

/** With `isCut`, counts the components after cutting, even if all faces are connected. */
void
TakeComponent(SurfaceFile & file, const SurfaceReadOptions & options, bool isCut, const std::string & path)
{
  if (options.component < 0)
  {
    return; // all components
  }
  const SurfaceConnectivity connectivity(file.mesh);
  const std::size_t         connected = connectivity.Components().size(); // by edges with any number of faces
  const bool                isManifold = connectivity.IsManifold();
  if (options.component == 0 && connected <= 1 && isManifold)
  {
    return;
  }
  const auto components = FacesOfComponents(file.mesh, connectivity);
  const auto count = static_cast<int>(components.size());
  if (options.component == 0 && count > 1 && (connected > 1 || isCut))
  {
    RefuseSeveral(file, options, connectivity, components, path);
  }
  if (options.component > count)
  {
    RefuseSurface(path,
                  "component " + std::to_string(options.component) + " does not exist; there are " +
                    std::to_string(count) + ": " + ListOfComponents(file.mesh, components),
                  "choose one with the parameter \"component\" = N");
  }
  if (options.component > 0)
  {
    const SurfaceMesh mesh = FacesOfSurface(file.mesh, components[options.component - 1]);
    file.mesh = mesh;
  }
  else if (count == 1 && connected > 1)
  {
    file.notes.push_back("its " + std::to_string(connected) +
                         " pieces meet along seams of coincident vertices and are one component");
  }
  else if (count > 1)
  {
    file.notes.push_back(TextOfNonManifoldEdges(file.mesh, connectivity) + "; after cutting there it has " +
                         std::to_string(count) + " components: " + ListOfComponents(file.mesh, components));
  }
  else if (isCut && !isManifold)
  {
    const std::string edges = TextOfNonManifoldEdges(file.mesh, connectivity);
    if (!edges.empty())
    {
      file.notes.push_back(edges + "; it was cut there, which adds boundaries");
    }
  }
}

Surface
ReadChosen(const std::string & path, const SurfaceReadOptions & options, bool isCut)
{
  CheckOptions(options);
  SurfaceFile file = ReadSurfaceFile(path);
  ScaleToUnit(file, options, path);
  if (!options.part.empty())
  {
    TakePart(file, options.part, path);
  }
  TakeComponent(file, options, isCut, path);
  return { std::move(file.mesh), "sha256:" + Sha256OfFile(path), std::move(file.notes), {} };
}
} // namespace

Surface
ReadSurface(const std::string & path, const SurfaceReadOptions & options)
{
  return ReadChosen(path, options, options.takesOneComponent);
}

Surface
ReadRepairedSurface(const std::string & path, const SurfaceReadOptions & options)
{
  Surface surface = ReadChosen(path, options, true);
  RequireSound(surface.mesh, path);
  SurfaceRepairReport report;
  surface.mesh = RepairSurface(surface.mesh, {}, &report);
  surface.repairs = report.Words();
  if (report.nonOrientableComponents > 0)
  {
    RefuseSurface(
      path, "it is one-sided (not orientable), like a Moebius strip", "cut it open so that it has two sides");
  }
  const std::vector<int> faces = FindSurfaceDefects(surface.mesh, SurfaceConnectivity(surface.mesh)).zeroAreaFaces;
  if (!faces.empty())
  {
    RefuseSurface(path,
                  std::to_string(faces.size()) + " faces have no area, face " + std::to_string(faces.front()) +
                    " is the first one",
                  "remesh the surface");
  }
  return surface;
}
} // namespace shapeton
