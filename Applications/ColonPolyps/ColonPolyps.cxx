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
using namespace shapeton;

using Candidates = std::vector<PolypCandidate>;

void
CheckUsage(const CommandLine & commandLine)
{
  RequireParameter(!commandLine.IsGiven("other") || commandLine.IsGiven("registration"),
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
  std::vector<OtherPolypCandidate> others;
  if (commandLine.IsGiven("other"))
  {
    const std::string path = commandLine.GetString("other");
    commandLine.AddInput("other", "sha256:" + Sha256OfFile(path));
    others = ReadOtherPolypCandidates(path);
  }
  const std::string folder = commandLine.GetString("registration");
  std::string       nearest;
  SurfaceMesh       map;
  double            least = std::numeric_limits<double>::infinity();
  for (const auto & file : { examination::supineToProne, examination::proneToSupine })
  {
    const std::string path = folder + '/' + file.name;
    const Surface     surface = ReadSurface(path);
    commandLine.AddProvenance(file.Path(), surface.identity);
    const double distance = MeanDistanceToWall(surface.mesh, candidates);
    if (distance < least)
    {
      least = distance;
      nearest = path;
      map = surface.mesh;
    }
  }
  const double confidence = ConfidenceOfRegistration(folder);
  if (confidence < LeastRegistrationConfidence)
  {
    commandLine.Warn("the registration \"" + folder + "\" has a confidence of " + CsvTable::Rounded(confidence, 2) +
                     "; the other position was ignored (see the reasons in its report)");
    return;
  }
  FindInOtherPosition(map, '"' + nearest + '"', others, candidates);
  if (commandLine.IsGiven("other"))
  {
    WeighByOtherPosition(confidence, candidates);
  }
}

void
SearchForPolyps(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string table = commandLine.MainOutput("outputTable");
  const std::string markups = commandLine.OutputOf("markups");
  const std::string heads = commandLine.OutputOf("heads");
  RequireVolumeName(heads);
  const std::string report = commandLine.MakeFolderOf("report");

  commandLine.Progress("Reading", 0.0);
  const PolypColon colon = ReadPolypColon(ExaminationFolder(commandLine.GetString("inputFolder"), "ColonPolyps"));
  commandLine.LeaveOutOfProvenance("inputFolder");
  for (const auto & [name, identity] : colon.facts)
  {
    commandLine.AddProvenance(name, identity);
  }
  commandLine.Warn(colon.warnings);

  PolypSearchSettings settings;
  ReadOptions(commandLine, settings);
  settings.progress = commandLine.PartOfProgress(0.2, 0.7);
  Candidates candidates = SearchPolyps(colon, settings);
  MapToOther(commandLine, candidates);

  commandLine.Progress("Writing", 0.7);
  TableOfPolypCandidates(candidates).Write(table);
  if (!markups.empty())
  {
    WriteMarkups(MarkupsOfPolypCandidates(candidates), markups);
  }
  if (!heads.empty())
  {
    WriteVolume(LabelPolypHeads(colon.wall, colon.lumen, candidates).GetPointer(),
                heads,
                ProvenanceMetadata(commandLine.GetProvenance()));
  }
  WritePolypCandidateReport(commandLine, colon, candidates, report);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, SearchForPolyps);
}
