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
using shapeton::CommandLine;
using HeatImage = itk::Image<float, 3>;

/** The heat volumes in which objects are searched, the time steps that name them, and their windows if they have
 * different ones. */
struct Heats
{
  std::vector<shapeton::HeatFile>    files;
  std::vector<const HeatImage *>     images;
  std::vector<std::string>           names;
  std::vector<std::array<double, 2>> windows;
};

Heats
ReadHeats(CommandLine & commandLine, const HeatImage * image)
{
  Heats             heats;
  const std::string path = commandLine.GetString("heatVolume");
  const auto        windows = shapeton::FindHeatWindows(path);
  for (const auto & snapshot : windows.empty() ? shapeton::FindHeatSnapshots(path) : windows)
  {
    const shapeton::Volume heat = shapeton::ReadVolume(snapshot.path);
    commandLine.AddInput("heatVolume", heat.identity);
    if (!shapeton::HaveSameGrid(image, heat.image))
    {
      throw shapeton::InputError("the grids of " + commandLine.GetString("inputVolume") + " and " + snapshot.path +
                                 " differ; use the volume from which the heat was computed");
    }
    if (!shapeton::VisitsOf(heat.image, snapshot))
    {
      shapeton::RequireHeat(heat.image, snapshot.path);
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

shapeton::HeatObjectList
Find(CommandLine & commandLine, const Heats & heats)
{
  shapeton::HeatObjectOptions options;
  shapeton::ReadOptions(commandLine, options);
  const auto find = heats.windows.empty() ? &shapeton::FindHeatObjects : &shapeton::FindWindowObjects;
  auto       list = find(heats.images, options, commandLine.PartOfProgress(0.2, 0.9).Part("Finding objects", 0.0, 1.0));
  if (list.objects.empty())
  {
    commandLine.Warn("no object was found: diffuse heat with the preset objects, or reduce --leastProbability");
  }
  return list;
}

/** The objects at the selected point, the smallest first; at least one more than --climb. */
std::vector<int>
SelectedObjects(const CommandLine & commandLine, const shapeton::HeatObjectList & list)
{
  const auto point = commandLine.GetDoubles("select");
  const auto objects = shapeton::ObjectsAt(list, itk::Point<double, 3>(point.data()));
  const auto climb = static_cast<std::size_t>(commandLine.GetInteger("climb"));
  shapeton::RequireParameter(climb < objects.size(),
                             "--climb " + std::to_string(climb) + ": only " + std::to_string(objects.size()) +
                               " objects contain the point, so it can be at most " +
                               std::to_string(objects.size() - 1));
  return objects;
}

/** Reduces the labels to one object, as 1. */
void
KeepObject(int object, shapeton::HeatObjectList & list)
{
  const auto mask = shapeton::MaskOfObject(list, object);
  std::copy_n(mask->GetBufferPointer(), mask->GetBufferedRegion().GetNumberOfPixels(), list.labels->GetBufferPointer());
}

void
ListObjects(CommandLine & commandLine)
{
  shapeton::RequireVolumeName(commandLine.GetString("labels"));
  const bool isSelected = commandLine.IsGiven("select");
  shapeton::RequireParameter(!isSelected || commandLine.GetDoubles("select").size() == 3,
                             "--select requires three numbers, a point in mm (LPS)");
  shapeton::RequireParameter(isSelected || !commandLine.IsGiven("climb"), "--climb requires --select");
  shapeton::RequireParameter(!isSelected || !commandLine.IsGiven("explorer"),
                             "--explorer shows all objects; remove --select");
  const std::string output = commandLine.GetString("labels");
  const std::string labels = commandLine.Output(output);
  const std::string table = commandLine.OutputOf("table");
  const std::string picture = commandLine.OutputOf("picture");
  commandLine.RecordRun(output + ".run.json");
  shapeton::HeatObjectExplorer explorer(commandLine);

  const shapeton::Volume volume = shapeton::ReadVolume(commandLine, "inputVolume");
  const Heats            heats = ReadHeats(commandLine, volume.image);
  auto                   list = Find(commandLine, heats);
  std::vector<int>       objects(list.objects.size());
  std::iota(objects.begin(), objects.end(), 1);
  if (isSelected)
  {
    objects = SelectedObjects(commandLine, list);
  }
  shapeton::HeatObjectTable(list, objects, volume.image, heats.names, heats.windows).Write(table);
  explorer.Write(volume.image, heats.files, list);
  if (isSelected)
  {
    KeepObject(objects[commandLine.GetInteger("climb")], list);
  }
  const std::string title = isSelected ? "selected object" : std::to_string(objects.size()) + " objects";
  shapeton::WriteVolume(list.labels.GetPointer(), labels, shapeton::ProvenanceMetadata(commandLine.GetProvenance()));
  if (!picture.empty())
  {
    shapeton::WritePng(shapeton::DrawHeatObjects(volume.image, list.labels, title), picture);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, ListObjects);
}
