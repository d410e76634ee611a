#include "ShapeSignatureXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonReadOptions.h"
#include "shapetonImageGrid.h"
#include "shapetonShapeTable.h"
#include "shapetonToolVolumes.h"

namespace
{
using namespace shapeton;

/** The label map, on the grid of the volume. */
LabelMap::Pointer
ReadLabels(CommandLine & commandLine, const Volume & volume)
{
  const std::string path = commandLine.GetString("labels");
  const Volume      labels = ReadVolume(path);
  commandLine.AddInput("labels", labels.identity);
  if (!HaveSameGrid(volume.image, labels.image))
  {
    throw InputError("the grids of " + commandLine.GetString("inputVolume") + " and " + path +
                     " differ; use the volume to which the labels refer");
  }
  return labels.image;
}

ShapeTable
Describe(CommandLine & commandLine, const Volume & volume, const LabelMap * labels)
{
  ShapeTableOptions options;
  ReadOptions(commandLine, options);
  try
  {
    return DescribeShapes(
      volume.image, labels, options, commandLine.PartOfProgress(0.1, 0.95).Part("Describing shapes", 0.0, 1.0));
  }
  catch (const InputError & error)
  {
    throw InputError(commandLine.GetString("labels") + ": " + error.what());
  }
}

void
MakeTable(CommandLine & commandLine)
{
  const std::string table = commandLine.MainOutput("table");
  commandLine.Progress("Reading", 0.0);
  const Volume     volume = ReadVolume(commandLine, "inputVolume");
  const auto       labels = ReadLabels(commandLine, volume);
  const ShapeTable shapes = Describe(commandLine, volume, labels);
  commandLine.Warn(shapes.remarks);
  WriteShapeTable(shapes, table);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, MakeTable);
}
