#include "shapetonColonPhantomOptions.h"

#include "shapetonColonPhantomParameters.h"
#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonReadOptions.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shapeton
{
namespace
{
void
Override(const CommandLine & commandLine, const char * name, SegmentValues & values)
{
  if (!commandLine.IsGiven(name))
  {
    return;
  }
  const std::vector<double> numbers = commandLine.GetDoubles(name);
  RequireParameter(numbers.size() == values.size(),
                   "the parameter \"" + std::string(name) + "\" requires six numbers, one per segment");
  std::copy(numbers.begin(), numbers.end(), values.begin());
}

void
Override(const CommandLine & commandLine, const char * name, std::vector<std::string> & values)
{
  if (commandLine.IsGiven(name))
  {
    values = commandLine.GetStrings(name);
  }
}

// Overrides an option that does not exist in `standard` and `hard`.
template <typename TValue>
void
OverridePart(CommandLine & commandLine, const char * name, TValue & value)
{
  Override(commandLine, name, value);
  if (!commandLine.IsGiven(name))
  {
    commandLine.LeaveOutOfProvenance(name);
  }
}

/** Overrides the option if it is given; a value equal to the default in the module description does not count as given.
 */
template <typename TOption>
void
OverrideOption(const CommandLine & commandLine, const OptionInfo & info, TOption & option)
{
  if (commandLine.IsGiven(info.GetName()))
  {
    ReadOption(commandLine, info, option);
  }
}
} // namespace

ColonPhantomParameters
ReadColonPhantomParameters(CommandLine & commandLine)
{
  auto parameters = ColonPhantomPreset(commandLine.GetString("preset"));
  ColonPatientOptions::VisitOptions(
    parameters, [&](const OptionInfo & info, auto & option) { OverrideOption(commandLine, info, option); });
  if (!commandLine.IsGiven("anatomicalTaeniae")) // newer than the published series
  {
    commandLine.LeaveOutOfProvenance("anatomicalTaeniae");
  }
  ColonStructureOptions::VisitOptions(parameters, [&](const OptionInfo & info, auto & option) {
    OverrideOption(commandLine, info, option);
    const std::string name = info.GetName();
    if (name != "noise" && !commandLine.IsGiven(name)) // `standard` and `hard` have noise
    {
      commandLine.LeaveOutOfProvenance(name);
    }
  });
  OverridePart(commandLine, "lengths", parameters.lengths);
  OverridePart(commandLine, "caliber", parameters.caliber);
  OverridePart(commandLine, "contents", parameters.contents);
  RequireValid(parameters);
  return parameters;
}

itk::Point<double, 3>
ReadPhantomCenter(CommandLine & commandLine)
{
  if (!commandLine.IsGiven("center"))
  {
    commandLine.LeaveOutOfProvenance("center");
  }
  constexpr double          farthest = 1000.0; // mm; larger than any patient
  const std::vector<double> numbers = commandLine.GetDoubles("center");
  RequireParameter(numbers.size() == 3,
                   "the parameter \"center\" requires 3 numbers, not " + std::to_string(numbers.size()));
  RequireParameter(std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::abs(x) <= farthest; }),
                   "the parameter \"center\" has a coordinate outside -1000 to 1000 mm");
  return itk::Point<double, 3>(numbers.data());
}
} // namespace shapeton
