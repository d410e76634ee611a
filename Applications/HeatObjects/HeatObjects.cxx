#include "HeatObjectsXML.h"

#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonHeatObjectExplorer.h"
#include "shapetonHeatObjectTable.h"
#include "shapetonHeatObjects.h"
#include "shapetonHeatSnapshot.h"
#include "shapetonReadOptions.h"
#include "shapetonImageGrid.h"
#include "shapetonToolVolumes.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>
#include <numeric>

namespace
{
using namespace shapeton;

using HeatImage = itk::Image<float, 3>;

/** The heat in which objects are searched for. */
struct Heat
{
  HeatSnapshot       file;
  HeatImage::Pointer image;
};

Heat
ReadHeat(CommandLine & commandLine, const HeatImage * image)
{
  const HeatSnapshot file = FindHeatSnapshot(commandLine.GetString("heatVolume"));
  const Volume       heat = ReadVolume(file.path);
  commandLine.AddInput("heatVolume", heat.identity);
  if (!HaveSameGrid(image, heat.image))
  {
    throw InputError("the grids of " + commandLine.GetString("inputVolume") + " and " + file.path +
                     " differ; use the volume from which the heat was computed");
  }
  if (!VisitsOf(heat.image, file))
  {
    RequireHeat(heat.image, file.path);
  }
  return { file, heat.image };
}

HeatObjectTree
BuildTree(CommandLine & commandLine, const HeatImage * heat)
{
  HeatObjectOptions options;
  ReadOptions(commandLine, options);
  const auto domain = ReadDomain(commandLine, heat);
  return HeatObjectTree(heat, options, domain, commandLine.PartOfProgress(0.2, 0.9).Part("Finding objects", 0.0, 1.0));
}

/** The objects of the table, and those in the labels. */
struct Selection
{
  std::vector<int> objects;
  std::vector<int> chosen;
};

/** The object that a click on a point selects, and those at the point, the smallest first. */
Selection
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
                   "--climb " + std::to_string(climb) + ": with the objects at this point, it can be " +
                     std::to_string(least) + " to " + std::to_string(most));
  return { objects, { *(clicked + climb) } };
}

Selection
Select(const CommandLine & commandLine, const HeatObjectList & list)
{
  const auto coordinates = commandLine.GetDoubles("select");
  Selection  all;
  for (const int number : commandLine.GetIntegers("objects"))
  {
    RequireParameter(number >= 1 && number <= static_cast<int>(list.objects.size()),
                     "--objects " + std::to_string(number) + ": there are " + std::to_string(list.objects.size()) +
                       " objects and offers");
    all.chosen.push_back(number);
    all.objects.push_back(number);
  }
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    const auto one = SelectAt(itk::Point<double, 3>(&coordinates[i]), commandLine.GetInteger("climb"), list);
    all.chosen.insert(all.chosen.end(), one.chosen.begin(), one.chosen.end());
    all.objects = coordinates.size() == 3 ? one.objects : all.chosen;
  }
  return all;
}

/** Reduces the labels to a mask (1) of these objects. */
void
KeepObjects(const std::vector<int> & objects, HeatObjectList & list)
{
  list.labels->FillBuffer(0);
  for (const int object : objects)
  {
    for (const VoxelRange & range : list.ranges[object - 1])
    {
      std::fill(list.labels->GetBufferPointer() + range.begin, list.labels->GetBufferPointer() + range.end, 1);
    }
  }
}

void
CheckSelection(const CommandLine & commandLine)
{
  const bool        isSelected = commandLine.IsGiven("select");
  const bool        isListed = commandLine.IsGiven("objects");
  const std::size_t numbers = commandLine.GetDoubles("select").size();
  RequireParameter(!isSelected || (numbers > 0 && numbers % 3 == 0),
                   "--select requires three numbers for each point, in mm (LPS)");
  RequireParameter(!isSelected || !isListed, "--select and --objects are two ways to select; use one");
  RequireParameter(!commandLine.IsGiven("climb") || (isSelected && numbers == 3),
                   "--climb requires --select and one point");
  RequireParameter(!(isSelected || isListed) || !commandLine.IsGiven("explorer"),
                   "--explorer shows all objects; remove --select and --objects");
}

void
ListObjects(CommandLine & commandLine)
{
  RequireVolumeName(commandLine.GetString("labels"));
  CheckSelection(commandLine);
  const std::string  labels = commandLine.MainOutput("labels");
  const std::string  table = commandLine.OutputOf("table");
  const std::string  picture = commandLine.OutputOf("picture");
  HeatObjectExplorer explorer(commandLine);

  const Volume volume = ReadVolume(commandLine, "inputVolume");
  const Heat   heat = ReadHeat(commandLine, volume.image);
  const auto   tree = BuildTree(commandLine, heat.image);
  const bool   isSelected = commandLine.IsGiven("select") || commandLine.IsGiven("objects");
  auto         list = tree.List(isSelected);
  if (list.objects.size() == list.numberOfOffers)
  {
    commandLine.Warn("no object was found: diffuse heat with the preset automatic, or reduce --leastProbability");
  }
  Selection selection{ std::vector<int>(list.objects.size()), {} };
  std::iota(selection.objects.begin(), selection.objects.end(), 1);
  if (isSelected)
  {
    selection = Select(commandLine, list);
  }
  HeatObjectTable(list, selection.objects, volume.image).Write(table);
  explorer.Write(volume.image, heat.image, heat.file, tree);
  std::string title = std::to_string(list.objects.size()) + " objects";
  if (isSelected)
  {
    KeepObjects(selection.chosen, list);
    title = selection.chosen.size() == 1 ? "selected object" : "selected objects";
  }
  WriteVolume(list.labels.GetPointer(), labels, ProvenanceMetadata(commandLine.GetProvenance()));
  if (!picture.empty())
  {
    WritePng(DrawHeatObjects(volume.image, list.labels, title), picture);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, ListObjects);
}
