#include "Bindings.h"
#include "Conversions.h"
#include "Landmarks.h"
#include "Options.h"

#include "shapetonColonPointMapper.h"
#include "shapetonExaminationInputs.h"
#include "shapetonRegistrationErrors.h"
#include "shapetonRegistrationResults.h"

namespace shapeton::python
{
namespace
{
using Position = ColonPositionFiles;

/** Two positions and the map between them. */
struct Registered
{
  std::shared_ptr<const Position> supine;
  std::shared_ptr<const Position> prone;
  SupineProneRegistration         registration;
  RegistrationResults             results;
};

/** The contents of the landmark files. */
std::shared_ptr<Position>
PositionOf(const std::string &    name,
           const FoundLandmarks & found,
           const CurveSet &       centerline,
           const FoundFolds &     folds)
{
  const auto      files = std::make_shared<Position>();
  const Json      document = ColonLandmarksToJson(found.landmarks);
  ColonPosition & position = files->position;
  position.name = name;
  position.flat = found.flat;
  position.centerline = centerline;
  const auto flexures = FlexuresOf(document);
  for (std::size_t i = 0; i < flexures.size(); ++i)
  {
    position.flexures[i] = flexures[i].arcLength;
    position.flexureConfidence[i] = flexures[i].confidence;
  }
  position.taeniae = TaeniaCurves(found.landmarks.taeniae);
  position.folds = folds.folds.folds;
  position.curvature = found.landmarks.folds.curvature;
  position.isExcluded = FindExcludedColumns(*position.flat, position.centerline);
  files->segments = SegmentsOf(document, PointValues(centerline, "arcLength", name).maxCoeff());
  return files;
}

std::shared_ptr<Registered>
Register(const std::shared_ptr<Position> & supine,
         const std::shared_ptr<Position> & prone,
         const Given<SupineProneOptions> & given,
         const Progress &                  progress)
{
  const SupineProneSettings settings{ given.options, [&progress](const std::string & stage, double share) {
                                       progress(stage, 0.9 * share);
                                     } };
  const auto result = std::make_shared<Registered>();
  result->supine = supine;
  result->prone = prone;
  result->registration = RegisterColonPositions(supine->position, prone->position, settings);
  result->results =
    MakeRegistrationResults(*supine, *prone, result->registration, {}, progress.Part("Mapping the walls", 0.9, 1.0));
  return result;
}

/** (points, confidence, excluded) */
py::tuple
MapPoints(const Registered & registered, const VertexMatrix & points, bool inverse)
{
  const auto          number = static_cast<py::ssize_t>(points.rows());
  py::array_t<double> mapped({ number, py::ssize_t{ 3 } });
  py::array_t<double> confidence(number);
  py::array_t<bool>   excluded(number);
  double * const      places = mapped.mutable_data();
  double * const      confidences = confidence.mutable_data();
  bool * const        exclusions = excluded.mutable_data();
  {
    const WithoutGil       withoutGil;
    const ColonPointMapper mapper(registered.registration);
    for (py::ssize_t i = 0; i < number; ++i)
    {
      const Eigen::Vector3d point = points.row(i).transpose();
      const MappedPoint     place = inverse ? mapper.Inverse(point) : mapper.Forward(point);
      std::copy_n(place.point.data(), 3, places + 3 * i);
      confidences[i] = place.confidence;
      exclusions[i] = place.isExcluded;
    }
  }
  return py::make_tuple(mapped, confidence, excluded);
}

void
AddMatches(py::module_ & module)
{
  py::class_<MatchedFolds>(module, "MatchedFolds", "A pair of corresponding folds.")
    .def_readonly("supine_fold", &MatchedFolds::supineFold, "Label of the supine fold.")
    .def_readonly("prone_fold", &MatchedFolds::proneFold, "Label of the prone fold.")
    .def_readonly("supine_point", &MatchedFolds::supinePoint, "Center of the supine fold; LPS, mm.")
    .def_readonly("prone_point", &MatchedFolds::pronePoint, "Center of the prone fold; LPS, mm.")
    .def_readonly("segment", &MatchedFolds::segment, "Segment in the supine position; \"\" if unknown.")
    .def_readonly(
      "residual", &MatchedFolds::residual, "Distance between the mapped supine fold and the prone fold, mm.")
    .def_readonly(
      "weight", &MatchedFolds::weight, "Weight of the pair in the map, 0 to 1; pairs below 0.5 are ignored.");
}

void
AddPosition(py::module_ & module)
{
  py::class_<Position, std::shared_ptr<Position>>(
    module, "ColonPosition", "The colon in one position, for registration.")
    .def(py::init(&PositionOf), ReleaseGil())
    .def_property_readonly(
      "name", [](const Position & p) { return p.position.name; }, "Name used in messages.")
    .def_readonly("warnings", &Position::warnings, "Missing inputs that the registration does not require.");

  module.def(
    "read_position",
    [](const Path & folder, const std::string & name) {
      return std::make_shared<Position>(ReadColonPosition(ExaminationFolder(folder.text), name));
    },
    ReleaseGil());
}
} // namespace

void
AddRegistration(py::module_ & module)
{
  AddMatches(module);
  AddPosition(module);
  py::class_<Registered, std::shared_ptr<Registered>>(
    module, "Registration", "A map between the walls of two positions.")
    .def_property_readonly(
      "supine_to_prone",
      [](const Registered & r) -> const SurfaceMesh & { return r.results.supineToProne; },
      py::return_value_policy::reference_internal,
      "The flat supine wall with point arrays mapped (LPS, mm, on the prone wall), mappedUv, displacement (mm), "
      "confidence (0 to 1), excluded.")
    .def_property_readonly(
      "prone_to_supine",
      [](const Registered & r) -> const SurfaceMesh & { return r.results.proneToSupine; },
      py::return_value_policy::reference_internal,
      "The inverse map.")
    .def_property_readonly(
      "matches",
      [](const Registered & r) { return r.results.matches; },
      "List of MatchedFolds, in the order of supine folds.")
    .def_property_readonly(
      "confidence", [](const Registered & r) { return r.registration.confidence.whole; }, "0 to 1; flagged below 0.5.")
    .def_property_readonly(
      "doubts",
      [](const Registered & r) { return r.registration.confidence.reasons; },
      "Reasons for a flag; otherwise empty.")
    .def_property_readonly(
      "flips", [](const Registered & r) { return r.registration.figures.flips; }, "Number of flipped triangles.")
    .def_property_readonly(
      "warnings", [](const Registered & r) { return r.registration.warnings; }, "Warnings, one per line.")
    .def_property_readonly(
      "statistics",
      [](const Registered & r) { return FromJson(r.results.document); },
      "A dictionary with the keys of registration.json of ColonRegistration.")
    .def("map_points",
         &MapPoints,
         "points"_a,
         "inverse"_a = false,
         R"(Maps the wall points nearest to k x 3 points (LPS, mm) from supine to prone, or back with `inverse`.

Returns (points, k x 3, LPS mm; confidence, k, 0 to 1; excluded, k: wall not visible in one of the positions).)");

  module.def("register_positions", Reporting(&Register), ReleaseGil());
}
} // namespace shapeton::python
