#include "Bindings.h"
#include "Conversions.h"
#include "Landmarks.h"
#include "Options.h"

#include "shapetonFlatColonLocator.h"
#include "shapetonHaustralFolds.h"
#include "shapetonParallelFor.h"

namespace shapeton::python
{
namespace
{
using FlatPointer = std::shared_ptr<FlatColon>;

/** A picture of the grid: `values` numbers per pixel, written by `paint`. */
template <typename TValue, typename TPaint>
py::array_t<TValue>
PictureOf(const FlatColonGrid & grid, py::ssize_t values, const TPaint & paint)
{
  const auto               rows = static_cast<py::ssize_t>(grid.Rows());
  const auto               columns = static_cast<py::ssize_t>(grid.Columns());
  std::vector<py::ssize_t> shape{ rows, columns };
  if (values > 1)
  {
    shape.push_back(values);
  }
  py::array_t<TValue> picture(shape);
  TValue * const      pixels = picture.mutable_data();
  {
    const WithoutGil withoutGil;
    ParallelFor(grid.Rows(), [&](std::size_t row) {
      for (py::ssize_t column = 0; column < columns; ++column)
      {
        paint(static_cast<int>(column), static_cast<int>(row), pixels + (row * columns + column) * values);
      }
    });
  }
  return picture;
}

py::array
Coordinates(const FlatColon & flat)
{
  const FlatColonGrid & grid = flat.Grid();
  return PictureOf<float>(grid, 3, [&](int column, int row, float * pixel) {
    const Eigen::Vector3f point = grid.PointOfPixel(column, row).cast<float>();
    std::copy_n(point.data(), 3, pixel);
  });
}

py::array
FacesOfPixels(const FlatColon & flat)
{
  const FlatColonGrid & grid = flat.Grid();
  return PictureOf<int>(grid, 1, [&](int column, int row, int * pixel) { *pixel = grid.FaceOfPixel(column, row); });
}

py::array
Curvatures(const FlatColon & flat)
{
  const FlatColonGrid & grid = flat.Grid();
  return PictureOf<double>(grid, 1, [&](int column, int row, double * pixel) {
    const FlatSample sample = grid.SampleOfPixel(column, row);
    *pixel = sample.face < 0 ? std::nan("") : sample.curvature;
  });
}

/** (uv, distance) of points in space. */
py::tuple
Find(const FlatColon & flat, const VertexMatrix & points)
{
  py::array_t<double> uv({ static_cast<py::ssize_t>(points.rows()), py::ssize_t{ 2 } });
  py::array_t<double> distance(static_cast<py::ssize_t>(points.rows()));
  double * const      uvs = uv.mutable_data();
  double * const      distances = distance.mutable_data();
  {
    const WithoutGil       withoutGil;
    const FlatColonLocator locator(flat.Grid());
    ParallelFor(static_cast<std::size_t>(points.rows()), [&](std::size_t i) {
      const FlatPlace place = locator.Find(points.row(static_cast<Eigen::Index>(i)).transpose());
      std::copy_n(place.uv.data(), 2, uvs + 2 * i);
      distances[i] = place.distance;
    });
  }
  return py::make_tuple(uv, distance);
}

/** (row, column) of points on the map. */
py::array
PixelsOf(const FlatColon & flat, const Eigen::MatrixX2d & uv)
{
  py::array_t<int> pixels({ static_cast<py::ssize_t>(uv.rows()), py::ssize_t{ 2 } });
  for (py::ssize_t i = 0; i < static_cast<py::ssize_t>(uv.rows()); ++i)
  {
    const FlatPixel pixel = flat.Grid().PixelOfUv(uv.row(i).transpose());
    pixels.mutable_at(i, 0) = pixel.row;
    pixels.mutable_at(i, 1) = pixel.column;
  }
  return pixels;
}

void
AddFlat(py::module_ & module)
{
  py::class_<FlatColon, FlatPointer>(module, "FlatColon", "The flat wall of a colon with a grid of square pixels.")
    .def(py::init([](SurfaceMesh surface, double pixelSize) {
           FlatColonGridOptions options;
           options.pixelSize = pixelSize;
           auto flat = std::make_shared<FlatColon>(std::move(surface), options);
           flat->Grid(); // rejects surfaces that are not flat
           return flat;
         }),
         ReleaseGil())
    .def_property_readonly(
      "surface",
      [](const FlatColon & flat) -> const SurfaceMesh & { return flat.Surface(); },
      py::return_value_policy::reference_internal,
      "The flat surface.")
    .def_property_readonly(
      "shape",
      [](const FlatColon & flat) { return py::make_tuple(flat.Grid().Rows(), flat.Grid().Columns()); },
      "Rows (around the tube) and columns (along it) of the grid.")
    .def_property_readonly(
      "pixel_size", [](const FlatColon & flat) { return flat.Grid().PixelSize(); }, "mm on the map.")
    .def_property_readonly(
      "circumference", [](const FlatColon & flat) { return flat.Grid().Circumference(); }, "Mean circumference, mm.")
    .def_property_readonly(
      "length", [](const FlatColon & flat) { return flat.Grid().Length(); }, "Length of the map, mm.")
    .def(
      "coordinates", &Coordinates, "Rows x columns x 3, float32: point in space of each pixel, LPS mm; NaN in holes.")
    .def("faces", &FacesOfPixels, "Rows x columns, int32: the face at each pixel; -1 in holes.")
    .def("curvature",
         &Curvatures,
         "Rows x columns, float64: mean curvature, 1/mm; positive where the wall bulges into the lumen, NaN in holes.")
    .def("pixels",
         &PixelsOf,
         "uv"_a,
         "Pixels [row, column] (k x 2, int32) of points on the map (k x 2, mm). Rows may run against v.")
    .def("find",
         &Find,
         "points"_a,
         "uv on the map (k x 2) of points in space (k x 3, LPS, mm), and their distances from the wall (k); mm.");
}

FoundFolds
FindFolds(const FlatPointer &                flat,
          const Given<HaustralFoldOptions> & given,
          const std::optional<CurveSet> &    taeniae,
          const Progress &                   progress)
{
  return { FindHaustralFolds(
    *flat, { given.options, taeniae ? &*taeniae : nullptr, progress.Part("Finding folds", 0.0, 1.0) }) };
}

py::array
LabelsOf(const FoundFolds & found)
{
  const auto & labels = found.folds.labels;
  const auto   size = labels->GetBufferedRegion().GetSize();
  return py::array_t<unsigned short>({ size[1], size[0] }, labels->GetBufferPointer(), OwnerOf(labels));
}

void
AddFolds(py::module_ & module)
{
  using Ends = std::array<Eigen::Vector3d, 2>;
  py::class_<HaustralFold>(module, "HaustralFold", "A haustral fold.")
    .def_readonly("label", &HaustralFold::label, "Label value, from 1.")
    .def_readonly("center", &HaustralFold::center, "LPS, mm.")
    .def_property_readonly(
      "ends",
      [](const HaustralFold & fold) {
        const Ends & ends = fold.ends;
        return RowsOf({ ends[0], ends[1] });
      },
      "2 x 3; LPS, mm.")
    .def_readonly("center_uv", &HaustralFold::centerUv, "Center on the map, mm.")
    .def_readonly("length", &HaustralFold::length, "Length along the crest, mm.")
    .def_readonly("area", &HaustralFold::area, "mm^2.")
    .def_readonly("height", &HaustralFold::height, "Height of the crest above the wall, mm; NaN if not visible.")
    .def_readonly(
      "angle", &HaustralFold::angle, "Angle between the long axis and the tube, degrees; 90 is circumferential.")
    .def_readonly("elongation", &HaustralFold::elongation, "Ratio of long to short axis.")
    .def_readonly("mean_curvature", &HaustralFold::meanCurvature, "1/mm.")
    .def_readonly("reliability", &HaustralFold::reliability, "0 to 1.")
    .def_readonly("arc_length", &HaustralFold::arcLength, "mm along the centerline; NaN if unknown.")
    .def_readonly("crosses_cut", &HaustralFold::crossesCut, "Whether the fold extends across the cut.");

  py::class_<FoundFolds>(module, "HaustralFolds", "Result of `find_folds`.")
    .def_property_readonly("labels", &LabelsOf, "Rows x columns, uint16: 0 wall, otherwise the label of a fold.")
    .def_property_readonly(
      "folds", [](const FoundFolds & found) { return found.folds.folds; }, "List of HaustralFold, in label order.")
    .def_property_readonly(
      "warnings", [](const FoundFolds & found) { return found.folds.warnings; }, "Warnings, one per line.");

  module.def("find_folds", Reporting(&FindFolds), ReleaseGil());
}
} // namespace

void
AddFlatColon(py::module_ & module)
{
  AddFlat(module);
  AddFolds(module);
  AddLandmarks(module);
}
} // namespace shapeton::python
