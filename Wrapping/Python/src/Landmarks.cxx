#include "Landmarks.h"

#include "Conversions.h"
#include "Options.h"

#include "shapetonColonSplitting.h"

namespace shapeton::python
{
namespace
{
FoundLandmarks
Find(const std::shared_ptr<FlatColon> &                   flat,
     const CurveSet &                                     centerline,
     const std::optional<itk::Image<float, 3>::Pointer> & ct,
     const Given<ColonLandmarkOptions> &                  given,
     const Places &                                       markers,
     const Progress &                                     progress)
{
  const auto pelvis = ct ? FindPelvis(*ct) : std::nullopt;
  return { flat, FindColonLandmarks(*flat, centerline, { given.options, markers.points, pelvis, progress }) };
}

/** The taeniae as in taeniae.vtp. */
CurveSet
TaeniaeOf(const FoundLandmarks & found)
{
  CurveSet taeniae = TaeniaCurves(found.landmarks.taeniae);
  if (found.landmarks.hindered)
  {
    MarkHindrances(*found.landmarks.hindered, taeniae);
  }
  return taeniae;
}

void
AddFlexure(py::module_ & module)
{
  py::class_<ColonFlexure>(module, "ColonFlexure", "A major bend of the colon, found or not.")
    .def_readonly("number", &ColonFlexure::number, "1 rectosigmoid, 2 descending-sigmoid, 3 splenic, 4 hepatic.")
    .def_property_readonly(
      "name", [](const ColonFlexure & flexure) { return NameOfFlexure(flexure.number); }, "For example \"splenic\".")
    .def_readonly("is_found", &ColonFlexure::isFound, "Whether it was found.")
    .def_readonly("reason", &ColonFlexure::reason, "Reason why it was not found; otherwise empty.")
    .def_readonly("point", &ColonFlexure::point, "Point on the centerline; LPS, mm.")
    .def_readonly("arc_length", &ColonFlexure::arcLength, "mm along the centerline.")
    .def_readonly(
      "confidence", &ColonFlexure::confidence, "Probability, 0 to 1, that the true flexure is within 30 mm.");
}

void
AddPieces(py::module_ & module)
{
  py::class_<ColonPiece>(module, "ColonPiece", "A segment of the colon, cut open along a taenia and flattened.")
    .def_readonly("segment", &ColonPiece::segment, "1 rectum to 6 cecum.")
    .def_readonly("name", &ColonPiece::name, "Name of the segment.")
    .def_readonly("flat", &ColonPiece::flat, "Surface in space, with the point array uv (mm on the rectangle).")
    .def_readonly("modulus_u", &ColonPiece::modulusU, "Height over width of the rectangle: an upper bound.")
    .def_readonly("modulus_v", &ColonPiece::modulusV, "Height over width of the rectangle: a lower bound.")
    .def_readonly("area", &ColonPiece::area, "mm^2.");

  module.def("split_colon",
             Reporting(+[](const FoundLandmarks & found, const Progress & progress) {
               ColonPieces pieces = SplitColon(found.flat->Surface(), found.landmarks, progress);
               return std::make_pair(std::move(pieces.pieces), std::move(pieces.warnings));
             }),
             ReleaseGil());
}
} // namespace

void
AddLandmarks(py::module_ & module)
{
  AddFlexure(module);
  py::class_<FoundLandmarks>(module, "ColonLandmarks", "Result of `find_landmarks`.")
    .def_property_readonly(
      "flexures",
      [](const FoundLandmarks & f) { return f.landmarks.flexures.flexures; },
      "Four flexures, starting at the rectum.")
    .def_property_readonly(
      "flexure_loops",
      [](const FoundLandmarks & f) { return FlexureCurves(f.landmarks); },
      "A closed loop on the wall for each flexure found; cell arrays flexure, arcLength, confidence.")
    .def_property_readonly(
      "taeniae",
      &TaeniaeOf,
      "Three curves on the wall, or none; point arrays arcLength (mm), uv (mm), confidence, cell array taenia.")
    .def_property_readonly(
      "segments",
      [](const FoundLandmarks & f) { return SegmentSurface(f.flat->Surface(), f.landmarks); },
      "The flat wall with the cell array segment: 1 rectum to 6 cecum, 0 unknown.")
    .def_property_readonly(
      "fold_surface",
      [](const FoundLandmarks & f) { return FoldSurface(f.flat->Surface(), f.landmarks); },
      "The flat wall with the cell array fold and the point array meanCurvature (1/mm).")
    .def_property_readonly(
      "valve",
      [](const FoundLandmarks & f) { return f.landmarks.valve; },
      "The valve stored in the centerline, or None.")
    .def_property_readonly(
      "is_mirrored",
      [](const FoundLandmarks & f) { return f.landmarks.flexures.isMirrored; },
      "Whether the colon is mirrored (situs inversus).")
    .def_property_readonly(
      "warnings", [](const FoundLandmarks & f) { return f.landmarks.warnings; }, "Missing landmarks, one per line.")
    .def_property_readonly(
      "statistics",
      [](const FoundLandmarks & f) { return FromJson(ColonLandmarksToJson(f.landmarks)); },
      "A dictionary with the keys of landmarks.json of ColonLandmarks.");

  module.def("find_landmarks", Reporting(&Find), ReleaseGil());
  AddPieces(module);
}
} // namespace shapeton::python
