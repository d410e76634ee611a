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
using namespace shapeton;

using ImageType = itk::Image<float, 3>;
using FilterType = ParticleDiffusionImageFilter<ImageType>;

void
CheckUsage(const CommandLine & commandLine)
{
  RequireIntensityWindow(commandLine);
  RequireParameter(!commandLine.IsGiven("featureSize") || !commandLine.IsGiven("distance"),
                   "--featureSize sets the distance; do not combine it with --distance");
  RequireParameter(!commandLine.IsGiven("previewEvery") || commandLine.IsGiven("preview"),
                   "--previewEvery requires --preview, the picture to update");
  RequireParameter(!commandLine.IsGiven("epsilon") || commandLine.GetFlag("untilSteady") ||
                     commandLine.IsGiven("preview") || commandLine.IsGiven("report"),
                   "--epsilon has no effect without --untilSteady, --preview or --report");
}

constexpr double shareOfChoice = 0.1; // of the time of a run

/** The options that are given; the others are those of the preset. */
ShapetonParameterChoice
ChooseOptions(CommandLine & commandLine, const Volume & volume)
{
  ShapetonPresetOptions options;
  const auto            given = ReadGivenOptions(commandLine, options);
  const auto            progress = commandLine.PartOfProgress(0.0, shareOfChoice).Part("Choosing parameters", 0.0, 1.0);
  return ChooseShapetonParameters(VolumeView(volume.image.GetPointer()), options, given, progress);
}

/** Time steps of the rows of the report's histogram. */
FilterType::StepsType
HistogramSteps(std::uint64_t timeSteps)
{
  constexpr std::size_t rows = 64;
  auto                  steps = MakeSnapshotSteps(timeSteps, rows, SnapshotSpacing::Logarithmic);
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
  catch (const InputError & error)
  {
    const std::string source = commandLine.IsGiven("resume") ? "resume" : "inputVolume";
    throw InputError(commandLine.GetString(source) + ": " + error.GetDescription());
  }
}

void
Diffuse(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  auto                      filter = FilterType::New();
  const ParticleResultFiles files(commandLine);
  const Volume              volume = ReadVolume(commandLine, "inputVolume", true);
  filter->SetInput(volume.image);
  const auto choice = ChooseOptions(commandLine, volume);
  filter->SetOptions(choice.options);
  if (commandLine.IsGiven("mask"))
  {
    filter->SetMaskImage(ReadMask(commandLine, "mask", volume.image));
  }
  if (commandLine.IsGiven("resume"))
  {
    ResumeFromCheckpoint(commandLine, filter);
  }
  if (files.WantHistogram())
  {
    filter->SetHistogramSteps(HistogramSteps(filter->GetTimeSteps()));
  }
  ParticleMonitor monitor(commandLine, filter);
  commandLine.Watch(filter, "Diffusing shapetons", shareOfChoice, 0.95 - shareOfChoice);
  Update(commandLine, filter);
  commandLine.AddRunFact("device", filter->GetDeviceUse().Describe());
  for (const auto & [name, value] : ShapetonValues(filter))
  {
    if (!commandLine.IsGiven(name))
    {
      commandLine.AddProvenance("chosen." + name, value);
    }
  }
  commandLine.Warn(ParticleRemarks(filter));
  files.Write(filter, choice, volume);
  monitor.Finish();
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Diffuse);
}
