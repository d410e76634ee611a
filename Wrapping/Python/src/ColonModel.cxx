#include "Bindings.h"
#include "Conversions.h"
#include "Options.h"

#include "shapetonColonModel.h"
#include "shapetonColonQuality.h"
#include "shapetonElectronicCleansing.h"

namespace shapeton::python
{
namespace
{
using CtPointer = itk::Image<float, 3>::Pointer;
using MaskPointer = LumenMask::Pointer;

ColonLumen
Segment(const CtPointer & ct, const Given<ColonLumenOptions> & given, const Progress & progress)
{
  return SegmentColonLumen(ct, { given.options, progress.Part("Finding the lumen", 0.0, 1.0) });
}

ColonCenterline
Trace(const MaskPointer & lumen, const Given<ColonCenterlineOptions> & given, const Progress & progress)
{
  ColonCenterline centerline =
    TraceColonCenterline(lumen, { given.options, progress.Part("Tracing the centerline", 0.0, 1.0) });
  if (!centerline.failure.empty())
  {
    throw InputError(centerline.failure);
  }
  return centerline;
}

ColonWallSettings
WallSettings(const Given<ColonWallOptions> & given, const Progress & progress)
{
  return { given.options, {}, {}, progress.Part("Making the wall", 0.0, 1.0), {} };
}

ColonWall
Wall(const CtPointer &               occupancy,
     const CurveSet &                centerline,
     const Given<ColonWallOptions> & given,
     const Progress &                progress)
{
  return BuildColonWall(occupancy, centerline, WallSettings(given, progress));
}

ColonWall
WallOfMask(const MaskPointer &             mask,
           const CurveSet &                centerline,
           const Given<ColonWallOptions> & given,
           const Progress &                progress)
{
  return BuildColonWallFromMask(mask, centerline, WallSettings(given, progress));
}

ColonModelSettings
ModelSettings(const Given<ColonModelOptions> & given, const Progress & progress)
{
  ColonModelSettings settings;
  static_cast<ColonModelOptions &>(settings) = given.options;
  settings.progress = progress;
  return settings;
}

ColonModel
Model(const CtPointer &                  ct,
      const std::optional<MaskPointer> & lumen,
      const Given<ColonModelOptions> &   given,
      const Progress &                   progress)
{
  const ColonModelSettings settings = ModelSettings(given, progress);
  return lumen ? BuildColonModel(ct, lumen->GetPointer(), settings) : BuildColonModel(ct, settings);
}

ColonModel
ModelOfLumen(const MaskPointer & lumen, const Given<ColonModelOptions> & given, const Progress & progress)
{
  return BuildColonModelOfLumen(lumen, ModelSettings(given, progress));
}

/** The catheter as in catheter.vtp; None unless one was found with certainty. */
std::optional<CurveSet>
CatheterOf(const ColonLumen & lumen)
{
  return lumen.catheter && lumen.catheter->isSure ? std::optional<CurveSet>(CurveOfCatheter(*lumen.catheter))
                                                  : std::nullopt;
}

void
AddLumen(py::module_ & module)
{
  py::class_<ColonThresholds>(module, "ColonThresholds", "Intensities in HU, all estimated from the data.")
    .def_readonly("gas", &ColonThresholds::gas, "Typical gas inside the body.")
    .def_readonly("tissue", &ColonThresholds::tissue, "Typical soft tissue.")
    .def_readonly("gas_boundary", &ColonThresholds::gasBoundary, "Mean of gas and tissue: the boundary of the wall.")
    .def_readonly("fluid", &ColonThresholds::fluid, "Mode of tagged fluid; 0 without fluid.")
    .def_readonly("fluid_boundary", &ColonThresholds::fluidBoundary, "Mean of tissue and fluid.");

  py::class_<ColonLumen>(module, "ColonLumen", "Result of `segment_lumen`.")
    .def_readonly("labels", &ColonLumen::labels, "uint8: 1 gas, 2 fluid, 0 otherwise.")
    .def_readonly("gravity", &ColonLumen::gravity, "Unit vector of gravity, LPS.")
    .def_readonly("thresholds", &ColonLumen::thresholds, "HU.")
    .def_readonly("noise", &ColonLumen::noise, "Standard deviation in soft tissue, HU.")
    .def_readonly(
      "is_tagged", &ColonLumen::isTagged, "Whether fluid brighter than tissue was found below the gas of the colon.")
    .def_property_readonly(
      "catheter", &CatheterOf, "Axis of a rectal catheter as Curves; None unless one was found with certainty.")
    .def_readonly("warnings", &ColonLumen::warnings, "Missing or doubtful results, one per line.")
    .def_readonly("failure", &ColonLumen::failure, "Reason why the colon is not usable; otherwise empty.");

  py::class_<CleansedColon>(module, "CleansedColon", "Result of `cleanse`.")
    .def_readonly("ct", &CleansedColon::ct, "float32, HU: the CT with fluid replaced by gas.")
    .def_readonly("occupancy",
                  &CleansedColon::occupancy,
                  "float32, 0 to 1, cropped: lumen fraction of each voxel; the wall is the 0.5 isosurface.");

  module.def("segment_lumen", Reporting(&Segment), ReleaseGil());
  module.def("cleanse",
             Reporting(+[](const CtPointer & ct, const ColonLumen & lumen, const Progress & progress) {
               return CleanseColon(ct, lumen, progress.Part("Cleansing the CT", 0.0, 1.0));
             }),
             ReleaseGil());
}

void
AddCenterline(py::module_ & module)
{
  py::class_<CenterlineGap>(module, "CenterlineGap", "A section without lumen, bridged by the centerline.")
    .def_readonly("begin", &CenterlineGap::begin, "Start along the line, mm.")
    .def_readonly("end", &CenterlineGap::end, "End along the line, mm.")
    .def_readonly("distance", &CenterlineGap::distance, "Straight distance between the ends of the lumen, mm.")
    .def_readonly("is_doubtful", &CenterlineGap::isDoubtful, "Whether it is longer than known collapsed segments.");

  py::class_<ColonDistension>(module, "ColonDistension", "Distension of a stretch of the colon.")
    .def_readonly("begin", &ColonDistension::begin, "Start along the centerline, mm.")
    .def_readonly("end", &ColonDistension::end, "End along the centerline, mm.")
    .def_readonly("share", &ColonDistension::share, "Fraction of its length with a diameter of at least 10 mm, 0 to 1.")
    .def_readonly("mean_caliber", &ColonDistension::meanCaliber, "Mean inner diameter, mm.")
    .def_readonly("collapsed_length", &ColonDistension::collapsedLength, "Length without lumen, mm.");

  py::class_<ColonCenterline>(module, "ColonCenterline", "The centerline of a colon from the rectum to the cecum.")
    .def_readonly(
      "curve", &ColonCenterline::curve, "One curve; point arrays arcLength (mm), radius (mm), gap (1 on a bridge).")
    .def_readonly("length", &ColonCenterline::length, "mm.")
    .def_readonly("gaps", &ColonCenterline::gaps, "Bridged gaps.")
    .def_readonly("coverage", &ColonCenterline::coverage, "Fraction of the lumen along the line, 0 to 1.")
    .def_readonly("warnings", &ColonCenterline::warnings, "Doubtful results, one per line.");

  module.def("trace_centerline", Reporting(&Trace), ReleaseGil());
  module.def("measure_distension", &MeasureDistension);
}

void
AddValve(py::module_ & module)
{
  py::class_<IleocecalValve>(module, "IleocecalValve", "The opening of the terminal ileum into the colon.")
    .def_readonly("position", &IleocecalValve::position, "LPS, mm.")
    .def_readonly("arc_length", &IleocecalValve::arcLength, "mm along the centerline.")
    .def_readonly("length", &IleocecalValve::length, "Greatest width, mm.")
    .def_readonly("width", &IleocecalValve::width, "Least width, mm.")
    .def_readonly("attenuation", &IleocecalValve::attenuation, "Median HU inside; NaN without a CT.")
    .def_readonly("confidence", &IleocecalValve::confidence, "0 to 1.");

  module.def(
    "find_valve",
    [](const MaskPointer & labels, const CurveSet & centerline, const std::optional<CtPointer> & ct) {
      ValveSearch search = FindIleocecalValve(labels, ct ? ct->GetPointer() : nullptr, centerline);
      return std::make_pair(search.valve, search.reason);
    },
    ReleaseGil());
}

void
AddWall(py::module_ & module)
{
  py::class_<ColonWall>(module, "ColonWall", "The wall of a colon in three forms, each open at rectum and cecum.")
    .def_readonly("raw", &ColonWall::raw, "The extracted surface, with all handles.")
    .def_readonly("repaired", &ColonWall::repaired, "The surface without handles, smoothed.")
    .def_readonly("simplified", &ColonWall::simplified, "The repaired surface with fewer faces.")
    .def_property_readonly(
      "genus_before", [](const ColonWall & wall) { return wall.report.rawGenus; }, "Number of handles of the raw wall.")
    .def_property_readonly(
      "genus_after",
      [](const ColonWall & wall) { return wall.report.repairedGenus; },
      "Number of handles of the repaired wall.")
    .def_property_readonly(
      "warnings", [](const ColonWall & wall) { return wall.report.warnings; }, "Doubtful results, one per line.");

  module.def("build_wall", Reporting(&Wall), ReleaseGil());
  module.def("build_wall_of_mask", Reporting(&WallOfMask), ReleaseGil());
}

void
AddModel(py::module_ & module)
{
  py::class_<ColonModel>(module, "ColonModel", "A colon: lumen, centerline and wall.")
    .def_readonly("lumen", &ColonModel::lumen, "ColonLumen.")
    .def_readonly("cleansed", &ColonModel::cleansed, "float32, HU; None for a mask.")
    .def_readonly("centerline", &ColonModel::centerline, "ColonCenterline; its curve includes the valve.")
    .def_property_readonly(
      "valve", [](const ColonModel & model) { return model.valve.valve; }, "IleocecalValve; None if it was not found.")
    .def_readonly("distension", &ColonModel::distension, "Distension of the whole colon.")
    .def_readonly("wall", &ColonModel::wall, "ColonWall.")
    .def_readonly("warnings", &ColonModel::warnings, "Warnings of all stages, one per line.")
    .def_readonly("failure", &ColonModel::failure, "Reason why the colon is not usable; otherwise empty.")
    .def_property_readonly(
      "statistics",
      [](const ColonModel & model) { return FromJson(ColonQualityToJson(model)); },
      "A dictionary with the keys of quality.json of ColonSegmentation.");

  module.def("build_colon", Reporting(&Model), ReleaseGil());
  module.def("build_colon_of_lumen", Reporting(&ModelOfLumen), ReleaseGil());
}
} // namespace

void
AddColonModel(py::module_ & module)
{
  AddLumen(module);
  AddCenterline(module);
  AddValve(module);
  AddWall(module);
  AddModel(module);
}
} // namespace shapeton::python
