#include "ShapeSignatureXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonReadOptions.h"
#include "shapetonImageGrid.h"
#include "shapetonShapeTable.h"
#include "shapetonToolVolumes.h"

namespace
{
using shapeton::CommandLine;

/** The label map, on the grid of the volume. */
shapeton::LabelMap::Pointer
ReadLabels(CommandLine & commandLine, const shapeton::Volume & volume)
{
  const std::string      path = commandLine.GetString("labels");
  const shapeton::Volume labels = shapeton::ReadVolume(path);
  commandLine.AddInput("labels", labels.identity);
  if (!shapeton::HaveSameGrid(volume.image, labels.image))
  {
    throw shapeton::InputError("the grids of " + commandLine.GetString("inputVolume") + " and " + path +
                               " differ; use the volume to which the labels refer");
  }
  return labels.image;
}

shapeton::ShapeTable
Describe(CommandLine & commandLine, const shapeton::Volume & volume, const shapeton::LabelMap * labels)
{
  shapeton::ShapeTableOptions options;
  shapeton::ReadOptions(commandLine, options);
  try
  {
    return shapeton::DescribeShapes(
      volume.image, labels, options, commandLine.PartOfProgress(0.1, 0.95).Part("Describing shapes", 0.0, 1.0));
  }
  catch (const shapeton::InputError & error)
  {
    throw shapeton::InputError(commandLine.GetString("labels") + ": " + error.what());
  }
}

void
MakeTable(CommandLine & commandLine)
{
  const std::string output = commandLine.GetString("table");
  const std::string table = commandLine.Output(output);
  commandLine.RecordRun(output + ".run.json");
  commandLine.Progress("Reading", 0.0);
  const shapeton::Volume     volume = shapeton::ReadVolume(commandLine, "inputVolume");
  const auto                 labels = ReadLabels(commandLine, volume);
  const shapeton::ShapeTable shapes = Describe(commandLine, volume, labels);
  commandLine.Warn(shapes.remarks);
  shapeton::WriteShapeTable(shapes, table);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, MakeTable);
}
