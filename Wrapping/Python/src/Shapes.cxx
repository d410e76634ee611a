#include "Bindings.h"
#include "Conversions.h"

#include "shapetonExceptions.h"
#include "shapetonShapeDatabase.h"
#include "shapetonVolume.h"

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
    module, "ShapeSignature", "What a shape is like, in numbers that neither place, rotation nor sampling change much.")
    .def_readonly("volume", &ShapeSignature::volume, "mm^3.")
    .def_readonly("surface", &ShapeSignature::surface, "mm^2.")
    .def_readonly("elongation", &ShapeSignature::elongation, "Longest over middle standard deviation; from 1.")
    .def_readonly("flatness", &ShapeSignature::flatness, "Middle over shortest standard deviation; from 1.")
    .def_property_readonly(
      "times",
      [](const ShapeSignature &) { return ArrayOf(ShapeSignature::Times()); },
      "25 times t / r^2 of both curves; r is the radius of the ball of the same volume.")
    .def_property_readonly(
      "remaining_heat",
      [](const ShapeSignature & s) { return ArrayOf(s.remainingHeat); },
      "25 values from 1 down: the share of heat that has not left the shape.")
    .def_property_readonly(
      "displacement",
      [](const ShapeSignature & s) { return ArrayOf(s.displacement); },
      "25 values, ascending: mean square of the way of heat that cannot leave, over r^2.")
    .def_property_readonly(
      "spectrum",
      [](const ShapeSignature & s) { return ArrayOf(s.spectrum); },
      "20 eigenvalues of the surface above 0, times its area; 8 pi is the first one of a sphere.");

  py::class_<ShapeRow>(module, "ShapeRow", "A shape of a label map.")
    .def_property_readonly("name", &ShapeRow::Name, "\"7\" or, for a component, \"7.1\".")
    .def_readonly("label", &ShapeRow::label, "From 1.")
    .def_readonly("component", &ShapeRow::component, "1 for the largest; 0 for the label as a whole.")
    .def_readonly("voxels", &ShapeRow::voxels, "How many.")
    .def_readonly("mean_intensity", &ShapeRow::meanIntensity, "Not part of the signature.")
    .def_readonly("intensity_deviation", &ShapeRow::intensityDeviation, "Standard deviation.")
    .def_readonly("signature", &ShapeRow::signature, "A ShapeSignature.");

  py::class_<ShapeTable>(module, "ShapeTable", "What `describe_shapes` gives.")
    .def_readonly("rows", &ShapeTable::rows, "By label, then component.")
    .def_readonly("warnings", &ShapeTable::remarks, "What was left out, a line for each.");
}

void
AddTables(py::module_ & module)
{
  module.def("describe_shapes",
             Reporting(+[](const LabelMap::Pointer & image,
                           const LabelMap::Pointer & labels,
                           bool                      components,
                           const Progress &          progress) {
               if (!HaveSameGrid(image, labels))
               {
                 throw InputError(
                   "the grids of the image and of the labels differ in size or place: give those that belong "
                   "together");
               }
               return DescribeShapes(image, labels, components, progress.Part("Describing shapes", 0.0, 1.0));
             }),
             "image"_a,
             "labels"_a,
             py::kw_only(),
             "components"_a = false,
             "progress"_a = py::none(),
             ReleaseGil(),
             R"(The signature of each label, or of each connected component of each label.

image: intensities, for mean_intensity alone. labels: whole numbers from 0 (background) to 65535, on the same grid.
progress: called with (share, stage), share from 0 to 1; False, or an exception such as that of Ctrl-C, aborts.

A shape takes half a second. What has fewer than 64 voxels or is too thin is left out with a warning.)");
  module.def(
    "write_shape_table",
    [](const ShapeTable & table, const Path & path) { WriteShapeTable(table, path.text); },
    "table"_a,
    "path"_a,
    ReleaseGil(),
    "Writes a CSV file, as the tool ShapeSignature does.");
  module.def(
    "read_shape_table",
    [](const Path & path) { return ReadShapeTable(path.text); },
    "path"_a,
    ReleaseGil(),
    "Reads what `write_shape_table` wrote.");
}

void
AddSearch(py::module_ & module)
{
  py::class_<NamedShape>(module, "NamedShape", "A signature with a name, which several may share.")
    .def(py::init([](const std::string & name, const ShapeSignature & signature) {
           return NamedShape{ name, signature };
         }),
         "name"_a,
         "signature"_a)
    .def_readonly("name", &NamedShape::name, "Any text.")
    .def_readonly("signature", &NamedShape::signature, "A ShapeSignature.");

  py::class_<ShapeNeighbour>(module, "ShapeNeighbour", "An entry and its distance.")
    .def_readonly("entry", &ShapeNeighbour::entry, "Its index.")
    .def_readonly("distance", &ShapeNeighbour::distance, "From 0; copies of one shape are about 1 apart.");

  py::class_<ShapeSearchResult>(module, "ShapeSearchResult", "What `find_shape` gives.")
    .def_readonly("neighbours", &ShapeSearchResult::neighbours, "The nearest first.")
    .def_readonly(
      "probability", &ShapeSearchResult::probability, "That the nearest is of the same shape, on generated shapes.")
    .def_property_readonly("unknown", &ShapeSearchResult::IsUnknown, "More likely than not it is none of them.");

  module.def("signature_distance",
             &SignatureDistance,
             "a"_a,
             "b"_a,
             ReleaseGil(),
             "How much two signatures differ, from 0; copies of one shape are about 1 apart. Volume takes no part.");
  module.def(
    "find_shape",
    [](const ShapeSignature & signature, const std::vector<NamedShape> & entries, std::size_t nearest) {
      RequireParameter(!entries.empty(), "the parameter \"entries\" is empty; give at least one shape");
      RequireParameter(nearest > 0, "the parameter \"nearest\" is 0; give at least 1");
      return FindShape(signature, entries, nearest);
    },
    "signature"_a,
    "entries"_a,
    "nearest"_a = 5,
    ReleaseGil(),
    "Looks a signature up among entries, a list of NamedShape; `nearest` neighbours at most.");
  module.def(
    "read_shape_database",
    [](const Path & path) { return ReadShapeDatabase(path.text); },
    "path"_a,
    ReleaseGil(),
    "All shapes of an SQLite file of the tool ShapeSearch, in the order in which they were added.");
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
