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
  const SurfaceReadOptions defaults;
  module.def("read_surface",
             &Read,
             "path"_a,
             py::kw_only(),
             "part"_a = defaults.part,
             "component"_a = defaults.component,
             "unit"_a = "file",
             "any_extent"_a = defaults.anyExtent,
             "repair"_a = false,
             R"(Reads VTP, STL, OBJ, PLY, OFF, glTF or GLB; LPS, mm.

part: name of a part of the file; "" for all. component: from 1, by number of faces; 0: the only one; -1: all.
unit: "file", or "m", "mm" or "um", which accept any extent. any_extent: accepts a surface that is not
between 5 mm and 5 m wide, with a note. repair: repairs as `repair_surface` does.

Repairs and doubts are in the `notes` of the mesh.)");
  module.def(
    "write_surface",
    [](const SurfaceMesh & mesh, const Path & path) { WriteSurface(mesh, path.text); },
    "mesh"_a,
    "path"_a,
    ReleaseGil(),
    "Writes VTP (all arrays and facts), STL, PLY or OBJ by extension; equal surfaces give byte-identical files.");
  module.def(
    "read_curves",
    [](const Path & path) { return ReadCurves(path.text); },
    "path"_a,
    ReleaseGil(),
    "Reads the lines and points of a VTP file, such as a centerline.");
  module.def(
    "write_curves",
    [](const CurveSet & curves, const Path & path) { WriteCurves(curves, path.text); },
    "curves"_a,
    "path"_a,
    ReleaseGil(),
    "Writes curves as VTP with their arrays and facts; equal curves give byte-identical files.");
}
} // namespace

void
AddSurfaces(py::module_ & module)
{
  AddFiles(module);
  module.def("inspect_surface",
             &Inspect,
             "mesh"_a,
             R"(Topology, measures and defects of a surface, as a dictionary with the keys of SurfaceInspector.

vertices, edges, faces, eulerCharacteristic, genus (None: not defined), manifold, closed, oriented, area (mm^2), volume
(mm^3; None if open), extent, components, boundaryLoops, edgeLength, smallestAngle (degrees), defects, ...)");
  module.def("repair_surface",
             &Repair,
             "mesh"_a,
             py::kw_only(),
             "merge_distance"_a = SurfaceRepairOptions().mergeDistance,
             "merge_vertices"_a = SurfaceRepairOptions().mergeVertices,
             "orient"_a = SurfaceRepairOptions().orient,
             "split"_a = SurfaceRepairOptions().split,
             ReleaseGil(),
             R"(A manifold, consistently oriented surface of the same faces: (mesh, repairs in words).

merge_vertices: merges vertices closer than merge_distance (mm; 0: coincident). orient: flips faces so that neighbors
agree. split: cuts the surface where it is not manifold.)");
  module.def(
    "simplify_surface",
    Reporting(&Simplify),
    "mesh"_a,
    "faces"_a,
    py::kw_only(),
    "smallest_angle"_a = SurfaceSimplificationOptions().smallestAngle,
    "boundary_weight"_a = SurfaceSimplificationOptions().boundaryWeight,
    "progress"_a = py::none(),
    ReleaseGil(),
    R"(A surface with at most this number of faces and the same topology, by edge collapses. Arrays are dropped.

smallest_angle: degrees, 0 to 30; no angle becomes smaller. boundary_weight: of boundary edges against faces.)");
  module.def("remesh_surface",
             Reporting(&Remesh),
             "mesh"_a,
             "edge_length"_a,
             py::kw_only(),
             "iterations"_a = SurfaceRemeshingOptions().iterations,
             "progress"_a = py::none(),
             ReleaseGil(),
             "A surface of nearly equilateral triangles with this edge length (mm). Its arrays are dropped.");
  module.def(
    "surface_area", [](const SurfaceMesh & mesh) { return SurfaceArea(mesh.V, mesh.F); }, "mesh"_a, "mm^2.");
  module.def(
    "enclosed_volume",
    [](const SurfaceMesh & mesh) { return EnclosedVolume(mesh.V, mesh.F); },
    "mesh"_a,
    "mm^3, of a closed oriented surface; negative if its faces are oriented inwards.");
}
} // namespace shapeton::python
