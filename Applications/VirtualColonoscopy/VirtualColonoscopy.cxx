#include "VirtualColonoscopyXML.h"

#include "shapetonColonWall.h"
#include "shapetonColonoscopyRun.h"
#include "shapetonCommandLine.h"
#include "shapetonStagedRun.h"
#include "shapetonExceptions.h"

namespace
{
using namespace shapeton;

/** Options that require another option. */
void
CheckSecond(const CommandLine & commandLine)
{
  for (const char * const name : { "secondSeriesUID",
                                   "secondLumen",
                                   "secondMarkers",
                                   "secondPosition",
                                   "secondSeedPoint",
                                   "matching",
                                   "refine",
                                   "segmentWise",
                                   "evaluate" })
  {
    RequireParameter(commandLine.IsGiven("second") || !commandLine.IsGiven(name),
                     std::string("--") + name + " requires --second");
  }
  RequireParameter(!commandLine.IsGiven("second") ||
                     commandLine.GetString("second") != commandLine.GetString("inputVolume") ||
                     commandLine.GetString("secondSeriesUID") != commandLine.GetString("seriesUID"),
                   "the second series is the first one; set --secondSeriesUID or use another folder");
}

/** Checks options in advance that a tool would reject only after minutes. */
void
CheckUsage(const CommandLine & commandLine)
{
  const bool isLumen = commandLine.GetFlag("inputIsLumen");
  for (const auto & [lumen, position] : { std::pair("lumen", "position"), std::pair("secondLumen", "secondPosition") })
  {
    RequireParameter(!isLumen || !commandLine.IsGiven(lumen),
                     std::string("--") + lumen + " requires a CT; with --inputIsLumen the input itself is the lumen");
    RequireParameter(!isLumen || !commandLine.IsGiven(position),
                     std::string("--") + position +
                       " has no effect with --inputIsLumen: it determines where fluid pools");
  }
  RequireParameter(commandLine.GetString("metric") != "euclidean" || !commandLine.IsGiven("time"),
                   "--time applies to the heat diffusion metric only, not to --metric euclidean");
  RequireFacesOfWall(commandLine.GetInteger("faces"));
  CheckSecond(commandLine);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, [](CommandLine & commandLine) {
    CheckUsage(commandLine);
    RunColonoscopy(commandLine, FolderOfThisProgram());
  });
}
