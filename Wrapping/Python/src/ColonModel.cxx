#include "Bindings.h"
#include "Conversions.h"

#include "shapetonColonModel.h"
#include "shapetonColonQuality.h"
#include "shapetonElectronicCleansing.h"

namespace shapeton::python
{
namespace
{
using CtPointer = itk::Image<float, 3>::Pointer;
using MaskPointer = LumenMask::Pointer;

std::vector<itk::Point<double, 3>>
PointsOf(const Places & places)
{
  std::vector<itk::Point<double, 3>> points;
  for (const Eigen::Vector3d & place : places.points)
  {
    points.emplace_back(place.data());
  }
  return points;
}

ColonLumen
Segment(const CtPointer & ct, const std::string & position, const Places & seedPoints, const Progress & progress)
{
  return SegmentColonLumen(ct, { position, PointsOf(seedPoints), progress.Part("Finding the lumen", 0.0, 1.0) });
}

ColonCentreline
Trace(const MaskPointer &                          lumen,
      const std::optional<itk::Point<double, 3>> & start,
      const Places &                               seedPoints,
      int                                          exponent,
      double                                       minimumVolume,
      double                                       step,
      double                                       smoothing,
      const Progress &                             progress)
{
  ColonCentrelineOptions options;
  options.exponent = exponent;
  options.start = start;
  options.seedPoints = PointsOf(seedPoints);
  options.minimumVolume = minimumVolume;
  options.step = step;
  options.smoothing = smoothing;
  options.progress = progress.Part("Tracing the centreline", 0.0, 1.0);
  ColonCentreline centreline = TraceColonCentreline(lumen, options);
  if (!centreline.failure.empty())
  {
    throw InputError(centreline.failure);
  }
  return centreline;
}

ColonWallOptions
WallOptionsOf(int faces, double bridgeRadius, bool keepPieces, const Progress & progress)
{
  ColonWallOptions options;
  options.faces = faces;
  options.bridgeRadius = bridgeRadius;
  options.keepPieces = keepPieces;
  options.progress = progress.Part("Making the wall", 0.0, 1.0);
  return options;
}

ColonWall
Wall(const CtPointer & occupancy,
     const CurveSet &  centreline,
     int               faces,
     double            bridgeRadius,
     bool              keepPieces,
     const Progress &  progress)
{
  return BuildColonWall(occupancy, centreline, WallOptionsOf(faces, bridgeRadius, keepPieces, progress));
}

ColonWall
WallOfMask(const MaskPointer & mask,
           const CurveSet &    centreline,
           int                 faces,
           double              bridgeRadius,
           bool                keepPieces,
           const Progress &    progress)
{
  return BuildColonWallFromMask(mask, centreline, WallOptionsOf(faces, bridgeRadius, keepPieces, progress));
}

ColonModel
Model(const CtPointer &                  ct,
      const std::optional<MaskPointer> & lumen,
      const std::string &                position,
      const Places &                     seedPoints,
      int                                faces,
      bool                               keepPieces,
      bool                               keepPartial,
      const Progress &                   progress)
{
  ColonModelOptions options;
  options.patientPosition = position;
  options.seedPoints = PointsOf(seedPoints);
  options.faces = faces;
  options.keepPieces = keepPieces;
  options.keepPartial = keepPartial;
  options.progress = progress;
  return lumen ? BuildColonModel(ct, lumen->GetPointer(), options) : BuildColonModel(ct, options);
}

ColonModel
ModelOfLumen(const MaskPointer & lumen,
             const Places &      seedPoints,
             int                 faces,
             bool                keepPieces,
             bool                keepPartial,
             const Progress &    progress)
{
  ColonModelOptions options;
  options.seedPoints = PointsOf(seedPoints);
  options.faces = faces;
  options.keepPieces = keepPieces;
  options.keepPartial = keepPartial;
  options.progress = progress;
  return BuildColonModelOfLumen(lumen, options);
}

/** As catheter.vtp holds it; none where no catheter is sure. */
std::optional<CurveSet>
CatheterOf(const ColonLumen & lumen)
{
  return lumen.catheter && lumen.catheter->isSure ? std::optional<CurveSet>(CurveOfCatheter(*lumen.catheter))
                                                  : std::nullopt;
}

void
AddLumen(py::module_ & module)
{
  py::class_<ColonThresholds>(module, "ColonThresholds", "Intensities in HU, all from the data.")
    .def_readonly("gas", &ColonThresholds::gas, "Typical gas inside the body.")
    .def_readonly("tissue", &ColonThresholds::tissue, "Typical soft tissue.")
    .def_readonly("gas_boundary", &ColonThresholds::gasBoundary, "Half-height between them: where the wall begins.")
    .def_readonly("fluid", &ColonThresholds::fluid, "Mode of tagged fluid; 0 where there is none.")
    .def_readonly("fluid_boundary", &ColonThresholds::fluidBoundary, "Half-height between tissue and fluid.");

  py::class_<ColonLumen>(module, "ColonLumen", "What `segment_lumen` finds.")
    .def_readonly("labels", &ColonLumen::labels, "uint8: 1 gas, 2 fluid, 0 anything else.")
    .def_readonly("gravity", &ColonLumen::gravity, "Unit vector, LPS.")
    .def_readonly("thresholds", &ColonLumen::thresholds, "HU.")
    .def_readonly("noise", &ColonLumen::noise, "Standard deviation in soft tissue, HU.")
    .def_readonly("is_tagged", &ColonLumen::isTagged, "Fluid brighter than tissue lies under the colon's gas.")
    .def_property_readonly("catheter", &CatheterOf, "The axis of a rectal catheter as Curves; None where none is sure.")
    .def_readonly("warnings", &ColonLumen::warnings, "What is missing or doubtful, a line for each.")
    .def_readonly("failure", &ColonLumen::failure, "Why this is no usable colon; else empty.");

  py::class_<CleansedColon>(module, "CleansedColon", "What `cleanse` gives.")
    .def_readonly("ct", &CleansedColon::ct, "float32, HU: the CT with gas in place of fluid.")
    .def_readonly("occupancy",
                  &CleansedColon::occupancy,
                  "float32, 0 to 1, cropped: share of lumen in each voxel; the wall is where it is 0.5.");

  module.def("segment_lumen",
             Reporting(&Segment),
             "ct"_a,
             py::kw_only(),
             "patient_position"_a = ColonLumenOptions().patientPosition,
             "seed_points"_a = Places(),
             "progress"_a = py::none(),
             ReleaseGil(),
             R"(Finds gas and tagged fluid of the colon in a CT colonography, without seeds.

ct: Hounsfield units; any axes, spacing about 0.5 to 3 mm. patient_position: "HFS", "HFP", ..., "supine", "prone",
"leftDecubitus", "rightDecubitus"; "": gravity is inferred from fluid levels.
seed_points: k x 3, LPS mm; the pieces of gas or fluid that hold them are colon.)");
  module.def("cleanse",
             Reporting(+[](const CtPointer & ct, const ColonLumen & lumen, const Progress & progress) {
               return CleanseColon(ct, lumen, progress.Part("Cleansing the CT", 0.0, 1.0));
             }),
             "ct"_a,
             "lumen"_a,
             py::kw_only(),
             "progress"_a = py::none(),
             ReleaseGil(),
             "Removes the tagged fluid of a colon from the CT that `lumen` was found in.");
}

void
AddCentreline(py::module_ & module)
{
  py::class_<CentrelineGap>(module, "CentrelineGap", "A stretch without lumen that a centreline bridges.")
    .def_readonly("begin", &CentrelineGap::begin, "mm along the line.")
    .def_readonly("end", &CentrelineGap::end, "mm along the line.")
    .def_readonly("distance", &CentrelineGap::distance, "Straight distance of the ends of the lumen, mm.")
    .def_readonly("is_doubtful", &CentrelineGap::isDoubtful, "Longer than a collapsed stretch is known to be.");

  py::class_<SegmentDistension>(module, "SegmentDistension", "How far a stretch of the colon is filled.")
    .def_readonly("name", &SegmentDistension::name, "Of the segment.")
    .def_readonly("begin", &SegmentDistension::begin, "mm along the centreline.")
    .def_readonly("end", &SegmentDistension::end, "mm along the centreline.")
    .def_readonly("share", &SegmentDistension::share, "Of its length with a calibre of at least 10 mm, 0 to 1.")
    .def_readonly("mean_calibre", &SegmentDistension::meanCalibre, "Mean inner diameter, mm.")
    .def_readonly("collapsed_length", &SegmentDistension::collapsedLength, "Without lumen, mm.");

  py::class_<ColonCentreline>(module, "ColonCentreline", "The middle line of a colon from the rectum to the caecum.")
    .def_readonly(
      "curve", &ColonCentreline::curve, "One curve; point arrays arcLength (mm), radius (mm), gap (1 on a bridge).")
    .def_readonly("length", &ColonCentreline::length, "mm.")
    .def_readonly("gaps", &ColonCentreline::gaps, "Stretches that it bridges.")
    .def_readonly("coverage", &ColonCentreline::coverage, "Share of the lumen beside the line, 0 to 1.")
    .def_readonly("warnings", &ColonCentreline::warnings, "What is doubtful, a line for each.");

  module.def("trace_centreline",
             Reporting(&Trace),
             "lumen"_a,
             py::kw_only(),
             "start"_a = py::none(),
             "seed_points"_a = Places(),
             "exponent"_a = ColonCentrelineOptions().exponent,
             "minimum_volume"_a = ColonCentrelineOptions().minimumVolume,
             "step"_a = ColonCentrelineOptions().step,
             "smoothing"_a = ColonCentrelineOptions().smoothing,
             "progress"_a = py::none(),
             ReleaseGil(),
             R"(The centreline of the colon from a mask of its lumen (uint8, not 0).

start: where it begins in the rectum, LPS mm; None: found. seed_points: k x 3, LPS mm; pieces next to them are used.
exponent: one mm of path costs 1 / (distance to the wall)^exponent. minimum_volume: of a piece of lumen, ml.
step: between points of the line, mm. smoothing: standard deviation along the line, mm.)");
  module.def(
    "measure_distension",
    [](const CurveSet & centreline) { return MeasureDistension(centreline); },
    "centreline"_a,
    "How far each segment is distended, by customary shares of the length.");
}

void
AddValve(py::module_ & module)
{
  py::class_<IleocaecalValve>(module, "IleocaecalValve", "Where the terminal ileum opens into a colon.")
    .def_readonly("position", &IleocaecalValve::position, "LPS, mm.")
    .def_readonly("arc_length", &IleocaecalValve::arcLength, "mm along the centreline.")
    .def_readonly("length", &IleocaecalValve::length, "mm, greatest width.")
    .def_readonly("width", &IleocaecalValve::width, "mm, least width.")
    .def_readonly("attenuation", &IleocaecalValve::attenuation, "Median HU inside; NaN without a CT.")
    .def_readonly("confidence", &IleocaecalValve::confidence, "0 to 1.");

  module.def(
    "find_valve",
    [](const MaskPointer & labels, const CurveSet & centreline, const std::optional<CtPointer> & ct) {
      ValveSearch search = FindIleocaecalValve(labels, ct ? ct->GetPointer() : nullptr, centreline);
      return std::make_pair(search.valve, search.reason);
    },
    "labels"_a,
    "centreline"_a,
    "ct"_a = py::none(),
    ReleaseGil(),
    R"(The ileocaecal valve: (IleocaecalValve or None, why it was not found).

labels: the lumen, not 0. centreline: as `trace_centreline` gives it. ct: HU on the same grid; None: by shape alone.)");
}

void
AddWall(py::module_ & module)
{
  py::class_<ColonWall>(module, "ColonWall", "The wall of a colon in three forms, each open at rectum and caecum.")
    .def_readonly("raw", &ColonWall::raw, "With all its handles.")
    .def_readonly("repaired", &ColonWall::repaired, "Without handles, smoothed.")
    .def_readonly("simplified", &ColonWall::simplified, "The repaired one with fewer faces.")
    .def_property_readonly(
      "genus_before", [](const ColonWall & wall) { return wall.report.rawGenus; }, "Handles of the raw wall.")
    .def_property_readonly(
      "genus_after", [](const ColonWall & wall) { return wall.report.repairedGenus; }, "Handles of the repaired wall.")
    .def_property_readonly(
      "warnings", [](const ColonWall & wall) { return wall.report.warnings; }, "What is doubtful, a line for each.");

  const ColonWallOptions defaults;
  module.def("build_wall",
             Reporting(&Wall),
             "occupancy"_a,
             "centreline"_a,
             py::kw_only(),
             "faces"_a = defaults.faces,
             "bridge_radius"_a = defaults.bridgeRadius,
             "keep_pieces"_a = defaults.keepPieces,
             "progress"_a = py::none(),
             ReleaseGil(),
             R"(The wall as surfaces, from the occupancy that `cleanse` gives.

centreline: as `trace_centreline` gives it. faces: of the simplified wall; 0: a number that suits it.
bridge_radius: of tubes through gaps, mm. keep_pieces: leaves the pieces of a broken lumen apart.)");
  module.def("build_wall_of_mask",
             Reporting(&WallOfMask),
             "mask"_a,
             "centreline"_a,
             py::kw_only(),
             "faces"_a = defaults.faces,
             "bridge_radius"_a = defaults.bridgeRadius,
             "keep_pieces"_a = defaults.keepPieces,
             "progress"_a = py::none(),
             ReleaseGil(),
             "The wall from a mask of the lumen (uint8, not 0); parameters as those of `build_wall`.");
}

void
AddModel(py::module_ & module)
{
  py::class_<ColonModel>(module, "ColonModel", "A colon: lumen, centreline and wall.")
    .def_readonly("lumen", &ColonModel::lumen, "ColonLumen.")
    .def_readonly("cleansed", &ColonModel::cleansed, "float32, HU; None of a mask.")
    .def_readonly("centreline", &ColonModel::centreline, "ColonCentreline; its curve knows the valve.")
    .def_property_readonly(
      "valve",
      [](const ColonModel & model) { return model.valve.valve; },
      "IleocaecalValve; None where it was not found.")
    .def_readonly("distension", &ColonModel::distension, "Of the segments.")
    .def_readonly("wall", &ColonModel::wall, "ColonWall.")
    .def_readonly("warnings", &ColonModel::warnings, "Of all stages, a line for each.")
    .def_readonly("failure", &ColonModel::failure, "Why this is no usable colon; else empty.")
    .def_property_readonly(
      "statistics",
      [](const ColonModel & model) { return FromJson(ColonQualityToJson(model)); },
      "A dictionary with the keys of quality.json that ColonSegmentation writes.");

  const ColonModelOptions defaults;
  module.def("build_colon",
             Reporting(&Model),
             "ct"_a,
             py::kw_only(),
             "lumen"_a = py::none(),
             "patient_position"_a = defaults.patientPosition,
             "seed_points"_a = Places(),
             "faces"_a = defaults.faces,
             "keep_pieces"_a = defaults.keepPieces,
             "keep_partial"_a = defaults.keepPartial,
             "progress"_a = py::none(),
             ReleaseGil(),
             R"(From a CT colonography in HU to lumen, cleansed CT, centreline, valve, distension and wall.

lumen: a mask (uint8, not 0) on the grid of the CT in place of the automatic one. patient_position, seed_points: see
`segment_lumen`. faces, keep_pieces: see `build_wall`. keep_partial: where the colon is not distended or tagged enough,
goes on as far as that leads.

A colon that cannot be used is no exception: `failure` tells why.)");
  module.def("build_colon_of_lumen",
             Reporting(&ModelOfLumen),
             "lumen"_a,
             py::kw_only(),
             "seed_points"_a = Places(),
             "faces"_a = defaults.faces,
             "keep_pieces"_a = defaults.keepPieces,
             "keep_partial"_a = defaults.keepPartial,
             "progress"_a = py::none(),
             ReleaseGil(),
             "From a mask of the lumen alone (uint8, not 0); parameters as those of `build_colon`.");
}
} // namespace

void
AddColonModel(py::module_ & module)
{
  AddLumen(module);
  AddCentreline(module);
  AddValve(module);
  AddWall(module);
  AddModel(module);
}
} // namespace shapeton::python
