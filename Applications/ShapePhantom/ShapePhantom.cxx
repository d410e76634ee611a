#include "ShapePhantomXML.h"

#include "itkCommandLine.h"
#include "itkDicomSeriesWriter.h"
#include "itkOrthonormalDirection.h"
#include "itkPhantomGrid.h"
#include "itkSha256.h"
#include "itkShapePhantomImageSource.h"
#include "itkExceptions.h"
#include "itkVolumeWriter.h"

#include <algorithm>

namespace
{
using Source = itk::ShapePhantomImageSource;

itk::ShapeScene
ReadScene(itk::CommandLine & commandLine)
{
  const std::string shape = commandLine.GetString("shape");
  const auto        scene = itk::ShapeScene::Load(shape);
  const auto &      presets = itk::ShapeScene::GetPresetNames();
  const bool        isPreset = std::find(presets.begin(), presets.end(), shape) != presets.end();
  commandLine.AddInput("shape", isPreset ? shape : "sha256:" + itk::Sha256OfFile(shape));
  return scene;
}

Source::Pointer
MakeSource(itk::CommandLine & commandLine)
{
  const auto grid = itk::MakePhantomGrid(commandLine.GetIntegers("size"), commandLine.GetDoubles("spacing"), commandLine.GetDoubles("direction"), sizeof(short) + sizeof(unsigned char));
  if (commandLine.GetFlag("dicom") && itk::IsLeftHanded(grid.direction))
  {
    throw itk::ParameterError("--direction: a CT series cannot have left-handed axes; change the sign of one column");
  }
  const auto source = Source::New();
  source->SetSize(grid.size);
  source->SetSpacing(grid.spacing);
  source->SetDirection(grid.direction);
  source->CenterOutput();
  source->SetScene(ReadScene(commandLine));
  source->SetBlur(commandLine.GetDouble("blur"));
  source->SetNoiseStandardDeviation(commandLine.GetDouble("noise"));
  source->SetSeed(commandLine.GetInteger("seed"));
  return source;
}

void
WarnAboutIncompleteObjects(itk::CommandLine & commandLine, const Source * source)
{
  std::string names;
  for (const auto & name : source->FindIncompleteObjects())
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty())
  {
    commandLine.Warn("the volume cuts off or misses " + names + "; enlarge it or move the objects");
  }
}

void
WriteSeries(const itk::CommandLine & commandLine, const Source::ImageType * image, const std::string & folder)
{
  itk::DicomSeriesDescription description;
  description.studyDescription = "Shape phantoms";
  description.seriesDescription = "Shape phantom";
  description.seed = commandLine.GetInteger("seed");
  description.comments = itk::ProvenanceComment(commandLine.GetProvenance());
  itk::WriteDicomSeriesFolder(image, folder, description);
}

void
MakePhantom(itk::CommandLine & commandLine)
{
  const std::string output = itk::WithoutTrailingSlashes(commandLine.GetString("outputVolume"));
  const bool        dicom = commandLine.GetFlag("dicom");
  const auto        source = MakeSource(commandLine);
  const std::string volumeFile = dicom ? "" : commandLine.Output(output);
  const std::string labelFile = commandLine.OutputOf("labels");
  if (dicom)
  {
    itk::CheckDicomSeriesFolder(output);
  }
  commandLine.Watch(source, "Sampling the scene");
  source->Update();
  WarnAboutIncompleteObjects(commandLine, source);

  if (!labelFile.empty())
  {
    itk::WriteVolume(source->GetLabelOutput(), labelFile, commandLine.GetProvenance());
  }
  if (dicom)
  {
    WriteSeries(commandLine, source->GetOutput(), output);
  }
  else
  {
    itk::WriteVolume(source->GetOutput(), volumeFile, commandLine.GetProvenance());
  }
  commandLine.RecordRun(output + ".run.json");
}
} // namespace

int
main(int argc, char * argv[])
{
  return itk::CommandLine::Run(ToolXML, argc, argv, MakePhantom);
}
