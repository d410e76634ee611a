#include "ShapePhantomXML.h"

#include "shapetonCommandLine.h"
#include "shapetonDicomSeriesWriter.h"
#include "shapetonOrthonormalDirection.h"
#include "shapetonPhantomGrid.h"
#include "shapetonPrintable.h"
#include "shapetonReadOptions.h"
#include "shapetonSha256.h"
#include "shapetonShapePhantomImageSource.h"
#include "shapetonExceptions.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>

namespace
{
using namespace shapeton;

using Source = ShapePhantomImageSource;

ShapeScene
ReadScene(CommandLine & commandLine)
{
  const std::string shape = commandLine.GetString("shape");
  const auto        scene = ShapeScene::Load(shape);
  const auto &      presets = ShapeScene::GetPresetNames();
  const bool        isPreset = std::find(presets.begin(), presets.end(), shape) != presets.end();
  commandLine.AddInput("shape", isPreset ? shape : "sha256:" + Sha256OfFile(shape));
  return scene;
}

Source::Pointer
MakeSource(CommandLine & commandLine)
{
  PhantomGridOptions gridOptions;
  ReadOptions(commandLine, gridOptions);
  const auto grid = MakePhantomGrid(gridOptions, sizeof(short) + sizeof(unsigned char));
  if (commandLine.GetFlag("dicom") && IsLeftHanded(grid.direction))
  {
    throw ParameterError("--direction: a CT series cannot have left-handed axes; change the sign of one column");
  }
  const auto source = Source::New();
  source->SetSize(grid.size);
  source->SetSpacing(grid.spacing);
  source->SetDirection(grid.direction);
  source->CenterOutput();
  source->SetScene(ReadScene(commandLine));
  ReadOptionsOf(commandLine, source.GetPointer());
  return source;
}

void
WarnAboutIncompleteObjects(CommandLine & commandLine, const Source * source)
{
  std::string names;
  for (const auto & name : source->FindIncompleteObjects())
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty())
  {
    commandLine.Warn("the volume cuts or misses " + names + "; enlarge it or move the objects");
  }
}

void
WriteSeries(const CommandLine & commandLine, const Source::ImageType * image, const std::string & folder)
{
  DicomSeriesDescription description;
  description.studyDescription = "Shape phantoms";
  description.seriesDescription = "Shape phantom";
  description.seed = commandLine.GetInteger("seed");
  description.comments = ProvenanceComment(commandLine.GetProvenance());
  WriteDicomSeriesFolder(image, folder, description);
}

void
MakePhantom(CommandLine & commandLine)
{
  const std::string output = WithoutTrailingSlashes(commandLine.GetString("outputVolume"));
  const bool        dicom = commandLine.GetFlag("dicom");
  if (dicom)
  {
    commandLine.RequireOutside("labels", output);
  }
  const auto        source = MakeSource(commandLine);
  const std::string volumeFile = dicom ? "" : commandLine.Output(output);
  const std::string labelFile = commandLine.OutputOf("labels");
  if (dicom)
  {
    commandLine.MakeParentFolder(output);
    CheckDicomSeriesFolder(output);
  }
  commandLine.Watch(source, "Sampling the scene");
  source->Update();
  WarnAboutIncompleteObjects(commandLine, source);

  if (!labelFile.empty())
  {
    WriteVolume(source->GetLabelOutput(), labelFile, commandLine.GetProvenance());
  }
  if (dicom)
  {
    WriteSeries(commandLine, source->GetOutput(), output);
  }
  else
  {
    WriteVolume(source->GetOutput(), volumeFile, commandLine.GetProvenance());
  }
  commandLine.RecordRun(output + ".run.json");
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, MakePhantom);
}
