#include "shapetonColonQuality.h"

#include "shapetonColonAssessability.h"
#include "shapetonColonExtent.h"
#include "shapetonColonGravity.h"
#include "shapetonJson.h"
#include "shapetonPlaceInWords.h"
#include "shapetonSurfaceQuality.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
Json
Triple(const itk::Point<double, 3> & point)
{
  return { point[0], point[1], point[2] };
}

std::string
NameOf(ColonGravitySource source)
{
  switch (source)
  {
    case ColonGravitySource::PatientPosition:
      return "patientPosition";
    case ColonGravitySource::Levels:
      return "levels";
    case ColonGravitySource::Assumed:
      return "assumed";
  }
  return {};
}

Json
IntensitiesToJson(const ColonLumen & lumen)
{
  const ColonThresholds & thresholds = lumen.thresholds;
  Json                    json;
  json["position"] = NameOfGravity(lumen.gravity);
  json["gravity"] = { lumen.gravity[0], lumen.gravity[1], lumen.gravity[2] };
  json["gravitySource"] = NameOf(lumen.gravitySource);
  json["noiseHU"] = lumen.noise;
  json["smoothing"] = lumen.smoothing;
  json["isTagged"] = lumen.isTagged;
  json["thresholdsHU"] = { { "gas", thresholds.gas },
                           { "tissue", thresholds.tissue },
                           { "gasSeed", thresholds.gasSeed },
                           { "gasBoundary", thresholds.gasBoundary },
                           { "fluid", thresholds.fluid },
                           { "fluidSeed", thresholds.fluidSeed },
                           { "fluidBoundary", thresholds.fluidBoundary } };
  json["levels"] = Json::array();
  for (const ColonLevel & level : lumen.levels)
  {
    json["levels"].push_back({ { "center", Triple(level.center) },
                               { "area", level.area },
                               { "tilt", level.tilt },
                               { "fluidHU", level.fluidHU },
                               { "isTagged", level.isTagged },
                               { "isColon", level.isColon } });
  }
  json["leftOut"] = Json::array();
  for (const ColonLeftOut & one : lumen.leftOut)
  {
    json["leftOut"].push_back({ { "what", one.what },
                                { "why", one.why },
                                { "volume", one.ml },
                                { "inscribedRadius", one.inscribedRadius },
                                { "meanHU", one.meanHU },
                                { "center", Triple(one.center) } });
  }
  return json;
}

Json
CatheterToJson(const RectalCatheter & catheter)
{
  const CatheterEvidence & evidence = catheter.evidence;
  return { { "found", catheter.isSure },
           { "from", Triple(catheter.axis.front()) },
           { "to", Triple(catheter.axis.back()) },
           { "length", evidence.length },
           { "boreDiameter", catheter.boreDiameter },
           { "outerDiameter", catheter.outerDiameter },
           { "balloonDiameter", catheter.balloonDiameter },
           { "wallHU", catheter.wallHU },
           { "filledVolume", catheter.filledMl },
           { "confidence", evidence.confidence },
           { "evidence",
             { { "enclosedLength", evidence.enclosedLength },
               { "enclosedShare", evidence.enclosedShare },
               { "boreSpread", evidence.boreSpread },
               { "ovality", evidence.ovality } } } };
}

Json
LumenToJson(const ColonModel & model)
{
  Json json = model.hasIntensities ? IntensitiesToJson(model.lumen) : Json::object();
  if (model.lumen.catheter)
  {
    json["catheter"] = CatheterToJson(*model.lumen.catheter);
  }
  double gas = 0.0;
  double fluid = 0.0;
  Json   pieces = Json::array();
  for (const LumenPiece & piece : model.lumen.pieces)
  {
    gas += piece.gasMl;
    fluid += piece.fluidMl;
    pieces.push_back({ { "gasVolume", piece.gasMl },
                       { "fluidVolume", piece.fluidMl },
                       { "inscribedRadius", piece.inscribedRadius },
                       { "center", Triple(piece.center) } });
  }
  json["gasVolume"] = gas;
  json["fluidVolume"] = fluid;
  json["pieces"] = pieces;
  return json;
}

