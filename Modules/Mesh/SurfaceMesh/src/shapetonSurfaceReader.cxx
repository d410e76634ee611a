#include "shapetonSurfaceReader.h"
#include "shapetonCsvTable.h"
#include "shapetonSha256.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr double      LeastExtent = 5.0; // mm
constexpr double      GreatestExtent = 5000.0;
constexpr std::size_t LongestList = 12;

double
MillimetresOf(const std::string & unit)
{
  static const std::map<std::string, double> millimetres{ { "m", 1000.0 }, { "mm", 1.0 }, { "um", 0.001 } };
  const auto                                 found = millimetres.find(unit);
  RequireParameter(found != millimetres.end(), "the unit \"" + unit + "\" is none of m, mm, um");
  return found->second;
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
  return mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff();
}

/** Items separated by semicolons, the rest of a long list as a number. */
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
  if (!options.unit.empty())
  {
    file.mesh.V *= MillimetresOf(options.unit) / MillimetresOf(file.unit);
    return;
  }
  const Eigen::Vector3d extent = ExtentOf(file.mesh);
  if (extent.maxCoeff() >= LeastExtent && extent.maxCoeff() <= GreatestExtent)
  {
    return;
  }
  const std::string measures = "read in " + file.unit + " it measures " + TextOfExtent(extent) +
                               ", which is implausible (5 mm to 5 m are plausible)";
  const std::string advice = "state its unit: the parameter \"unit\" = m, mm or um";
  if (!options.isAnyExtentPlausible)
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
                                     : "it has no part \"" + name + "\" but " + ListOfParts(file),
                  file.parts.empty() ? "leave the parameter \"part\" out"
                                     : "choose one of them with the parameter \"part\" = NAME");
  }
  std::vector<int> faces(part->numberOfFaces);
  std::iota(faces.begin(), faces.end(), part->firstFace);
  const SurfaceMesh mesh = FacesOfSurface(file.mesh, faces);
  file.mesh = mesh;
}

/** The faces of each component, the one with most faces first. */
std::vector<std::vector<int>>
FacesOfComponents(const SurfaceMesh & mesh)
{
  const SurfaceConnectivity     connectivity(mesh);
  std::vector<std::vector<int>> components(connectivity.Components().size());
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (connectivity.ComponentOfFaces()[f] >= 0)
    {
      components[connectivity.ComponentOfFaces()[f]].push_back(f);
    }
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

void
TakeComponent(SurfaceFile & file, const SurfaceReadOptions & options, const std::string & path)
{
  if (options.component < 0)
  {
    return; // all of them
  }
  const auto components = FacesOfComponents(file.mesh);
  const auto count = static_cast<int>(components.size());
  if (options.component == 0 && count > 1)
  {
    const bool isPartOpen = options.part.empty() && file.parts.size() > 1;
    RefuseSurface(path,
                  "it has " + std::to_string(count) + " components: " + ListOfComponents(file.mesh, components) +
                    (isPartOpen ? ". Parts: " + ListOfParts(file) : ""),
                  std::string("choose one with the parameter \"component\" = N") +
                    (isPartOpen ? " or the parameter \"part\" = NAME" : "") +
                    ", or all with the parameter \"component\" = -1");
  }
  if (options.component > count)
  {
    RefuseSurface(path,
                  "it has no component " + std::to_string(options.component) + " but " + std::to_string(count) + ": " +
                    ListOfComponents(file.mesh, components),
                  "choose one of them with the parameter \"component\" = N");
  }
  if (options.component > 0)
  {
    const SurfaceMesh mesh = FacesOfSurface(file.mesh, components[options.component - 1]);
    file.mesh = mesh;
  }
}
} // namespace

Surface
ReadSurface(const std::string & path, const SurfaceReadOptions & options)
{
  RequireParameter(options.component >= -1, "the component must be -1, 0 or the number of one");
  if (!options.unit.empty())
  {
    MillimetresOf(options.unit);
  }
  SurfaceFile file = ReadSurfaceFile(path);
  ScaleToUnit(file, options, path);
  if (!options.part.empty())
  {
    TakePart(file, options.part, path);
  }
  TakeComponent(file, options, path);
  return { std::move(file.mesh), "sha256:" + Sha256OfFile(path), std::move(file.notes), {} };
}

Surface
ReadRepairedSurface(const std::string & path, const SurfaceReadOptions & options)
{
  Surface surface = ReadSurface(path, options);
  RequireSound(surface.mesh, path);
  SurfaceRepairReport report;
  surface.mesh = RepairSurface(surface.mesh, {}, &report);
  surface.repairs = report.Words();
  if (report.nonOrientableComponents > 0)
  {
    RefuseSurface(path, "it is one-sided like a Moebius strip", "cut it open so that it has two sides");
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
