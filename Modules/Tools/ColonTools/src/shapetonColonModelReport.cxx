#include "shapetonColonModelReport.h"

#include "shapetonColonFigures.h"
#include "shapetonColonGravity.h"
#include "shapetonColonReport.h"
#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonPlaceInWords.h"
#include "shapetonVolume.h"

#include <cmath>

namespace shapeton
{
namespace
{
using Facts = ColonReportContent::Facts;

Facts
InputFacts(const Volume & volume)
{
  const auto & size = volume.image->GetLargestPossibleRegion().GetSize();
  const auto & spacing = volume.image->GetSpacing();
  std::string  sizes;
  std::string  spacings;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const char * const between = axis == 0 ? "" : " x ";
    sizes += between + std::to_string(size[axis]);
    spacings += between + CsvTable::Rounded(spacing[axis], 4);
  }
  return KnownFacts(
    { { "Modality", volume.modality },
      { "Identity", volume.identity },
      { "Voxels", sizes },
      { "Spacing", spacings + " mm" },
      { "Slice thickness", volume.sliceThickness > 0.0 ? CsvTable::Rounded(volume.sliceThickness, 4) + " mm" : "" },
      { "Patient position in the header", volume.patientPosition } });
}

void
AddLineFacts(const ColonModel & model, Facts & facts)
{
  const ColonCenterline & line = model.centerline;
  if (line.curve.curves.empty())
  {
    return;
  }
  double bridged = 0.0;
  for (const CenterlineGap & gap : line.gaps)
  {
    bridged += gap.end - gap.begin;
  }
  facts.emplace_back("Length of the centerline", Centimeters(line.length));
  facts.emplace_back("Bridged gaps",
                     std::to_string(line.gaps.size()) + (line.gaps.empty() ? "" : ", " + Centimeters(bridged)));
  facts.emplace_back("Places where loops have merged", std::to_string(line.merges.size()));
  facts.emplace_back("Distended (caliber of at least 10 mm)", WholePercent(model.distension.share) + " of it");
}

void
AddWallFacts(const ColonWall & wall, Facts & facts)
{
  if (wall.raw.NumberOfFaces() == 0)
  {
    return;
  }
  const ColonWallReport & report = wall.report;
  facts.emplace_back("Handles of the wall",
                     std::to_string(report.rawGenus) + ", after the repair " + std::to_string(report.repairedGenus));
  facts.emplace_back("Changed by the repair",
                     Milliliters(report.topology.cutVolume) + " cut, " + Milliliters(report.topology.cavityVolume) +
                       " of cavities filled");
  facts.emplace_back("Wall",
                     std::to_string(report.rawFaces) + " faces, simplified to " +
                       std::to_string(report.simplifiedFaces) + " faces");
  facts.emplace_back("Synthetic faces", std::to_string(report.bridgedFaces));
}

std::string
CatheterInWords(const RectalCatheter & catheter)
{
  const std::string balloon =
    catheter.balloonDiameter > 0.0 ? ", with a balloon of " + WholeMillimeters(catheter.balloonDiameter) : "";
  return (catheter.isSure ? "filled in, " : "doubtful, ") + InTenths(catheter.outerDiameter) + " mm wide" + balloon +
         ", " + WholeMillimeters(catheter.evidence.length) + " from " + PlaceInWords(catheter.axis.front()) + " to " +
         PlaceInWords(catheter.axis.back());
}

void
AddValveFacts(const ColonModel & model, Facts & facts)
{
  if (model.centerline.curve.curves.empty())
  {
    return;
  }
  const std::optional<IleocecalValve> & valve = model.valve.valve;
  facts.emplace_back("Ileocecal valve",
                     valve ? "at " + PlaceInWords(valve->position) + ", " + Centimeters(valve->arcLength) +
                               " from the anal verge, confidence " + ProbabilityInWords(valve->confidence)
                           : "not found: " + model.valve.reason);
  if (model.terminalIleum)
  {
    facts.emplace_back("Terminal ileum, cut off", Milliliters(model.terminalIleum->volume));
  }
}

Facts
SummaryFacts(const ColonModel & model)
{
  double gas = 0.0;
  double fluid = 0.0;
  for (const LumenPiece & piece : model.lumen.pieces)
  {
    gas += piece.gasMl;
    fluid += piece.fluidMl;
  }
  Facts facts =
    KnownFacts({ { "Result", model.failure.empty() ? "" : "partial: " + model.failure },
                 { "Resolution", InWords(model.resolution) },
                 { model.hasIntensities ? "Gas" : "Lumen", Milliliters(gas) },
                 { "Tagged fluid", model.hasIntensities ? Milliliters(fluid) : "" },
                 { "Pieces of the lumen", std::to_string(model.lumen.pieces.size()) },
                 { "Rectal catheter", model.lumen.catheter ? CatheterInWords(*model.lumen.catheter) : "" } });
  AddLineFacts(model, facts);
  AddValveFacts(model, facts);
  AddWallFacts(model.wall, facts);
  return facts;
}

Facts
ParameterFacts(const ColonLumen & lumen)
{
  const ColonThresholds & thresholds = lumen.thresholds;
  constexpr int           digits = 5;
  const auto              hu = [](double value) { return CsvTable::Rounded(std::round(value), digits) + " HU"; };
  return KnownFacts(
    { { "Position of the patient",
        NameOfGravity(lumen.gravity) + (lumen.gravitySource == ColonGravitySource::PatientPosition ? ", as given"
                                        : lumen.gravitySource == ColonGravitySource::Levels ? ", from the fluid levels"
                                                                                            : ", assumed") },
      { "Noise", hu(lumen.noise) },
      { "Gas, soft tissue", hu(thresholds.gas) + ", " + hu(thresholds.tissue) },
      { "Wall under gas at", hu(thresholds.gasBoundary) },
      { "Tagged fluid, its boundary",
        lumen.isTagged ? hu(thresholds.fluid) + ", " + hu(thresholds.fluidBoundary) : "" },
      { "Smoothed against noise", lumen.smoothing > 0.0 ? CsvTable::Rounded(lumen.smoothing, 3) + " mm" : "" } });
}

Facts
LeftOutFacts(const ColonLumen & lumen)
{
  constexpr std::size_t most = 12;
  Facts                 facts;
  for (std::size_t i = 0; i < std::min(most, lumen.leftOut.size()); ++i)
  {
    const ColonLeftOut & one = lumen.leftOut[i];
    facts.emplace_back("Left out: " + one.what, Milliliters(one.ml) + ", " + one.why);
  }
  return facts;
}
} // namespace