Json
IleumToJson(const std::optional<TerminalIleum> & ileum)
{
  if (!ileum)
  {
    return { { "found", false }, { "reason", "no part of the lumen extends beyond a detected valve" } };
  }
  return { { "found", true },
           { "mouth", { ileum->mouth[0], ileum->mouth[1], ileum->mouth[2] } },
           { "length", ileum->length },
           { "volume", ileum->volume } };
}

Json
GapsToJson(const ColonCenterline & centerline)
{
  Json gaps = Json::array();
  for (const CenterlineGap & gap : centerline.gaps)
  {
    gaps.push_back({ { "begin", gap.begin },
                     { "end", gap.end },
                     { "from", Triple(gap.from) },
                     { "to", Triple(gap.to) },
                     { "isDoubtful", gap.isDoubtful } });
  }
  return gaps;
}

Json
CenterlineToJson(const ColonCenterline & centerline)
{
  Json json;
  json["length"] = centerline.length;
  json["lengthByExponent"] = { { "2", centerline.lengths[0] },
                               { "3", centerline.lengths[1] },
                               { "4", centerline.lengths[2] } };
  json["coverage"] = centerline.coverage;
  json["gaps"] = GapsToJson(centerline);
  json["pieces"] = Json::array();
  for (const CenterlinePiece & piece : centerline.pieces)
  {
    Json one = { { "volume", piece.volume }, { "isUsed", piece.isUsed }, { "place", Triple(piece.place) } };
    if (piece.isUsed)
    {
      one["begin"] = piece.begin;
      one["end"] = piece.end;
    }
    else
    {
      one["reason"] = piece.reason;
    }
    json["pieces"].push_back(one);
  }
  json["merges"] = Json::array();
  for (const CenterlineMerge & merge : centerline.merges)
  {
    json["merges"].push_back(
      { { "place", Triple(merge.place) }, { "clearance", merge.clearance }, { "loop", merge.loop } });
  }
  return json;
}

Json
DistensionToJson(const ColonDistension & distension)
{
  Json json;
  json["note"] = "share: fraction of the centerline with a caliber of at least 10 mm";
  json["whole"] = { { "begin", distension.begin },
                    { "end", distension.end },
                    { "share", distension.share },
                    { "meanCaliber", distension.meanCaliber },
                    { "collapsedLength", distension.collapsedLength } };
  return json;
}

Json
AssessabilityToJson(const ColonModel & model)
{
  const std::vector<HinderedStretch> stretches = FindHinderedStretches(model.centerline.curve);
  Json                               json;
  json["note"] = "where the wall is visible: a lumen of gas or tagged fluid with a caliber of at least 10 mm, no "
                 "untagged fluid, within the scan";
  json["tagging"] = !model.hasIntensities ? "unknown: a mask" : model.lumen.isTagged ? "tagged" : "no tagged fluid";
  json["whole"] = AssessabilityToJson(Assess(stretches, 0.0, model.centerline.length));
  json["stretches"] = StretchesToJson(stretches);
  return json;
}

/** Whether the line begins near the anus: caudal, medial and posterior in its bounding box. */
bool
BeginsInRectum(const CurveSet & curve)
{
  // The lines of four real colons begin at distances of 10 to 50 mm; a line from the descending colon would begin at
  // about 80 mm.
  constexpr double farthest = 65.0; // mm, see ColonExtent::DistanceFromAnus()
  ColonExtent      extent;
  for (Eigen::Index n = 0; n < curve.V.rows(); ++n)
  {
    extent.Include(Eigen::Vector3d(curve.V.row(n)));
  }
  const Eigen::Vector3d begin = curve.V.row(curve.curves.front().front());
  return extent.DistanceFromAnus(begin) <= farthest;
}

/** "from 42.9 to 43.2 cm". */
std::string
InCentimeters(double begin, double end)
{
  constexpr double mmPerCm = 10.0;
  return "from " + InTenths(begin / mmPerCm) + " to " + InTenths(end / mmPerCm) + " cm";
}

