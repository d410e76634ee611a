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

/** The registration with the other position, as seen from this one. */
struct OtherPosition
{
  std::vector<OtherPolypCandidate> candidates;
  std::string                      nearest;       ///< path of the map
  SurfaceMesh                      map;           ///< the map that starts from the wall of this position
  int                              position{ 0 }; ///< 0: this position is the supine one
};

OtherPosition
ReadOther(CommandLine & commandLine, const SurfaceMesh & wall)
{
  const std::string folder = commandLine.GetString("registration");
  OtherPosition     other;
  if (commandLine.IsGiven("other"))
  {
    const std::string path = commandLine.GetString("other");
    commandLine.AddInput("other", "sha256:" + Sha256OfFile(path));
    other.candidates = ReadOtherPolypCandidates(path);
  }
  double least = std::numeric_limits<double>::infinity();
  int    position = 0;
  for (const auto & file : { examination::supineToProne, examination::proneToSupine })
  {
    const std::string path = folder + '/' + file.name;
    Surface           surface = ReadSurface(path);
    commandLine.AddProvenance(file.Path(), surface.identity);
    const double distance = MeanDistanceToWall(surface.mesh, wall.V);
    if (distance < least)
    {
      least = distance;
      other.nearest = path;
      other.map = std::move(surface.mesh);
      other.position = position;
    }
    ++position;
  }
  return other;
}

void
MapToOther(CommandLine & commandLine, const OtherPosition & other, Candidates & candidates)
{
  const std::string folder = commandLine.GetString("registration");
  const double      confidence = ConfidenceOfRegistration(folder);
  if (confidence < LeastRegistrationConfidence)
  {
    commandLine.Warn("the registration \"" + folder + "\" has a confidence of " + CsvTable::Rounded(confidence, 2) +
                     "; the other position was ignored (see the reasons in its report)");
    return;
  }
  FindInOtherPosition(other.map, '"' + other.nearest + '"', other.candidates, candidates);
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
  PolypColon colon = ReadPolypColon(ExaminationFolder(commandLine.GetString("inputFolder"), "ColonPolyps"));
  commandLine.LeaveOutOfProvenance("inputFolder");
  for (const auto & [name, identity] : colon.facts)
  {
    commandLine.AddProvenance(name, identity);
  }
  commandLine.Warn(colon.warnings);
  const bool          hasOther = commandLine.IsGiven("registration");
  const OtherPosition other = hasOther ? ReadOther(commandLine, colon.wall) : OtherPosition();
  if (const auto valve =
        hasOther ? ValveOfRegistration(commandLine.GetString("registration"), other.position) : std::nullopt)
  {
    SetIleocecalValve(*valve, colon.centerline);
  }

  PolypSearchSettings settings;
  ReadOptions(commandLine, settings);
  settings.progress = commandLine.PartOfProgress(0.2, 0.7);
  Candidates candidates = SearchPolyps(colon, settings);
  if (hasOther)
  {
    MapToOther(commandLine, other, candidates);
  }

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
