#include "Bindings.h"
#include "Conversions.h"
#include "Options.h"

#include "shapetonColonFlattening.h"
#include "shapetonConformalMap.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonSurfaceRicciFlow.h"

#include <pybind11/complex.h>

namespace shapeton::python
{
namespace
{
ConformalMap
MapOf(const SurfaceMesh &                    mesh,
      const Given<ConformalMapOptions> &     given,
      const std::optional<Eigen::VectorXd> & edgeLengths,
      const Progress &                       progress)
{
  return MapConformally(
    mesh, { given.options, edgeLengths.value_or(Eigen::VectorXd()), progress.Part("Mapping", 0.0, 1.0) }, "the mesh");
}

SurfaceRicciFlow
FlowOf(const SurfaceMesh &                    mesh,
       const Given<SurfaceRicciFlowOptions> & given,
       const std::optional<Eigen::VectorXd> & curvatures,
       const std::optional<Eigen::VectorXd> & edgeLengths,
       const Progress &                       progress)
{
  return FlowSurface(
    mesh,
    { given.options, curvatures.value_or(Eigen::VectorXd()), edgeLengths.value_or(Eigen::VectorXd()), progress },
    "the mesh");
}

ColonFlattening
Flatten(SurfaceMesh                           mesh,
        const std::optional<CurveSet> &       centerline,
        const Given<ColonFlatteningOptions> & given,
        const std::optional<CurveSet> &       cut,
        const Progress &                      progress)
{
  ColonFlatteningSettings settings{ given.options, {}, centerline.value_or(CurveSet()), progress };
  if (cut)
  {
    settings.cut = OnlyCurve(*cut, "the cut");
  }
  return FlattenColon(std::move(mesh), "the mesh", settings);
}

/** The JSON of a result as a dictionary. */
template <typename TResult>
auto
Statistics(Json (*toJson)(const TResult &))
{
  return [toJson](const TResult & result) { return FromJson(toJson(result)); };
}

void
AddConformalMap(py::module_ & module)
{
  py::class_<ConformalMap>(module, "ConformalMap", "A planar map of a surface, with quality measures.")
    .def_readonly("flat", &ConformalMap::flat, "The cut surface in space with the point array uv (mm in the plane).")
    .def_readonly("modulus_u", &ConformalMap::modulusU, "Height over width of the rectangle, or 2 pi / ln(R / r).")
    .def_readonly("modulus_v", &ConformalMap::modulusV, "The modulus from the conjugate; the gap is the error bar.")
    .def_readonly("genus", &ConformalMap::genus, "Genus; 0 without handles.")
    .def_readonly("flips", &ConformalMap::flips, "Number of flipped faces.")
    .def_readonly("corners", &ConformalMap::corners, "Four corner vertices, for a rectangle with one boundary.")
    .def_readonly("warnings", &ConformalMap::warnings, "Doubtful results, one per line.")
    .def_property_readonly(
      "dilatation",
      [](const ConformalMap & map) { return map.distortion.dilatation; },
      "Dilatation of each face, at least 1 (conformal).")
    .def_property_readonly("statistics",
                           Statistics<ConformalMap>(&ConformalMapToJson),
                           "A dictionary with the keys of the statistics of ConformalMap.");

  module.def("conformal_map", Reporting(&MapOf), ReleaseGil());
}

void
AddSurfaceRicciFlow(py::module_ & module)
{
  py::class_<SurfaceRicciFlow>(module, "SurfaceRicciFlow", "A surface with a metric of prescribed curvature.")
    .def_readonly("flat",
                  &SurfaceRicciFlow::flat,
                  "The cut surface in space with the point array uv (mm, or in the unit disk) or sphere.")
    .def_readonly("genus", &SurfaceRicciFlow::genus, "Number of handles.")
    .def_readonly("curvatures", &SurfaceRicciFlow::curvatures, "Curvature of each vertex, radians.")
    .def_readonly("residual", &SurfaceRicciFlow::residual, "Largest curvature error, radians.")
    .def_readonly("steps", &SurfaceRicciFlow::steps, "Number of Newton steps.")
    .def_readonly("flips", &SurfaceRicciFlow::flips, "Number of flips during the flow.")
    .def_readonly("log_scales", &SurfaceRicciFlow::logScales, "Logarithm of the length scale at each vertex.")
    .def_readonly("edge_lengths",
                  &SurfaceRicciFlow::edgeLengths,
                  "Geodesic length in place of each edge, in the order of surfaces.surface_edges.")
    .def_readonly("triangles", &SurfaceRicciFlow::triangles, "Faces of the final triangulation.")
    .def_readonly("sides", &SurfaceRicciFlow::sides, "Side lengths of these faces, from each corner to the next.")
    .def_readonly("tau", &SurfaceRicciFlow::tau, "Quotient of the periods of a flat torus; 0 for others.")
    .def_readonly("modulus", &SurfaceRicciFlow::modulus, "Circumference over length of a flat tube; 0 for others.")
    .def_readonly("warnings", &SurfaceRicciFlow::warnings, "Doubtful results, one per line.")
    .def_property_readonly("statistics",
                           Statistics<SurfaceRicciFlow>(&SurfaceRicciFlowToJson),
                           "A dictionary with the keys of the statistics of SurfaceRicciFlow.");

  module.def("flow_surface", Reporting(&FlowOf), ReleaseGil());
}
} // namespace

void
AddFlattening(py::module_ & module)
{
  AddConformalMap(module);
  AddSurfaceRicciFlow(module);
  py::class_<SurfaceHandle>(module, "SurfaceHandle", "A handle of a flattened surface.")
    .def_readonly("genus", &SurfaceHandle::genus, "Number of handles: more than 1 if they cannot be separated.")
    .def_readonly("place", &SurfaceHandle::place, "LPS, mm.")
    .def_readonly("flat_place", &SurfaceHandle::flatPlace, "Position on the map, mm.")
    .def_readonly("radius", &SurfaceHandle::radius, "mm.")
    .def_readonly("vertices", &SurfaceHandle::vertices, "Vertices of the flattened surface, ascending.");

  py::class_<ColonFlattening>(module, "ColonFlattening", "A flattened tube with its measurements.")
    .def_readonly("surface", &ColonFlattening::surface, "The flattened surface in space.")
    .def_property_readonly(
      "flat",
      [](const ColonFlattening & flattening) -> const SurfaceMesh & { return flattening.map.flat; },
      py::return_value_policy::reference_internal,
      "The tube cut open: points in space, the point arrays uv (mm: along, around) and sourcePointId, the field "
      "arrays circumference and length (mm).")
    .def_property_readonly(
      "circumference", [](const ColonFlattening & f) { return f.map.circumference; }, "Mean circumference, mm.")
    .def_property_readonly(
      "length", [](const ColonFlattening & f) { return f.map.length; }, "Length of the map, mm.")
    .def_property_readonly(
      "handles", [](const ColonFlattening & f) { return f.handles.handles; }, "Handles; most walls have none.")
    .def_readonly("genus_before", &ColonFlattening::genusBefore, "Number of handles of the input surface.")
    .def_readonly("genus_after", &ColonFlattening::genusAfter, "Number of handles of the flattened surface.")
    .def_readonly("warnings", &ColonFlattening::warnings, "Doubtful results, one per line.")
    .def_property_readonly("statistics",
                           Statistics<ColonFlattening>(&ColonFlatteningToJson),
                           "A dictionary with the keys of the statistics of ColonFlattening: flips, dilatation, "
                           "moduli, ...");

  module.def("flatten_tube", Reporting(&Flatten), ReleaseGil());
}
} // namespace shapeton::python
