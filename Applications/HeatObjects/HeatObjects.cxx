#include "HeatObjectsXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonHeatClassification.h"
#include "shapetonHeatObjectExplorer.h"
#include "shapetonHeatObjectSelection.h"
#include "shapetonHeatObjectTable.h"
#include "shapetonHeatObjects.h"
#include "shapetonHeatSnapshot.h"
#include "shapetonReadOptions.h"
#include "shapetonImageGrid.h"
#include "shapetonLabelFiles.h"
#include "shapetonToolVolumes.h"

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

void
ListObjects(CommandLine & commandLine)
{
  CheckHeatObjectSelection(commandLine);
  const SegmentFiles files(commandLine, "labels");
  const std::string  table = commandLine.OutputOf("table");
  const std::string  picture = commandLine.OutputOf("picture");
  HeatObjectExplorer explorer(commandLine);

  const Volume volume = ReadVolume(commandLine, "inputVolume");
  const Heat   heat = ReadHeat(commandLine, volume.image);
  const auto   tree = BuildTree(commandLine, heat.image);
  const auto   list = tree.List(IsSelectionGiven(commandLine));
  commandLine.Warn(list.warnings);
  const auto selection = SelectHeatObjects(commandLine, list);
  HeatObjectTable(list, selection.listed, volume.image).Write(table);
  explorer.Write(volume.image, heat.image, heat.file, tree, list);
  const auto labels = selection.isOfSome ? LabelsOfObjects(list, selection.chosen) : list.labels;
  files.WriteObjects(labels, selection.chosen);
  if (!picture.empty())
  {
    WritePng(DrawHeatObjects(volume.image, labels, selection.chosen, selection.title), picture);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, ListObjects);
}
