#include "HeatObjectsXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonHeatObjectExplorer.h"
#include "shapetonHeatObjectTable.h"
#include "shapetonHeatSnapshot.h"
#include "shapetonReadOptions.h"
#include "shapetonImageGrid.h"
#include "shapetonToolVolumes.h"
#include "shapetonVolumeWriter.h"
#include "shapetonWindowObjects.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace
{
using namespace shapeton;

using HeatImage = itk::Image<float, 3>;

/** The heat volumes in which objects are searched for, the time steps that identify them, and their windows if these
 * differ. */
struct Heats
{
  std::vector<HeatFile>              files;
  std::vector<const HeatImage *>     images;
  std::vector<std::string>           names;
  std::vector<std::array<double, 2>> windows;
};

Heats
ReadHeats(CommandLine & commandLine, const HeatImage * image)
{
  Heats             heats;
  const std::string path = commandLine.GetString("heatVolume");
  const auto        windows = FindHeatWindows(path);
  for (const auto & snapshot : windows.empty() ? FindHeatSnapshots(path) : windows)
  {
    const Volume heat = ReadVolume(snapshot.path);
    commandLine.AddInput("heatVolume", heat.identity);
    if (!HaveSameGrid(image, heat.image))
    {
      throw InputError("the grids of " + commandLine.GetString("inputVolume") + " and " + snapshot.path +
                       " differ; use the volume from which the heat was computed");
    }
    if (!VisitsOf(heat.image, snapshot))
    {
      RequireHeat(heat.image, snapshot.path);
    }
    heats.files.push_back({ heat.image, snapshot });
    heats.images.push_back(heat.image);
    heats.names.push_back(snapshot.timeStep ? std::to_string(*snapshot.timeStep) : "unknown");
    if (!windows.empty())
    {
      heats.windows.push_back(snapshot.intensityWindow.value());
    }
  }
  return heats;
}

HeatObjectList
Find(CommandLine & commandLine, const Heats & heats)
{
  HeatObjectOptions options;
  ReadOptions(commandLine, options);
  const auto find = heats.windows.empty() ? &FindHeatObjects : &FindWindowObjects;
  auto       list = find(heats.images, options, commandLine.PartOfProgress(0.2, 0.9).Part("Finding objects", 0.0, 1.0));
  if (list.objects.empty())
  {
    commandLine.Warn("no object was found: diffuse heat with the preset objects, or reduce --leastProbability");
  }
  return list;
}

/** The objects at the selected point, the smallest first; at least one more than --climb. */
std::vector<int>
SelectedObjects(const CommandLine & commandLine, const HeatObjectList & list)
{
  const auto point = commandLine.GetDoubles("select");
  const auto objects = ObjectsAt(list, itk::Point<double, 3>(point.data()));
  const auto climb = static_cast<std::size_t>(commandLine.GetInteger("climb"));
  RequireParameter(climb < objects.size(),
                   "--climb " + std::to_string(climb) + ": only " + std::to_string(objects.size()) +
                     " objects contain the point, so it can be at most " + std::to_string(objects.size() - 1));
  return objects;
}

/** Reduces the labels to a mask (1) of one object. */
void
KeepObject(int object, HeatObjectList & list)
{
  const auto mask = MaskOfObject(list, object);
  std::copy_n(mask->GetBufferPointer(), mask->GetBufferedRegion().GetNumberOfPixels(), list.labels->GetBufferPointer());
}

void
ListObjects(CommandLine & commandLine)
{
  RequireVolumeName(commandLine.GetString("labels"));
  const bool isSelected = commandLine.IsGiven("select");
  RequireParameter(!isSelected || commandLine.GetDoubles("select").size() == 3,
                   "--select requires three numbers, a point in mm (LPS)");
  RequireParameter(isSelected || !commandLine.IsGiven("climb"), "--climb requires --select");
  RequireParameter(!isSelected || !commandLine.IsGiven("explorer"), "--explorer shows all objects; remove --select");
  const std::string  labels = commandLine.MainOutput("labels");
  const std::string  table = commandLine.OutputOf("table");
  const std::string  picture = commandLine.OutputOf("picture");
  HeatObjectExplorer explorer(commandLine);

  const Volume     volume = ReadVolume(commandLine, "inputVolume");
  const Heats      heats = ReadHeats(commandLine, volume.image);
  auto             list = Find(commandLine, heats);
  std::vector<int> objects(list.objects.size());
  std::iota(objects.begin(), objects.end(), 1);
  if (isSelected)
  {
    objects = SelectedObjects(commandLine, list);
  }
  HeatObjectTable(list, objects, volume.image, heats.names, heats.windows).Write(table);
  explorer.Write(volume.image, heats.files, list);
  if (isSelected)
  {
    KeepObject(objects[commandLine.GetInteger("climb")], list);
  }
  const std::string title = isSelected ? "selected object" : std::to_string(objects.size()) + " objects";
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