void
WriteColonModelReport(CommandLine &       commandLine,
                      const std::string & folder,
                      const ColonModel &  model,
                      const Volume &      volume,
                      bool                atOnce)
{
  if (folder.empty() || model.lumen.pieces.empty())
  {
    return;
  }
  ColonReportContent content;
  content.colon.ct = model.hasIntensities ? volume.image.GetPointer() : nullptr;
  content.colon.lumen = model.lumen.labels;
  content.colon.centerline = model.centerline.curve.curves.empty() ? nullptr : &model.centerline.curve;
  content.colon.wall = model.wall.simplified.NumberOfFaces() > 0 ? &model.wall.simplified : nullptr;
  content.input = InputFacts(volume);
  content.summary = SummaryFacts(model);
  content.parameters = model.hasIntensities ? ParameterFacts(model.lumen) : Facts{ { "Lumen", "a mask, as given" } };
  const Facts leftOut = LeftOutFacts(model.lumen);
  content.parameters.insert(content.parameters.end(), leftOut.begin(), leftOut.end());
  content.warnings = commandLine.GetWarnings();
  content.provenance = commandLine.GetProvenance();
  std::vector<std::string> written;
  WriteColonReport(content, folder, [&](const std::string & path) {
    written.push_back(path);
    return commandLine.Output(path);
  });
  for (std::size_t i = 0; atOnce && i < written.size(); ++i)
  {
    commandLine.Publish(written[i]);
  }
}
} // namespace shapeton
