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
using Source = shapeton::ShapePhantomImageSource;

shapeton::ShapeScene
ReadScene(shapeton::CommandLine & commandLine)
{
  const std::string shape = commandLine.GetString("shape");
  const auto        scene = shapeton::ShapeScene::Load(shape);
  const auto &      presets = shapeton::ShapeScene::GetPresetNames();
  const bool        isPreset = std::find(presets.begin(), presets.end(), shape) != presets.end();
  commandLine.AddInput("shape", isPreset ? shape : "sha256:" + shapeton::Sha256OfFile(shape));
  return scene;
}

Source::Pointer
MakeSource(shapeton::CommandLine & commandLine)
{
  shapeton::PhantomGridOptions gridOptions;
  shapeton::ReadOptions(commandLine, gridOptions);
  const auto grid = shapeton::MakePhantomGrid(gridOptions, sizeof(short) + sizeof(unsigned char));
  if (commandLine.GetFlag("dicom") && shapeton::IsLeftHanded(grid.direction))
  {
    throw shapeton::ParameterError(
      "--direction: a CT series cannot have left-handed axes; change the sign of one column");
  }
  const auto source = Source::New();
  source->SetSize(grid.size);
  source->SetSpacing(grid.spacing);
  source->SetDirection(grid.direction);
  source->CenterOutput();
  source->SetScene(ReadScene(commandLine));
  shapeton::ReadOptionsOf(commandLine, source.GetPointer());
  return source;
}

void
WarnAboutIncompleteObjects(shapeton::CommandLine & commandLine, const Source * source)
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
WriteSeries(const shapeton::CommandLine & commandLine, const Source::ImageType * image, const std::string & folder)
{
  shapeton::DicomSeriesDescription description;
  description.studyDescription = "Shape phantoms";
  description.seriesDescription = "Shape phantom";
  description.seed = commandLine.GetInteger("seed");
  description.comments = shapeton::ProvenanceComment(commandLine.GetProvenance());
  shapeton::WriteDicomSeriesFolder(image, folder, description);
}

void
MakePhantom(shapeton::CommandLine & commandLine)
{
  const std::string output = shapeton::WithoutTrailingSlashes(commandLine.GetString("outputVolume"));
  const bool        dicom = commandLine.GetFlag("dicom");
  const auto        source = MakeSource(commandLine);
  const std::string volumeFile = dicom ? "" : commandLine.Output(output);
  const std::string labelFile = commandLine.OutputOf("labels");
  if (dicom)
  {
    shapeton::CheckDicomSeriesFolder(output);
  }
  commandLine.Watch(source, "Sampling the scene");
  source->Update();
  WarnAboutIncompleteObjects(commandLine, source);

  if (!labelFile.empty())
  {
    shapeton::WriteVolume(source->GetLabelOutput(), labelFile, commandLine.GetProvenance());
  }
  if (dicom)
  {
    WriteSeries(commandLine, source->GetOutput(), output);
  }
  else
  {
    shapeton::WriteVolume(source->GetOutput(), volumeFile, commandLine.GetProvenance());
  }
  commandLine.RecordRun(output + ".run.json");
}
} // namespace

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(ToolXML, argc, argv, MakePhantom);
}
