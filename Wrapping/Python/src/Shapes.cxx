#include "Bindings.h"
#include "Conversions.h"
#include "Options.h"

#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonShapeDatabase.h"

namespace shapeton::python
{
namespace
{
template <std::size_t VLength>
py::array_t<double>
ArrayOf(const std::array<double, VLength> & numbers)
{
  return py::array_t<double>(VLength, numbers.data());
}

void
AddSignature(py::module_ & module)
{
  py::class_<ShapeSignature>(
    module, "ShapeSignature", "Shape descriptors that are nearly invariant to position, rotation and sampling.")
    .def_readonly("volume", &ShapeSignature::volume, "mm^3.")
    .def_readonly("surface", &ShapeSignature::surface, "mm^2.")
    .def_readonly(
      "elongation", &ShapeSignature::elongation, "Ratio of longest to middle standard deviation; at least 1.")
    .def_readonly("flatness", &ShapeSignature::flatness, "Ratio of middle to shortest standard deviation; at least 1.")
    .def_property_readonly(
      "times",
      [](const ShapeSignature &) { return ArrayOf(ShapeSignature::Times()); },
      "25 values of t / r^2 for both curves, with r the radius of the ball of equal volume.")
    .def_property_readonly(
      "remaining_heat",
      [](const ShapeSignature & s) { return ArrayOf(s.remainingHeat); },
      "25 values, descending from 1: fraction of the heat remaining in the shape.")
    .def_property_readonly(
      "displacement",
      [](const ShapeSignature & s) { return ArrayOf(s.displacement); },
      "25 values, ascending: mean squared displacement of heat in the insulated shape, divided by r^2.")
    .def_property_readonly(
      "spectrum",
      [](const ShapeSignature & s) { return ArrayOf(s.spectrum); },
      "20 nonzero eigenvalues of the surface, times its area; the first one of a sphere is 8 pi.");

  py::class_<ShapeRow>(module, "ShapeRow", "A shape of a label map.")
    .def_property_readonly("name", &ShapeRow::Name, "\"7\" or, for a component, \"7.1\".")
    .def_readonly("label", &ShapeRow::label, "From 1.")
    .def_readonly("component", &ShapeRow::component, "1 for the largest; 0 for the whole label.")
    .def_readonly("voxels", &ShapeRow::voxels, "Number of voxels.")
    .def_readonly("mean_intensity", &ShapeRow::meanIntensity, "Not part of the signature.")
    .def_readonly("intensity_deviation", &ShapeRow::intensityDeviation, "Standard deviation.")
    .def_readonly("signature", &ShapeRow::signature, "A ShapeSignature.");

  py::class_<ShapeTable>(module, "ShapeTable", "Result of `describe_shapes`.")
    .def_readonly("rows", &ShapeTable::rows, "Rows by label, then component.")
    .def_readonly("warnings", &ShapeTable::remarks, "Skipped shapes, one per line.");
}

void
AddTables(py::module_ & module)
{
  module.def("describe_shapes",
             Reporting(+[](const LabelMap::Pointer &        image,
                           const LabelMap::Pointer &        labels,
                           const Given<ShapeTableOptions> & given,
                           const Progress &                 progress) {
               if (!HaveSameGrid(image, labels))
               {
                 throw InputError(
                   "the grids of the image and of the labels differ; use labels on the grid of the image");
               }
               return DescribeShapes(image, labels, given.options, progress.Part("Describing shapes", 0.0, 1.0));
             }),
             ReleaseGil());
  module.def(
    "write_shape_table",
    [](const ShapeTable & table, const Path & path) { WriteShapeTable(table, path.text); },
    ReleaseGil());
  module.def(
    "read_shape_table", [](const Path & path) { return ReadShapeTable(path.text); }, ReleaseGil());
}

void
AddSearch(py::module_ & module)
{
  py::class_<NamedShape>(module, "NamedShape", "A signature with a name, not necessarily unique.")
    .def(py::init([](const std::string & name, const ShapeSignature & signature) {
      return NamedShape{ name, signature };
    }))
    .def_readonly("name", &NamedShape::name, "Any text.")
    .def_readonly("signature", &NamedShape::signature, "A ShapeSignature.");

  py::class_<ShapeNeighbor>(module, "ShapeNeighbor", "An entry and its distance.")
    .def_readonly("entry", &ShapeNeighbor::entry, "Index of the entry.")
    .def_readonly("distance", &ShapeNeighbor::distance, "At least 0; copies of one shape are about 1 apart.");

  py::class_<ShapeSearchResult>(module, "ShapeSearchResult", "Result of `find_shape`.")
    .def_readonly("neighbors", &ShapeSearchResult::neighbors, "Nearest first.")
    .def_readonly("probability",
                  &ShapeSearchResult::probability,
                  "Probability that the nearest entry is the same shape, fitted to generated shapes.")
    .def_property_readonly(
      "unknown", &ShapeSearchResult::IsUnknown, "Whether the shape is probably none of the entries.");

  module.def("signature_distance", &SignatureDistance, ReleaseGil());
  module.def(
    "find_shape",
    [](const ShapeSignature &            signature,
       const std::vector<NamedShape> &   entries,
       const Given<ShapeSearchOptions> & given) {
      RequireParameter(!entries.empty(), "the parameter \"entries\" is empty; at least one shape is required");
      return FindShape(signature, entries, given.options);
    },
    ReleaseGil());
  module.def(
    "read_shape_database", [](const Path & path) { return ReadShapeDatabase(path.text); }, ReleaseGil());
}
} // namespace

void
AddShapes(py::module_ & module)
{
  AddSignature(module);
  AddTables(module);
  AddSearch(module);
}
} // namespace shapeton::python
