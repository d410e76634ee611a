#include "shapetonHeatObjectSelection.h"

#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonHeatObjectTable.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
namespace
{
/** The object that a click on a point selects, and those at the point. */
HeatObjectSelection
SelectAt(const itk::Point<double, 3> & point, std::int64_t climb, const HeatObjectList & list)
{
  const auto objects = ObjectsAt(list, point);
  const auto clicked = std::find(objects.begin(), objects.end(), ObjectOfClick(list, objects.front()));
  if (list.IsOffer(*clicked))
  {
    const HeatObject & offer = list.objects[*clicked - 1];
    throw InputError("no object at " + CsvTable::Number(point[0]) + ',' + CsvTable::Number(point[1]) + ',' +
                     CsvTable::Number(point[2]) + " mm is probable enough: the best region there has " +
                     std::to_string(offer.voxels) + " voxels and the probability " +
                     CsvTable::Number(offer.probability) + "; reduce --leastProbability or choose another point");
  }
  const auto least = objects.begin() - clicked;
  const auto most = objects.end() - clicked - 1;
  RequireParameter(climb >= least && climb <= most,
                   "--climb " + std::to_string(climb) + ": at this point are " + std::to_string(most) + " larger and " +
                     std::to_string(-least) + " smaller objects");
  return { { *(clicked + climb) }, objects, true, "" };
}

std::vector<int>
SelectNumbers(const CommandLine & commandLine, const HeatObjectList & list)
{
  std::vector<int> numbers;
  for (const auto number : commandLine.GetIntegers("objects"))
  {
    const auto most = static_cast<int>(list.objects.size());
    RequireParameter(number >= 1 && number <= most,
                     "--objects " + std::to_string(number) +
                       ": the objects and the less probable regions have the numbers 1 to " + std::to_string(most) +
                       "; see the table");
    numbers.push_back(static_cast<int>(number));
  }
  return numbers;
}
} // namespace

void
CheckHeatObjectSelection(const CommandLine & commandLine)
{
  const bool        isPoint = commandLine.IsGiven("select");
  const std::size_t numbers = commandLine.GetDoubles("select").size();
  RequireParameter(!isPoint || (numbers > 0 && numbers % 3 == 0),
                   "--select requires three numbers for each point, in mm (LPS)");
  RequireParameter(!isPoint || !commandLine.IsGiven("objects"),
                   "--select and --objects are two ways to select; use one");
  RequireParameter(!commandLine.IsGiven("climb") || (isPoint && numbers == 3),
                   "--climb requires --select and one point");
  RequireParameter(!IsSelectionGiven(commandLine) || !commandLine.IsGiven("explorer"),
                   "--explorer shows all objects; remove --select and --objects");
}

bool
IsSelectionGiven(const CommandLine & commandLine)
{
  return commandLine.IsGiven("select") || commandLine.IsGiven("objects");
}

HeatObjectSelection
SelectHeatObjects(const CommandLine & commandLine, const HeatObjectList & list)
{
  const auto          coordinates = commandLine.GetDoubles("select");
  HeatObjectSelection selection;
  selection.isOfSome = IsSelectionGiven(commandLine);
  selection.chosen = SelectNumbers(commandLine, list);
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    const auto one = SelectAt(itk::Point<double, 3>(&coordinates[i]), commandLine.GetInteger("climb"), list);
    selection.chosen.insert(selection.chosen.end(), one.chosen.begin(), one.chosen.end());
    selection.listed = coordinates.size() == 3 ? one.listed : selection.chosen;
  }
  if (!selection.isOfSome)
  {
    selection.chosen.resize(list.objects.size());
    std::iota(selection.chosen.begin(), selection.chosen.end(), 1);
  }
  selection.listed = selection.listed.empty() ? selection.chosen : selection.listed;
  selection.title = selection.isOfSome ? (selection.chosen.size() == 1 ? "selected object" : "selected objects")
                                       : std::to_string(list.objects.size()) + " objects";
  return selection;
}
} // namespace shapeton