/** Parts that the line would need to be complete from the rectum to the cecum. */
std::vector<std::string>
MissingParts(const ColonModel & model)
{
  if (!model.failure.empty() || model.centerline.curve.curves.empty())
  {
    return { "a usable colon" };
  }
  std::vector<std::string> missing;
  if (!BeginsInRectum(model.centerline.curve))
  {
    missing.push_back("the rectum: the line does not begin there");
  }
  for (const HinderedStretch & cut : CutsByScan(model.centerline.curve))
  {
    missing.push_back("the part outside the scan, whose border cuts the colon " + InCentimeters(cut.begin, cut.end) +
                      " along the line");
  }
  for (const CenterlineGap & gap : model.centerline.gaps)
  {
    if (gap.isDoubtful)
    {
      missing.push_back("the colon in the gap " + InCentimeters(gap.begin, gap.end) +
                        " along the line, too long for a collapsed stretch");
    }
  }
  return missing;
}

Json
ResolutionToJson(const ColonModel & model)
{
  const ScanResolution & resolution = model.resolution;
  Json                   json;
  json["text"] = InWords(resolution);
  json["spacing"] = { resolution.spacing[0], resolution.spacing[1], resolution.spacing[2] };
  json["sliceThickness"] = resolution.sliceThickness > 0.0 ? Json(resolution.sliceThickness) : Json(nullptr);
  json["blur"] = resolution.blur;
  json["smallestPolyp"] = resolution.smallestPolyp;
  if (model.wall.raw.NumberOfFaces() > 0)
  {
    json["handlesBeforeRepair"] = model.wall.report.rawGenus;
  }
  return json;
}

Json
SurfacesToJson(const ColonWallReport & report)
{
  Json json;
  json["genusRaw"] = report.rawGenus;
  json["genusRepaired"] = report.repairedGenus;
  json["cutVolume"] = report.topology.cutVolume;
  json["cavityVolume"] = report.topology.cavityVolume;
  json["cavities"] = report.topology.cavities;
  json["droppedPieces"] = report.topology.droppedPieces;
  json["droppedVolume"] = report.topology.droppedVolume;
  json["bridgedFaces"] = report.bridgedFaces;
  json["openedRadius"] = { { "rectum", report.rectumRadius }, { "cecum", report.cecumRadius } };
  json["wall"] = SurfaceQualityToJson(report.rawQuality);
  json["wall-repaired"] = SurfaceQualityToJson(report.repairedQuality);
  json["wall-simplified"] = SurfaceQualityToJson(report.simplifiedQuality);
  return json;
}
} // namespace

void
StateValve(const ValveSearch & search, Json & quality)
{
  const std::string unknown = "the ileocecal valve: it is unknown whether the line ends in the cecum";
  Json              missing = Json::array();
  for (const Json & part : quality.at("missing"))
  {
    if (part != unknown)
    {
      missing.push_back(part);
    }
  }
  if (!search.valve && !quality.contains("failure"))
  {
    missing.push_back(unknown);
  }
  quality["ileocecalValve"] = ValveToJson(search);
  quality["isComplete"] = missing.empty();
  quality["missing"] = std::move(missing);
}

Json
ColonQualityToJson(const ColonModel & model)
{
  Json json;
  json["note"] = "For research use; not a diagnosis. Lengths in mm, volumes in ml, points in LPS.";
  const std::vector<std::string> missing = MissingParts(model);
  json["isComplete"] = missing.empty();
  json["missing"] = missing;
  if (!model.failure.empty())
  {
    json["failure"] = model.failure;
  }
  json["warnings"] = model.warnings;
  json["resolution"] = ResolutionToJson(model);
  json["lumen"] = LumenToJson(model);
  if (!model.centerline.curve.curves.empty())
  {
    json["centerline"] = CenterlineToJson(model.centerline);
    json["distension"] = DistensionToJson(model.distension);
    json["assessability"] = AssessabilityToJson(model);
    StateValve(model.valve, json);
    json["terminalIleum"] = IleumToJson(model.terminalIleum);
  }
  if (model.wall.raw.NumberOfFaces() > 0)
  {
    json["surface"] = SurfacesToJson(model.wall.report);
  }
  return json;
}
} // namespace shapeton
