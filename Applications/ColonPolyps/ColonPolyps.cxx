#include "ColonPolypsXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExaminationInputs.h"
#include "shapetonPolypCandidateReport.h"
#include "shapetonPolypContent.h"
#include "shapetonReadOptions.h"
#include "shapetonRegistrationFolder.h"
#include "shapetonSha256.h"
#include "shapetonSlicerMarkups.h"
#include "shapetonSurfaceReader.h"
#include "shapetonExceptions.h"
#include "shapetonVolumeWriter.h"

#include <limits>

namespace
{
using shapeton::CommandLine;
using Candidates = std::vector<shapeton::PolypCandidate>;

void
CheckUsage(const CommandLine & commandLine)
{
  shapeton::RequireParameter(!commandLine.IsGiven("other") || commandLine.IsGiven("registration"),
                             "--other requires --registration, which maps candidates to the other position");
}

/** Selects the map of a registration that starts from the wall of the candidates. */
void
MapToOther(CommandLine & commandLine, Candidates & candidates)
{
  if (!commandLine.IsGiven("registration"))
  {
    return;
  }
  std::vector<shapeton::OtherPolypCandidate> others;
  if (commandLine.IsGiven("other"))
  {
    const std::string path = commandLine.GetString("other");
    commandLine.AddInput("other", "sha256:" + shapeton::Sha256OfFile(path));
    others = shapeton::ReadOtherPolypCandidates(path);
  }
  const std::string     folder = commandLine.GetString("registration");
  std::string           nearest;
  shapeton::SurfaceMesh map;
  double                least = std::numeric_limits<double>::infinity();
  for (const auto & file : { shapeton::examination::supineToProne, shapeton::examination::proneToSupine })
  {
    const std::string       path = folder + '/' + file.name;
    const shapeton::Surface surface = shapeton::ReadSurface(path);
    commandLine.AddProvenance(file.Path(), surface.identity);
    const double distance = shapeton::MeanDistanceToWall(surface.mesh, candidates);
    if (distance < least)
    {
      least = distance;
      nearest = path;
      map = surface.mesh;
    }
  }
  const double confidence = shapeton::ConfidenceOfRegistration(folder);
  if (confidence < shapeton::LeastRegistrationConfidence)
  {
    commandLine.Warn("the registration \"" + folder + "\" has a confidence of " +
                     shapeton::CsvTable::Rounded(confidence, 2) +
                     "; the other position was ignored (see the reasons in its report)");
    return;
  }
  shapeton::FindInOtherPosition(map, '"' + nearest + '"', others, candidates);
  if (commandLine.IsGiven("other"))
  {
    shapeton::WeighByOtherPosition(confidence, candidates);
  }
}

void
SearchForPolyps(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string table = commandLine.OutputOf("outputTable");
  const std::string markups = commandLine.OutputOf("markups");
  const std::string heads = commandLine.OutputOf("heads");
  shapeton::RequireVolumeName(heads);
  const std::string report = commandLine.GetString("report");
  if (!report.empty())
  {
    commandLine.MakeFolder(report);
  }
  commandLine.RecordRun(commandLine.GetString("outputTable") + ".run.json");

  commandLine.Progress("Reading", 0.0);
  const shapeton::PolypColon colon =
    shapeton::ReadPolypColon(shapeton::ExaminationFolder(commandLine.GetString("inputFolder"), "ColonPolyps"));
  commandLine.LeaveOutOfProvenance("inputFolder");
  for (const auto & [name, identity] : colon.facts)
  {
    commandLine.AddProvenance(name, identity);
  }
  commandLine.Warn(colon.warnings);

  shapeton::PolypSearchSettings settings;
  shapeton::ReadOptions(commandLine, settings);
  settings.progress = commandLine.PartOfProgress(0.2, 0.7);
  Candidates candidates = shapeton::SearchPolyps(colon, settings);
  MapToOther(commandLine, candidates);

  commandLine.Progress("Writing", 0.7);
  shapeton::TableOfPolypCandidates(candidates).Write(table);
  if (!markups.empty())
  {
    shapeton::WriteMarkups(shapeton::MarkupsOfPolypCandidates(candidates), markups);
  }
  if (!heads.empty())
  {
    shapeton::WriteVolume(shapeton::LabelPolypHeads(colon.wall, colon.lumen, candidates).GetPointer(),
                          heads,
                          shapeton::ProvenanceMetadata(commandLine.GetProvenance()));
  }
  shapeton::WritePolypCandidateReport(commandLine, colon, candidates, report);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, SearchForPolyps);
}
