#include "ShapetonDiffusionXML.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonCommandLine.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticleMonitor.h"
#include "shapetonParticleResultFiles.h"
#include "shapetonExceptions.h"
#include "shapetonToolDevice.h"
#include "shapetonToolVolumes.h"

#include <charconv>

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

void
SetEpsilon(const CommandLine & commandLine, FilterType * filter)
{
  const std::string text = commandLine.GetString("epsilon");
  if (text == "auto")
  {
    filter->AutomaticEpsilonOn();
    return;
  }
  double             epsilon = 0.0;
  const auto * const end = text.data() + text.size();
  const auto         parsed = std::from_chars(text.data(), end, epsilon);
  shapeton::RequireParameter(parsed.ec == std::errc() && parsed.ptr == end && epsilon > 0.0 && epsilon < 1e300,
                             "--epsilon: \"" + text + "\" is not a positive number or auto");
  filter->SetEpsilon(epsilon);
}

void
Configure(const CommandLine & commandLine, FilterType * filter)
{
  if (const auto window = commandLine.GetDoubles("intensityWindow"); !window.empty())
  {
    filter->SetIntensityWindow(window[0], window[1]);
  }
  const std::string sampling = commandLine.GetString("directionSampling");
  filter->SetDevice(shapeton::ReadDevice(commandLine));
  filter->SetP(commandLine.GetDouble("p"));
  filter->SetNumberOfShapetons(static_cast<std::uint32_t>(commandLine.GetInteger("shapetons")));
  filter->SetDistance(commandLine.GetDouble("distance"));
  filter->SetTimeSteps(static_cast<std::uint64_t>(commandLine.GetInteger("timeSteps")));
  filter->SetDirectionSampling(sampling == "solidAngle"   ? shapeton::DirectionSampling::SolidAngle
                               : sampling == "sectorArea" ? shapeton::DirectionSampling::SectorArea
                                                          : shapeton::DirectionSampling::Uniform);
  filter->SetPathRule(commandLine.GetString("pathRule") == "endpoint" ? shapeton::PathRule::Endpoint
                                                                      : shapeton::PathRule::Traversal);
  filter->SetPlacement(commandLine.GetString("placement") == "uniform" ? shapeton::ParticlePlacement::Uniform
                                                                       : shapeton::ParticlePlacement::InitialHeat);
  filter->SetSeed(static_cast<std::uint64_t>(commandLine.GetInteger("seed")));
  filter->SetUntilSteady(commandLine.GetFlag("untilSteady"));
  SetEpsilon(commandLine, filter);
  if (commandLine.IsGiven("featureSize"))
  {
    filter->SetFeatureSize(commandLine.GetDouble("featureSize"));
    filter->AutomaticDistanceOn();
    filter->SetAutomaticNumberOfShapetons(!commandLine.IsGiven("shapetons"));
  }
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
  auto filter = FilterType::New();
  Configure(commandLine, filter);
  const shapeton::ParticleResultFiles files(commandLine);
  const shapeton::Volume              volume = shapeton::ReadVolume(commandLine, "inputVolume", true);
  filter->SetInput(volume.image);
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
  commandLine.Watch(filter, "Diffusing shapetons", 0.0, 0.95);
  Update(commandLine, filter);
  commandLine.AddRunFact("device", filter->GetDeviceUse().Describe());
  if (filter->GetAutomaticDistance())
  {
    commandLine.AddProvenance("chosen.distance", shapeton::CsvTable::Number(filter->GetDistance()));
    commandLine.AddProvenance("chosen.shapetons", std::to_string(filter->GetNumberOfShapetons()));
  }
  for (const auto & remark : shapeton::ParticleRemarks(filter))
  {
    commandLine.Warn(remark);
  }
  files.Write(filter, volume);
  monitor.Finish();
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Diffuse);
}
