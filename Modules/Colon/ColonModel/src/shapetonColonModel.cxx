#include "shapetonColonModel.h"

#include "shapetonColonAssessability.h"
#include "shapetonDicomFields.h"
#include "shapetonElectronicCleansing.h"
#include "shapetonGasInGaps.h"
#include "shapetonMaskedColonLumen.h"
#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"
#include "shapetonPlaceInWords.h"

#include "itkRegionOfInterestImageFilter.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace shapeton
{
namespace
{
/** Approximate fraction of the run time completed after each stage. */
constexpr double SegmentationEnd = 0.35;
constexpr double CenterlineEnd = 0.65;

ColonLumenSettings
LumenSettingsOf(const ColonModelSettings & options)
{
  return { static_cast<const ColonLumenOptions &>(options),
           options.progress.Part("Finding gas and fluid", 0.0, SegmentationEnd) };
}

/** Warns where the scan border cuts the colon. */
void
JudgeCuts(ColonCenterline & line)
{
  for (const HinderedStretch & stretch : CutsByScan(line.curve))
  {
    bool isOutside = false;
    for (CenterlineGap & gap : line.gaps)
    {
      const bool isIn = gap.begin < stretch.end && gap.end > stretch.begin;
      gap.isDoubtful = gap.isDoubtful || isIn;
      isOutside = isOutside || isIn;
    }
    line.warnings.push_back("the border of the scan cuts the colon from " + std::to_string(std::lround(stretch.begin)) +
                            " to " + std::to_string(std::lround(stretch.end)) + " mm along the centerline: " +
                            (isOutside ? "a part is outside the scan, and the parts on both sides of the gap may be "
                                         "in the wrong order"
                                       : "the rest is outside the scan"));
  }
}

void
TraceLine(ColonModel & model, const ColonModelSettings & options)
{
  ColonCenterlineSettings line;
  line.seedPoint = options.seedPoint;
  line.progress = options.progress.Part("Tracing the centerline", SegmentationEnd, CenterlineEnd);
  model.centerline = TraceColonCenterline(model.lumen.labels, line);
  MarkHindrances(model.lumen, model.centerline.curve);
  JudgeCuts(model.centerline);
  model.distension = MeasureDistension(model.centerline.curve);
}

void
FindValve(ColonModel & model)
{
  model.valve = FindIleocecalValve(model.lumen.labels, model.cleansed, model.centerline.curve);
  SetIleocecalValve(model.valve, model.centerline.curve);
}

/** Removes the ileum from the lumen, and finds the line and the valve again. */
void
RemoveIleum(ColonModel & model, const ColonModelSettings & options)
{
  TakeOut(*model.terminalIleum, model.lumen.labels.GetPointer());
  TraceLine(model, options);
  FindValve(model);
}

/** Finds the valve; if there is ileum in the lumen, removes it and recomputes the line and the valve. */
void
AddValve(ColonModel & model, const ColonModelSettings & options)
{
  model.terminalIleum = FindRefluxedIleum(model.lumen.labels, model.centerline.curve);
  if (!model.terminalIleum)
  {
    model.terminalIleum = FindIleumBehindValve(model.lumen.labels, model.cleansed, model.centerline.curve);
  }
  if (model.terminalIleum)
  {
    RemoveIleum(model, options);
  }
  else
  {
    FindValve(model);
    if (model.valve.valve)
    {
      model.terminalIleum = FindTerminalIleum(model.lumen.labels, model.centerline.curve, *model.valve.valve);
    }
    if (model.terminalIleum)
    {
      RemoveIleum(model, options);
    }
  }
  AppendRemarks(model.warnings, model.centerline.warnings);
}

ColonWallSettings
WallSettingsOf(const ColonModelSettings & options)
{
  return { static_cast<const ColonWallOptions &>(options),
           {},
           options.facts,
           options.progress.Part("Making the wall", CenterlineEnd, 1.0),
           options.besideSimplification };
}

/** Runs a task and waits for the parallel one, even after an InputError; if both fail, the error of the parallel one is
 * thrown. */
template <typename TWork>
void
DoAndWaitFor(WorkBeside & beside, const TWork & work)
{
  try
  {
    work();
  }
  catch (const InputError &)
  {
    beside.Get();
    throw;
  }
  beside.Get();
}

template <typename TMake>
void
AddWall(ColonModel & model, const ColonModelSettings & options, const TMake & make)
{
  WorkBeside beside;
  if (options.besideWall)
  {
    beside = StartBeside([&] { options.besideWall(model); });
  }
  ColonWall wall;
  DoAndWaitFor(beside, [&] { wall = make(WallSettingsOf(options)); });
  model.wall = std::move(wall);
  AppendRemarks(model.warnings, model.wall.report.warnings);
}

/** The cleansed colon, and the parallel task that uses the cleansed CT. */
struct CleansedWork
{
  CleansedColon colon;
  WorkBeside    beside;

  void
  Start(const ColonModelSettings & options)
  {
    if (options.onCleansed)
    {
      beside = StartBeside([work = options.onCleansed, ct = colon.ct] { work(ct); });
    }
  }
};

void
TraceAndCleanse(ColonModel &                 model,
                CleansedWork &               cleansed,
                const itk::Image<float, 3> * ct,
                const ColonModelSettings &   options)
{
  ParallelInvoke([&] { TraceLine(model, options); }, // does not require the CT
                 [&] {
                   cleansed.colon = CleanseColon(ct, model.lumen);
                   model.cleansed = cleansed.colon.ct;
                   cleansed.Start(options);
                 });
}

std::string
InWords(const GasInGap & one)
{
  const auto rounded = [](double value) { return std::to_string(std::lround(value)); };
  return rounded(one.gas.ml) + " ml of gas around " + PlaceInWords(one.gas.center) +
         ", as narrow as small bowel, connect the ends of a gap of " + rounded(one.gap.distance) +
         " mm in the centerline, from " + PlaceInWords(one.gap.from) + " to " + PlaceInWords(one.gap.to) +
         ": classified as colon; check it, or give the lumen as a mask";
}

/** Adds seed points in gas that fills gaps of the line, and recomputes the model. The result is used, and the seed
 * points are added to `options`, if the gaps are shortened by at least half of the filled length. */
void
FillGaps(ColonModel & model, CleansedWork & cleansed, const itk::Image<float, 3> * ct, ColonModelSettings & options)
{
  const std::vector<GasInGap> found = FindGasInGaps(model.lumen, model.centerline);
  if (found.empty())
  {
    return;
  }
  ColonModelSettings with = options;
  with.onCleansed = {}; // the result may be discarded
  with.progress = options.progress.Part("Filling gaps of the colon", CenterlineEnd, CenterlineEnd);
  double most = LengthOfGaps(model.centerline);
  for (const GasInGap & one : found)
  {
    with.seedPoint.push_back(one.gas.places[one.gas.places.size() / 2]);
    most -= 0.5 * one.gap.distance;
  }
  ColonModel filled;
  filled.lumen = SegmentColonLumen(ct, LumenSettingsOf(with));
  if (!filled.lumen.failure.empty())
  {
    return;
  }
  CleansedWork again;
  TraceAndCleanse(filled, again, ct, with);
  if (LengthOfGaps(filled.centerline) <= most)
  {
    cleansed.beside.Get(); // uses the CT of the previous line
    model = std::move(filled);
    cleansed = std::move(again);
    cleansed.Start(options);
    options.seedPoint = with.seedPoint;
    model.warnings = model.lumen.warnings;
    for (const GasInGap & one : found)
    {
      model.warnings.push_back(InWords(one));
    }
  }
}

enum class LumenOrigin
{
  Data, ///< found in a CT
  Mask  ///< given
};

/** Whether the scan border cuts the colon anywhere. */
bool
IsCutByScan(const CurveSet & line)
{
  const auto stretches = FindHinderedStretches(line);
  return std::any_of(stretches.begin(), stretches.end(), [](const HinderedStretch & stretch) {
    return stretch.hindrance == ColonHindrance::CutByScan;
  });
}

/** Reason why the lumen is not a colon but a stomach or a loop of bowel: it is completely inside the scan and shorter
 * than any colon. Empty otherwise. */
std::string
FailureOfShortLine(const ColonModel & model)
{
  // An adult colon is 1000 to 2500 mm long, or at least 600 mm after a hemicolectomy; a stomach is 200 to 300 mm long.
  constexpr double shortestColon = 400.0; // mm
  if (model.centerline.length >= shortestColon || IsCutByScan(model.centerline.curve))
  {
    return {};
  }
  const auto rounded = [](double value) { return std::to_string(std::lround(value)); };
  const auto largest = model.lumen.pieces.front();
  return "no distended colon found: the only wide gas is " + rounded(largest.gasMl) + " ml around " +
         PlaceInWords(largest.center) + " along " + rounded(model.centerline.length) +
         " mm, shorter than a colon: a stomach or a loop of bowel; if it is a colon, give a seed point in it, or "
         "its lumen as a mask";
}

/** Whether to continue, because the line is a colon or partial results are requested. */
bool
MayGoOn(ColonModel & model, const ColonModelSettings & options, LumenOrigin origin)
{
  if (model.failure.empty())
  {
    model.failure = model.centerline.failure;
  }
  if (model.failure.empty() && origin == LumenOrigin::Data && options.seedPoint.empty())
  {
    model.failure = FailureOfShortLine(model);
  }
  return model.failure.empty() || options.keepPartial;
}

/** Computes the cleansed CT, the centerline and the wall for a lumen from the CT or from a mask. */
void
Complete(ColonModel & model, const itk::Image<float, 3> * ct, ColonModelSettings options, LumenOrigin origin)
{
  CleansedWork cleansed;
  DoAndWaitFor(cleansed.beside, [&] {
    TraceAndCleanse(model, cleansed, ct, options);
    if (!MayGoOn(model, options, origin))
    {
      return;
    }
    if (model.failure.empty() && origin == LumenOrigin::Data)
    {
      FillGaps(model, cleansed, ct, options);
    }
    AddValve(model, options);
    if (model.terminalIleum)
    {
      TakeOut(*model.terminalIleum, cleansed.colon.occupancy.GetPointer());
    }
    AddWall(model, options, [&](const ColonWallSettings & wall) {
      return BuildColonWall(std::move(cleansed.colon.occupancy), model.centerline.curve, wall);
    });
  });
}

ColonModel
ModelOf(const itk::Image<float, 3> * ct, ColonLumen && lumen, const ColonModelSettings & options, LumenOrigin origin)
{
  ColonModel model;
  model.lumen = std::move(lumen);
  model.warnings = model.lumen.warnings;
  model.failure = model.lumen.failure;
  if (!model.failure.empty() && (!options.keepPartial || model.lumen.pieces.empty()))
  {
    return model;
  }
  try
  {
    Complete(model, ct, options, origin);
  }
  catch (const InputError & error)
  {
    if (model.failure.empty())
    {
      throw;
    }
    model.warnings.push_back(error.what());
  }
  return model;
}

LumenMask::Pointer
Cropped(const LumenMask * lumen)
{
  constexpr unsigned int margin = 3; // voxels around the lumen
  const auto             filter = itk::RegionOfInterestImageFilter<LumenMask, LumenMask>::New();
  filter->SetInput(lumen);
  filter->SetRegionOfInterest(LumenRegion(lumen, margin));
  filter->Update();
  return filter->GetOutput();
}

ColonModel
ModelOfMask(const LumenMask * lumen, const ColonModelSettings & options)
{
  ColonModel model;
  model.hasIntensities = false;
  model.lumen = ColonLumenOfMask(lumen);
  TraceLine(model, options);
  if (!MayGoOn(model, options, LumenOrigin::Mask))
  {
    return model;
  }
  AddValve(model, options);
  AddWall(model, options, [&](const ColonWallSettings & wall) {
    return BuildColonWallFromMask(Cropped(model.lumen.labels), model.centerline.curve, wall);
  });
  return model;
}

/** The given slice thickness, or that among the DICOM fields of the image; 0 if unknown. */
double
SliceThicknessOf(const itk::Object * image, double given)
{
  std::istringstream field(DicomField(image, DicomSliceThickness));
  field.imbue(std::locale::classic());
  double thickness = 0.0;
  field >> thickness;
  return given > 0.0 ? given : thickness;
}

/** Adds the resolution and its warnings. */
ColonModel
WithResolution(ColonModel && model, const itk::ImageBase<3> * image, double sliceThickness)
{
  model.resolution = MeasureScanResolution(image, SliceThicknessOf(image, sliceThickness), model.lumen.smoothing);
  model.resolution.isOfMask = !model.hasIntensities;
  SetNotAssessableBelow(model.resolution, model.centerline.curve);
  AppendRemarks(model.warnings, WarningsOf(model.resolution));
  return std::move(model);
}

/** Radius (mm) of the cross-section of a ball at a point; 0 outside the ball. */
double
RadiusOfSection(const itk::Point<double, 3> & center, double diameter, const itk::Point<double, 3> & point)
{
  return std::sqrt(std::max(0.0, 0.25 * diameter * diameter - center.SquaredEuclideanDistanceTo(point)));
}
} // namespace

ColonModel
BuildColonModel(const itk::Image<float, 3> * ct, const ColonModelSettings & options)
{
  return WithResolution(ModelOf(ct, SegmentColonLumen(ct, LumenSettingsOf(options)), options, LumenOrigin::Data),
                        ct,
                        options.sliceThickness);
}

ColonModel
BuildColonModel(const itk::Image<float, 3> * ct, const LumenMask * lumen, const ColonModelSettings & options)
{
  return WithResolution(ModelOf(ct, ColonLumenOfMask(ct, lumen, LumenSettingsOf(options)), options, LumenOrigin::Mask),
                        ct,
                        options.sliceThickness);
}

ColonModel
BuildColonModelOfLumen(const LumenMask * lumen, const ColonModelSettings & options)
{
  return WithResolution(ModelOfMask(lumen, options), lumen, options.sliceThickness);
}

std::vector<HinderedStretch>
CutsByScan(const CurveSet & line)
{
  constexpr double             leastLength = 10.0; // mm; chosen, see the header
  std::vector<HinderedStretch> cuts;
  for (const HinderedStretch & stretch : FindHinderedStretches(line))
  {
    if (stretch.hindrance == ColonHindrance::CutByScan && stretch.end - stretch.begin >= leastLength)
    {
      cuts.push_back(stretch);
    }
  }
  return cuts;
}

CurveSet
CurveOfCatheter(const RectalCatheter & catheter)
{
  const auto      number = static_cast<int>(catheter.axis.size());
  Eigen::VectorXd radius = Eigen::VectorXd::Constant(number, 0.5 * catheter.outerDiameter);
  Eigen::VectorXd balloon(number);
  CurveSet        curve;
  curve.V.resize(number, 3);
  curve.curves.emplace_back();
  for (int n = 0; n < number; ++n)
  {
    curve.V.row(n) << catheter.axis[n][0], catheter.axis[n][1], catheter.axis[n][2];
    curve.curves.back().push_back(n);
    balloon[n] = RadiusOfSection(catheter.balloonCenter, catheter.balloonDiameter, catheter.axis[n]);
    if (n >= catheter.evidence.length)
    {
      radius[n] = std::max(radius[n], catheter.tipRadius);
    }
  }
  curve.pointArrays = { { "radius", radius }, { "balloonRadius", balloon } };
  return curve;
}
} // namespace shapeton
