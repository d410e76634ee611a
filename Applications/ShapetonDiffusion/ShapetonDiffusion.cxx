#include "ShapetonDiffusionXML.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonCommandLine.h"
#include "shapetonReadOptions.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticleMonitor.h"
#include "shapetonParticleResultFiles.h"
#include "shapetonExceptions.h"
#include "shapetonToolDevice.h"
#include "shapetonToolVolumes.h"

namespace
{
using shapeton::CommandLine;
using ImageType = itk::Image<float, 3>;
using FilterType = shapeton::ParticleDiffusionImageFilter<ImageType>;

void
CheckUsage(const CommandLine & commandLine)
{
  shapeton::RequireIntensityWindow(commandLine);
  shapeton::RequireParameter(!commandLine.IsGiven("featureSize") || !commandLine.IsGiven("distance"),
                             "--featureSize sets the distance; do not combine it with --distance");
  shapeton::RequireParameter(!commandLine.IsGiven("previewEvery") || commandLine.IsGiven("preview"),
                             "--previewEvery requires --preview, the picture to update");
  shapeton::RequireParameter(!commandLine.IsGiven("epsilon") || commandLine.GetFlag("untilSteady") ||
                               commandLine.IsGiven("preview") || commandLine.IsGiven("report"),
                             "--epsilon has no effect without --untilSteady, --preview or --report");
}

constexpr double shareOfChoice = 0.1; // of the time of a run

/** The options that are given; the others are those of the preset. */
shapeton::ShapetonParameterChoice
ChooseOptions(CommandLine & commandLine, const shapeton::Volume & volume)
{
  shapeton::ShapetonPresetOptions options;
  const auto                      given = shapeton::ReadGivenOptions(commandLine, options);
  const auto progress = commandLine.PartOfProgress(0.0, shareOfChoice).Part("Choosing parameters", 0.0, 1.0);
  return shapeton::ChooseShapetonParameters(
    shapeton::VolumeView(volume.image.GetPointer()), options, given, volume.modality, progress);
}

/** Time steps of the rows of the report's histogram. */
FilterType::StepsType
HistogramSteps(std::uint64_t timeSteps)
{
  constexpr std::size_t rows = 64;
  auto                  steps = shapeton::MakeSnapshotSteps(timeSteps, rows, shapeton::SnapshotSpacing::Logarithmic);
  steps.erase(steps.begin()); // no visits before the first step
  return steps;
}

void
Update(const CommandLine & commandLine, FilterType * filter)
{
  try
  {
    filter->Update();
  }
  catch (const shapeton::ShapetonInputError & error)
  {
    throw shapeton::InputError(commandLine.GetString("inputVolume") + ": " + error.GetDescription());
  }
}

void
Diffuse(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  auto                                filter = FilterType::New();
  const shapeton::ParticleResultFiles files(commandLine);
  const shapeton::Volume              volume = shapeton::ReadVolume(commandLine, "inputVolume", true);
  filter->SetInput(volume.image);
  const auto choice = ChooseOptions(commandLine, volume);
  filter->SetOptions(choice.options);
  if (commandLine.IsGiven("mask"))
  {
    filter->SetMaskImage(shapeton::ReadMask(commandLine, "mask", volume.image));
  }
  if (commandLine.IsGiven("resume"))
  {
    shapeton::ResumeFromCheckpoint(commandLine, filter);
  }
  if (files.WantHistogram())
  {
    filter->SetHistogramSteps(HistogramSteps(filter->GetTimeSteps()));
  }
  shapeton::ParticleMonitor monitor(commandLine, filter);
  commandLine.Watch(filter, "Diffusing shapetons", shareOfChoice, 0.95 - shareOfChoice);
  Update(commandLine, filter);
  commandLine.AddRunFact("device", filter->GetDeviceUse().Describe());
  for (const auto & [name, value] : shapeton::ShapetonValues(filter))
  {
    if (!commandLine.IsGiven(name))
    {
      commandLine.AddProvenance("chosen." + name, value);
    }
  }
  for (const auto & remark : shapeton::ParticleRemarks(filter))
  {
    commandLine.Warn(remark);
  }
  files.Write(filter, choice, volume);
  monitor.Finish();
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Diffuse);
}
