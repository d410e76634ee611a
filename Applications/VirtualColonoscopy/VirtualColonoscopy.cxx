#include "VirtualColonoscopyXML.h"

#include "itkColonoscopyRun.h"
#include "itkCommandLine.h"
#include "itkStagedRun.h"
#include "itkToolError.h"

namespace
{
using itk::CommandLine;

/** What a tool would refuse after minutes is refused now. */
void
CheckUsage(const CommandLine & commandLine)
{
  const bool isLumen = commandLine.GetFlag("inputIsLumen");
  itk::RequireUsage(!isLumen || !commandLine.IsGiven("lumen"),
                    "--lumen belongs to a CT; with --inputIsLumen the input itself is the lumen");
  itk::RequireUsage(!isLumen || !commandLine.IsGiven("position"),
                    "--position says where fluid pools; a lumen (--inputIsLumen) needs none");
  itk::RequireUsage(commandLine.GetString("metric") != "euclidean" || !commandLine.IsGiven("time"),
                    "--time belongs to the heat diffusion metric; --metric euclidean has none");
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, [](CommandLine & commandLine) {
    CheckUsage(commandLine);
    itk::RunColonoscopy(commandLine, itk::FolderOfThisProgram());
  });
}
