#include "shapetonColonPhantomOptions.h"

#include "shapetonColonPhantomParameters.h"
#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shapeton
{
namespace
{
// A value equal to the default of the module description is treated as not given.
template <typename TNumber>
void
Override(const CommandLine & commandLine, const char * name, TNumber & value)
{
  if (commandLine.IsGiven(name))
  {
    value = static_cast<TNumber>(commandLine.GetDouble(name));
  }
}

void
Override(const CommandLine & commandLine, const char * name, std::string & value)
{
  if (commandLine.IsGiven(name))
  {
    value = commandLine.GetString(name);
  }
}

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

// Overrides an option of a structure that does not exist in `standard` and `hard`.
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

void
ReadParts(CommandLine & commandLine, ColonPhantomParameters & parameters)
{
  OverridePart(commandLine, "lengths", parameters.lengths);
  OverridePart(commandLine, "caliber", parameters.caliber);
  OverridePart(commandLine, "cecumMobility", parameters.cecumMobility);
  OverridePart(commandLine, "smallBowelTagged", parameters.smallBowelTagged);
  OverridePart(commandLine, "stomachIntensity", parameters.stomachIntensity);
  OverridePart(commandLine, "stool", parameters.stool);
  OverridePart(commandLine, "stoolTagged", parameters.stoolTagged);
  OverridePart(commandLine, "bubbles", parameters.bubbles);
  OverridePart(commandLine, "foam", parameters.foam);
  OverridePart(commandLine, "diverticula", parameters.diverticula);
  OverridePart(commandLine, "kernel", parameters.kernel);
  OverridePart(commandLine, "sliceThickness", parameters.sliceThickness);
  OverridePart(commandLine, "catheter", parameters.catheter);
  OverridePart(commandLine, "catheterBore", parameters.catheterBore);
  OverridePart(commandLine, "catheterWall", parameters.catheterWall);
  OverridePart(commandLine, "catheterIntensity", parameters.catheterIntensity);
  OverridePart(commandLine, "catheterDepth", parameters.catheterDepth);
  OverridePart(commandLine, "catheterHoles", parameters.catheterHoles);
  OverridePart(commandLine, "balloon", parameters.balloon);
  OverridePart(commandLine, "balloonDiameter", parameters.balloonDiameter);
  OverridePart(commandLine, "valve", parameters.valve);
  OverridePart(commandLine, "valveLength", parameters.valveLength);
  OverridePart(commandLine, "valveHeight", parameters.valveHeight);
  OverridePart(commandLine, "valveFat", parameters.valveFat);
  OverridePart(commandLine, "ileumBore", parameters.ileumBore);
  OverridePart(commandLine, "ileumLength", parameters.ileumLength);
  OverridePart(commandLine, "ileumContent", parameters.ileumContent);
  OverridePart(commandLine, "lungs", parameters.lungs);
  OverridePart(commandLine, "lungDensity", parameters.lungDensity);
  OverridePart(commandLine, "contents", parameters.contents);
}
} // namespace

ColonPhantomParameters
ReadColonPhantomParameters(CommandLine & commandLine)
{
  auto parameters = ColonPhantomPreset(commandLine.GetString("preset"));
  parameters.position = commandLine.GetString("position");
  parameters.seed = static_cast<unsigned>(commandLine.GetInteger("seed"));
  Override(commandLine, "polyps", parameters.polyps);
  Override(commandLine, "collapsed", parameters.collapsed);
  Override(commandLine, "fakeHandles", parameters.fakeHandles);
  Override(commandLine, "fluid", parameters.fluid);
  Override(commandLine, "roughness", parameters.roughness);
  Override(commandLine, "flattenedFolds", parameters.flattenedFolds);
  Override(commandLine, "foldSlide", parameters.foldSlide);
  Override(commandLine, "distension", parameters.distension);
  Override(commandLine, "torsion", parameters.torsion);
  Override(commandLine, "noise", parameters.noise);
  ReadParts(commandLine, parameters);
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
