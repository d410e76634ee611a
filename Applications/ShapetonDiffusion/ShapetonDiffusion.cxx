#include "ShapetonDiffusionXML.h"

#include "itkAutomaticParameters.h"
#include "itkCommandLine.h"
#include "itkShapetonDiffusionImageFilter.h"
#include "itkShapetonMonitor.h"
#include "itkShapetonParameters.h"
#include "itkShapetonResultFiles.h"
#include "itkToolError.h"
#include "itkVolumeReader.h"

#include <charconv>

namespace
{
using itk::CommandLine;
using ImageType = itk::Image<float, 3>;
using FilterType = itk::ShapetonDiffusionImageFilter<ImageType>;

void
Require(bool condition, const std::string & message)
{
  if (!condition)
  {
    throw itk::UsageError(message);
  }
}

void
CheckUsage(const CommandLine & commandLine)
{
  const auto window = commandLine.GetDoubles("intensityWindow");
  Require(window.empty() || (window.size() == 2 && window[0] < window[1]),
          "--intensityWindow needs two numbers, the lower one first, for example -160,240");
  Require(!commandLine.IsGiven("featureSize") || !commandLine.IsGiven("distance"),
          "--featureSize chooses the distance; give either it or --distance");
  Require(!commandLine.IsGiven("previewEvery") || commandLine.IsGiven("preview"),
          "--previewEvery needs --preview, the picture to replace");
  Require(!commandLine.IsGiven("epsilon") || commandLine.GetFlag("untilSteady") || commandLine.IsGiven("preview") ||
            commandLine.IsGiven("report"),
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
  Require(parsed.ec == std::errc() && parsed.ptr == end && epsilon > 0.0 && epsilon < 1e300,
          "--epsilon: \"" + text + "\" is neither a positive number nor auto");
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
  filter->SetP(commandLine.GetDouble("p"));
  filter->SetNumberOfShapetons(static_cast<std::uint32_t>(commandLine.GetInteger("shapetons")));
  filter->SetDistance(commandLine.GetDouble("distance"));
  filter->SetTimeSteps(static_cast<std::uint64_t>(commandLine.GetInteger("timeSteps")));
  filter->SetDirectionSampling(sampling == "solidAngle"   ? itk::DirectionSampling::SolidAngle
                               : sampling == "sectorArea" ? itk::DirectionSampling::SectorArea
                                                          : itk::DirectionSampling::Uniform);
  filter->SetPathRule(commandLine.GetString("pathRule") == "endpoint" ? itk::PathRule::Endpoint
                                                                      : itk::PathRule::Traversal);
  filter->SetPlacement(commandLine.GetString("placement") == "uniform" ? itk::ShapetonPlacement::Uniform
                                                                       : itk::ShapetonPlacement::InitialHeat);
  filter->SetSeed(static_cast<std::uint64_t>(commandLine.GetInteger("seed")));
  filter->SetUntilSteady(commandLine.GetFlag("untilSteady"));
  SetEpsilon(commandLine, filter);
}

/** Distance and number by the size of the features, where that is given; a number that is given stays. */
std::optional<itk::AutomaticShapetons>
ChooseParameters(CommandLine & commandLine, FilterType * filter)
{
  if (!commandLine.IsGiven("featureSize"))
  {
    return std::nullopt;
  }
  const ImageType * const    image = filter->GetInput();
  std::array<std::size_t, 3> size{};
  std::array<double, 3>      spacing{};
  std::copy_n(image->GetLargestPossibleRegion().GetSize().begin(), 3, size.begin());
  std::copy_n(image->GetSpacing().Begin(), 3, spacing.begin());
  itk::AutomaticShapetons chosen;
  try
  {
    chosen = itk::ChooseShapetons(size, spacing, commandLine.GetDouble("featureSize"), filter->GetTimeSteps());
  }
  catch (const std::invalid_argument & error)
  {
    throw itk::UsageError(std::string("--featureSize: ") + error.what());
  }
  filter->SetDistance(chosen.distance);
  commandLine.AddProvenance("chosen.distance", itk::CsvTable::Number(chosen.distance));
  if (commandLine.IsGiven("shapetons"))
  {
    chosen.shapetonsReason = "given by --shapetons";
  }
  else
  {
    filter->SetNumberOfShapetons(chosen.shapetons);
    commandLine.AddProvenance("chosen.shapetons", std::to_string(chosen.shapetons));
  }
  return chosen;
}

/** The rows of the report's histogram. */
FilterType::StepsType
HistogramSteps(std::uint64_t timeSteps)
{
  constexpr std::size_t rows = 64;
  auto                  steps = itk::MakeSnapshotSteps(timeSteps, rows, itk::SnapshotSpacing::Logarithmic);
  steps.erase(steps.begin()); // nothing is visited before the first step
  return steps;
}

void
Update(const CommandLine & commandLine, FilterType * filter)
{
  try
  {
    filter->Update();
  }
  catch (const itk::ShapetonInputError & error)
  {
    throw itk::InputError(commandLine.GetString("inputVolume") + ": " + error.GetDescription());
  }
}

void
Diffuse(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  auto filter = FilterType::New();
  Configure(commandLine, filter);
  const itk::ShapetonResultFiles files(commandLine);
  const itk::Volume              volume = itk::ReadVolume(commandLine, "inputVolume", true);
  filter->SetInput(volume.image);
  const auto chosen = ChooseParameters(commandLine, filter);
  if (commandLine.IsGiven("mask"))
  {
    filter->SetMaskImage(itk::ReadMask(commandLine, "mask", volume.image));
  }
  if (commandLine.IsGiven("resume"))
  {
    itk::ResumeFromCheckpoint(commandLine, filter);
  }
  if (files.WantHistogram())
  {
    filter->SetHistogramSteps(HistogramSteps(filter->GetTimeSteps()));
  }
  itk::ShapetonMonitor monitor(commandLine, filter);
  commandLine.Watch(filter, "Diffusing shapetons", 0.0, 0.95);
  Update(commandLine, filter);
  for (const auto & remark : itk::ShapetonRemarks(filter))
  {
    commandLine.Warn(remark);
  }
  files.Write(filter, volume, chosen);
  monitor.Finish();
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Diffuse);
}
