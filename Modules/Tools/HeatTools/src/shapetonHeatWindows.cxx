#include "shapetonHeatWindows.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonObjectParameters.h"
#include "shapetonReadOptions.h"

namespace shapeton
{
std::vector<HeatParameterChoice>
ChooseWindows(CommandLine &                                              commandLine,
              const std::string &                                        modality,
              double                                                     end,
              CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>> * filter)
{
  if (commandLine.GetString("preset") == "published")
  {
    return {};
  }
  auto             options = filter->GetOptions();
  const auto       names = ReadGivenOptions(commandLine, options);
  const auto       given = GivenAmong(names, options);
  const auto       progress = commandLine.PartOfProgress(0.0, end).Part("Choosing parameters", 0.0, 1.0);
  const VolumeView volume(filter->GetInput());
  const auto       choices =
    commandLine.GetString("preset") == "objects"
            ? ChooseObjectWindows(volume, options, given, progress)
            : std::vector<HeatParameterChoice>{ ChooseHeatParameters(volume, options, given, modality, progress) };
  filter->UseParameters(choices.front());
  for (const auto & [name, value] : ChosenValues(choices.front()))
  {
    commandLine.AddProvenance("chosen." + name, value);
  }
  return choices;
}

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
WriteHeatWindows(CommandLine &                                              commandLine,
                 const HeatResultFiles &                                    files,
                 const std::vector<HeatParameterChoice> &                   windows,
                 double                                                     start,
                 double                                                     end,
                 CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>> * filter)
{
  const std::string folder = commandLine.GetString("windowFolder");
  if (folder.empty())
  {
    return;
  }
  const double share = (end - start) / static_cast<double>(windows.size());
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
