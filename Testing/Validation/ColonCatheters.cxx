// Detection of the rectal catheter, with false positives.
#include "BoundTable.h"
#include "LandmarkErrors.h"
#include "SampledScenes.h"

#include "shapetonColonLumenSegmentation.h"
#include "shapetonColonPhantomImageSource.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

using namespace shapeton;

namespace
{
using Source = ColonPhantomImageSource;

constexpr int    patientsWith = 20;
constexpr int    patientsWithout = 50;
constexpr double spacing = 0.8; // mm
constexpr double leastFound = 0.95;

/** Grid of the rectum: 200 mm wide, from 15 mm below the anal verge to 185 mm above it. */
Source::Pointer
MakeRectum(const ColonPhantomParameters & parameters)
{
  constexpr double extent = 200.0, below = 15.0; // mm
  const auto       source = Source::New();
  source->SetParameters(parameters);
  Eigen::Vector3d verge, inwards;
  source->GetAnatomy().AnalVerge(verge, inwards);
  Source::SizeType size;
  size.Fill(static_cast<itk::SizeValueType>(std::lround(extent / spacing)));
  source->SetSize(size);
  source->SetSpacing(Source::SpacingType(spacing));
  const double origin[3] = { verge.x() - 0.5 * extent, verge.y() - 0.5 * extent, verge.z() - below };
  source->SetOrigin(origin);
  source->Update();
  return source;
}

/** Exam of a rectum. */
struct CatheterTrial
{
  std::string name;
  bool        isThere{ false };
  std::string kind; ///< catheter kind with its balloon
  bool        isFound{ false };
  double      confidence{ 0.0 };
  double      distance{ 0.0 };     ///< mean distance from the detected axis to the true one (mm)
  double      boreError{ 0.0 };    ///< mm
  double      outerError{ 0.0 };   ///< mm
  bool        hasBalloon{ false }; ///< filled with gas or fluid
  bool        seesBalloon{ false };
  double      balloonError{ 0.0 };    ///< error of the balloon diameter (mm)
  double      balloonDistance{ 0.0 }; ///< error of the balloon center (mm)
};

std::vector<Eigen::Vector3d>
TrueAxis(const ColonStructures & structures)
{
  const CurveSet               axes = structures.Axes();
  const SurfaceArray *         of = FindSurfaceArray(axes.cellArrays, "structure");
  std::vector<Eigen::Vector3d> axis;
  for (std::size_t c = 0; c < axes.curves.size(); ++c)
  {
    if (static_cast<int>(of->values(static_cast<Eigen::Index>(c), 0)) == static_cast<int>(ColonStructure::Catheter))
    {
      for (const int vertex : axes.curves[c])
      {
        axis.emplace_back(axes.V.row(vertex));
      }
    }
  }
  return axis;
}

double
MeanDistance(const RectalCatheter & catheter, const ColonStructures & structures)
{
  const std::vector<Eigen::Vector3d> truth = TrueAxis(structures);
  double                             sum = 0.0;
  for (const auto & point : catheter.axis)
  {
    sum += DistanceToLine(Eigen::Vector3d(point.GetDataPointer()), truth);
  }
  return sum / static_cast<double>(catheter.axis.size());
}

CatheterTrial
TryExam(const ColonPhantomParameters & parameters)
{
  const auto         source = MakeRectum(parameters);
  ColonLumenSettings options;
  options.position = parameters.position;
  const ColonLumen lumen = SegmentColonLumen(ToFloat(source->GetOutput()), options);

  CatheterTrial               trial;
  const ColonCatheter * const truth = source->GetStructures().GetCatheter();
  trial.name = "seed " + std::to_string(parameters.seed) + ", " + parameters.position;
  ValidationReport::Progress("colon-catheters: " + trial.name + (truth ? " with" : " without"));
  trial.isThere = truth != nullptr;
  trial.isFound = lumen.catheter && lumen.catheter->isSure;
  trial.confidence = lumen.catheter ? lumen.catheter->evidence.confidence : 0.0;
  if (truth)
  {
    trial.kind = truth->kind + ", balloon " + truth->balloon;
    trial.hasBalloon = truth->balloon == "gas" || truth->balloon == "fluid";
  }
  if (truth && trial.isFound)
  {
    trial.distance = MeanDistance(*lumen.catheter, source->GetStructures());
    trial.boreError = lumen.catheter->boreDiameter - truth->bore;
    trial.outerError = lumen.catheter->outerDiameter - truth->bore - 2.0 * truth->wall;
    trial.seesBalloon = lumen.catheter->balloonDiameter > 0.0;
    trial.balloonError = lumen.catheter->balloonDiameter - truth->balloonDiameter;
    trial.balloonDistance =
      (Eigen::Vector3d(lumen.catheter->balloonCenter.GetDataPointer()) - truth->balloonCenter).norm();
  }
  return trial;
}

/** Both positions of some patients. */
std::vector<CatheterTrial>
TryPatients(const std::vector<unsigned int> & seeds, bool hasCatheter)
{
  std::vector<CatheterTrial> trials;
  for (const unsigned int seed : seeds)
  {
    for (const char * const position : { "supine", "prone" })
    {
      ColonPhantomParameters parameters = ColonPhantomPreset("realistic");
      parameters.seed = seed;
      parameters.position = position;
      parameters.catheter = !hasCatheter ? "none" : seed % 2 == 0 ? "rigid" : "soft";
      trials.push_back(TryExam(parameters));
    }
  }
  return trials;
}

int
NumberFound(const std::vector<CatheterTrial> & trials)
{
  return static_cast<int>(
    std::count_if(trials.begin(), trials.end(), [](const CatheterTrial & trial) { return trial.isFound; }));
}

bool
FindsBalloon(const CatheterTrial & trial)
{
  return trial.hasBalloon && trial.seesBalloon;
}

template <typename TCondition, typename TMeasure>
std::vector<double>
ValuesOf(const std::vector<CatheterTrial> & trials, TCondition isMeant, TMeasure measure)
{
  std::vector<double> values;
  for (const CatheterTrial & trial : trials)
  {
    if (isMeant(trial))
    {
      values.push_back(measure(trial));
    }
  }
  return values;
}

void
WriteSummary(const std::vector<CatheterTrial> & with,
             const std::vector<CatheterTrial> & without,
             ValidationReport &                 report)
{
  BoundTable table(report, true);
  const int  found = NumberFound(with);
  const auto all = static_cast<int>(with.size());
  table.AddShare("catheters found", AtLeast(leastFound), found, all);
  table.AddBounded("catheters found in exams without one",
                   "0",
                   RatioOf(NumberFound(without), static_cast<int>(without.size())),
                   {},
                   !without.empty() && NumberFound(without) == 0);
  const auto add = [&](const std::string & what, const auto & isMeant, const auto & measure) {
    const std::vector<double> values = ValuesOf(with, isMeant, measure);
    table.AddMean(what, values);
  };
  const auto isFound = [](const CatheterTrial & t) { return t.isFound; };
  add("distance to the true axis, mean, mm", isFound, [](const CatheterTrial & t) { return t.distance; });
  add("bore minus true bore, mean, mm", isFound, [](const CatheterTrial & t) { return t.boreError; });
  add("outer diameter minus true outer diameter, mean, mm", isFound, [](const CatheterTrial & t) {
    return t.outerError;
  });
  int balloons = 0, seen = 0, imagined = 0;
  for (const CatheterTrial & trial : with)
  {
    balloons += trial.hasBalloon;
    seen += FindsBalloon(trial);
    imagined += !trial.hasBalloon && trial.seesBalloon;
  }
  table.AddFact("filled balloons found", RatioOf(seen, balloons));
  table.AddFact("balloons found where none is filled", std::to_string(imagined));
  add("balloon diameter minus true diameter, mean, mm", FindsBalloon, [](const CatheterTrial & t) {
    return t.balloonError;
  });
  add("distance to the true balloon center, mean, mm", FindsBalloon, [](const CatheterTrial & t) {
    return t.balloonDistance;
  });
  table.Write("measures");
}

void
WriteExams(const std::vector<CatheterTrial> & trials, ValidationReport & report)
{
  CsvTable table(
    Columns("exam | catheter | found | confidence | axis, mm | bore, mm | outer, mm | balloon found | balloon, mm"));
  for (const CatheterTrial & t : trials)
  {
    const bool isRight = t.isThere && t.isFound;
    table.AddRow(Cells() << t.name << (t.isThere ? t.kind : "none") << (t.isFound ? "yes" : "") << Rounded(t.confidence)
                         << (isRight ? Rounded(t.distance) : "") << (isRight ? Rounded(t.boreError) : "")
                         << (isRight ? Rounded(t.outerError) : "") << (t.seesBalloon ? "yes" : "")
                         << (FindsBalloon(t) ? Rounded(t.balloonError) : ""));
  }
  report.AddRows("exams", table);
}
} // namespace

void
ValidateColonCatheters(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("Synthetic patients of the preset realistic (" + settings.SeedsInWords() +
                 "), supine and prone: CT of the rectum in voxels of 0.8 mm, with a catheter (rigid for even seeds, "
                 "soft for odd ones) and without.");
  std::vector<unsigned int> seedsWithout = settings.Seeds(patientsWith, "realistic");
  seedsWithout.resize(settings.patients > 0 ? settings.patients : patientsWithout);
  std::iota(seedsWithout.begin(), seedsWithout.end(), seedsWithout.front());
  std::vector<CatheterTrial>       listed = TryPatients(settings.Seeds(patientsWith, "realistic"), true);
  const std::vector<CatheterTrial> without = TryPatients(seedsWithout, false);
  WriteSummary(listed, without, report);
  std::copy_if(without.begin(), without.end(), std::back_inserter(listed), [](const CatheterTrial & trial) {
    return trial.confidence > 0.0;
  });
  report.AddText("`exams` lists the exams with a catheter, and exams without one but with a confidence above 0.");
  WriteExams(listed, report);
}
