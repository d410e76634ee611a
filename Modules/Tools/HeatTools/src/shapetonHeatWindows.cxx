#include "shapetonHeatWindows.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"

namespace shapeton
{
void
MakeWindowFolder(CommandLine & commandLine)
{
  if (!commandLine.IsGiven("windowFolder"))
  {
    return;
  }
  RequireParameter(commandLine.GetString("preset") == "objects",
                   "--windowFolder requires --preset objects, which chooses the windows");
  RequireParameter(!commandLine.IsGiven("snapshotSteps"),
                   "--windowFolder has one time per window; do not combine it with --snapshotSteps");
  commandLine.MakeFolder(commandLine.GetString("windowFolder"));
}

void
WriteHeatWindows(CommandLine &                                                 commandLine,
                 const HeatResultFiles &                                       files,
                 const std::vector<HeatParameterChoice> &                      windows,
                 double                                                        start,
                 CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>> * filter)
{
  const std::string folder = commandLine.GetString("windowFolder");
  if (folder.empty())
  {
    return;
  }
  constexpr double end = 0.95;
  const double     share = (end - start) / static_cast<double>(windows.size());
  filter->WantComponentsOff();
  filter->SetWantInitialHeat(false);
  filter->SetHistogramSteps({});
  for (std::size_t i = 0; i < windows.size(); ++i)
  {
    if (i > 0)
    {
      filter->UseParameters(windows[i]);
      commandLine.Watch(
        filter, "Diffusing heat, window " + std::to_string(i + 1), start + static_cast<double>(i) * share, share);
      filter->Update();
    }
    files.WriteWindow(filter->GetOutput(), windows[i], i + 1, folder);
  }
}
} // namespace shapeton
