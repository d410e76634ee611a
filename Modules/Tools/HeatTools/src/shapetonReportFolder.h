#ifndef shapetonReportFolder_h
#define shapetonReportFolder_h

#include "shapetonCommandLine.h"
#include "shapetonHeatExplorer.h"

#include <memory>

namespace shapeton
{
/** Creates the folder of a report and, inside it, the data folder of its explorer. */
inline std::unique_ptr<HeatExplorer>
MakeExplorer(CommandLine & commandLine, const std::string & folder)
{
  commandLine.MakeFolder(folder + "/" + HeatExplorer::DataFolder);
  return std::make_unique<HeatExplorer>(folder,
                                        [&commandLine](const std::string & path) { return commandLine.Output(path); });
}
} // namespace shapeton

#endif
