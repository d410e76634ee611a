#include "HeatObjectsXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonHeatObjectExplorer.h"
#include "shapetonHeatObjectTable.h"
#include "shapetonHeatObjects.h"
#include "shapetonHeatSnapshot.h"
#include "shapetonReadOptions.h"
#include "shapetonImageGrid.h"
#include "shapetonLabelFiles.h"
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

HeatObjectList
Find(CommandLine & commandLine, const HeatImage * heat)
{
  HeatObjectOptions options;
  ReadOptions(commandLine, options);
  auto list = FindHeatObjects(heat, options, commandLine.PartOfProgress(0.2, 0.9).Part("Finding objects", 0.0, 1.0));
  if (list.objects.empty())
  {
    commandLine.Warn("no object was found: diffuse heat with the preset automatic, or reduce --leastProbability");
  }
  return list;
}

/** The objects at a point, the smallest first, and the chosen one. */
struct Selection
{
  std::vector<int> objects;
  int              chosen{ 0 };
};

Selection
Select(const CommandLine & commandLine, const HeatObjectList & list)
{
  const auto point = commandLine.GetDoubles("select");
  const auto objects = ObjectsAt(list, itk::Point<double, 3>(point.data()));
  const auto clicked = std::find(objects.begin(), objects.end(), ObjectOfClick(list, objects.front()));
  const auto climb = commandLine.GetInteger("climb");
  const auto least = objects.begin() - clicked;
  const auto most = objects.end() - clicked - 1;
  RequireParameter(climb >= least && climb <= most,
                   "--climb " + std::to_string(climb) + ": with the objects at this point, it can be " +
                     std::to_string(least) + " to " + std::to_string(most));
  return { objects, *(clicked + climb) };
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

  const Volume volume = ReadVolume(commandLine, "inputVolume");
  const Heat   heat = ReadHeat(commandLine, volume.image);
  auto         list = Find(commandLine, heat.image);
  Selection    selection{ std::vector<int>(list.objects.size()) };
  std::iota(selection.objects.begin(), selection.objects.end(), 1);
  if (isSelected)
  {
    selection = Select(commandLine, list);
  }
  HeatObjectTable(list, selection.objects, volume.image).Write(table);
  explorer.Write(volume.image, heat.image, heat.file, list);
  std::string title = std::to_string(list.objects.size()) + " objects";
  if (isSelected)
  {
    KeepObject(selection.chosen, list);
    selection.objects = { selection.chosen };
    title = "selected object";
  }
  WriteObjectLabels(list.labels, selection.objects, labels, commandLine.GetProvenance());
  if (!picture.empty())
  {
    WritePng(DrawHeatObjects(volume.image, list.labels, selection.objects, title), picture);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, ListObjects);
}
