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
Read(const Path & path, const Given<SurfaceReadOptions> & given, bool repair)
{
  Surface surface;
  {
    const WithoutGil withoutGil;
    surface = repair ? ReadRepairedSurface(path.text, given.options) : ReadSurface(path.text, given.options);
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
Repair(const SurfaceMesh & mesh, const Given<SurfaceRepairOptions> & given)
{
  SurfaceRepairReport report;
  SurfaceMesh         repaired = RepairSurface(mesh, given.options, &report);
  return { std::move(repaired), report.Words() };
}

SurfaceMesh
Simplify(const SurfaceMesh & mesh, const Given<SurfaceSimplificationOptions> & given, const Progress & progress)
{
  return SimplifySurface(mesh, { given.options, progress.Part("Simplifying the surface", 0.0, 1.0) });
}

SurfaceMesh
Remesh(const SurfaceMesh & mesh, const Given<SurfaceRemeshingOptions> & given, const Progress & progress)
{
  return RemeshSurface(mesh, { given.options, progress.Part("Remeshing the surface", 0.0, 1.0) });
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
