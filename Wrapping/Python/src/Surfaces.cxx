#include "Bindings.h"
#include "Conversions.h"
#include "Options.h"

#include "shapetonJson.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRemeshing.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonSurfaceSimplification.h"
#include "shapetonSurfaceWriter.h"

namespace shapeton::python
{
namespace
{
py::object
Read(const Path & path, const std::string & part, int component, const std::string & unit, bool anyExtent, bool repair)
{
  SurfaceReadOptions options;
  options.part = part;
  options.component = component;
  options.unit = static_cast<SurfaceUnit>(PositionOf(unit, OptionInfo("unit").Words({ "file", "m", "mm", "um" })));
  options.anyExtent = anyExtent;
  Surface surface;
  {
    const WithoutGil withoutGil;
    surface = repair ? ReadRepairedSurface(path.text, options) : ReadSurface(path.text, options);
  }
  py::object mesh = py::cast(std::move(surface.mesh));
  AppendRemarks(surface.notes, surface.repairs);
  mesh.attr("notes") = surface.notes;
  return mesh;
}

py::dict
Inspect(const SurfaceMesh & mesh)
{
  Json document;
  {
    const WithoutGil withoutGil;
    document = SurfaceQualityToJson(InspectSurface(mesh));
  }
  return FromJson(document);
}

std::pair<SurfaceMesh, std::vector<std::string>>
Repair(const SurfaceMesh & mesh, double mergeDistance, bool mergeVertices, bool orient, bool split)
{
  SurfaceRepairReport report;
  SurfaceMesh         repaired = RepairSurface(mesh, { mergeVertices, mergeDistance, orient, split }, &report);
  return { std::move(repaired), report.Words() };
}

SurfaceMesh
Simplify(const SurfaceMesh & mesh, int faces, double smallestAngle, double boundaryWeight, const Progress & progress)
{
  return SimplifySurface(
    mesh, { { faces, smallestAngle, boundaryWeight }, progress.Part("Simplifying the surface", 0.0, 1.0) });
}

SurfaceMesh
Remesh(const SurfaceMesh & mesh, double edgeLength, int iterations, const Progress & progress)
{
  return RemeshSurface(mesh, { { edgeLength, iterations }, progress.Part("Remeshing the surface", 0.0, 1.0) });
}

void
AddFiles(py::module_ & module)
{
  module.def("read_surface", &Read);
  module.def(
    "write_surface", [](const SurfaceMesh & mesh, const Path & path) { WriteSurface(mesh, path.text); }, ReleaseGil());
  module.def(
    "read_curves", [](const Path & path) { return ReadCurves(path.text); }, ReleaseGil());
  module.def(
    "write_curves", [](const CurveSet & curves, const Path & path) { WriteCurves(curves, path.text); }, ReleaseGil());
}
} // namespace

void
AddSurfaces(py::module_ & module)
{
  AddFiles(module);
  module.def("inspect_surface", &Inspect);
  module.def("repair_surface", &Repair, ReleaseGil());
  module.def("simplify_surface", Reporting(&Simplify), ReleaseGil());
  module.def("remesh_surface", Reporting(&Remesh), ReleaseGil());
  module.def("surface_area", [](const SurfaceMesh & mesh) { return SurfaceArea(mesh.V, mesh.F); });
  module.def("enclosed_volume", [](const SurfaceMesh & mesh) { return EnclosedVolume(mesh.V, mesh.F); });
}
} // namespace shapeton::python
