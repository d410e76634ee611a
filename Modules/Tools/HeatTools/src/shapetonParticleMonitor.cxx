#include "shapetonParticleMonitor.h"

#include "shapetonAxisTicks.h"
#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonFileErrors.h"
#include "shapetonHeatColoring.h"
#include "shapetonLiveExplorer.h"
#include "shapetonShapeAnalysis.h"
#include "shapetonSliceMontage.h"
#include "shapetonExceptions.h"

#include "itkCommand.h"
#include "itkImageRegionConstIteratorWithIndex.h"

#include <cerrno>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace shapeton
{
namespace
{
using Clock = std::chrono::steady_clock;

/** Minimum interval; a state is as large as the volume. */
constexpr double secondsBetweenCheckpoints = 60.0;

double
SecondsSince(const Clock::time_point & start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string
DescribeProgress(const ParticleProgress & progress)
{
  const ParticleMeasures & measures = progress.measures;
  std::string              text = "Step " + GroupedDigits(measures.step) + " of " + GroupedDigits(progress.timeSteps);
  if (progress.stepsPerSecond > 0.0)
  {
    text += ", " + CsvTable::Rounded(progress.stepsPerSecond, 3) + " steps/s";
  }
  text += ", coverage " + CsvTable::Rounded(100.0 * measures.GetCoverage(), 3) + " %, change " +
          CsvTable::Rounded(measures.change, 3) + " (steady: " + CsvTable::Rounded(progress.epsilon, 3) + ")";
  return text;
}
} // namespace

Picture::Pointer
DrawParticlePreview(const itk::Image<float, 3> *         gray,
                    const itk::Image<std::uint32_t, 3> * visits,
                    const itk::Index<3> &                cut,
                    const ParticleProgress &             progress)
{
  const ShapeAnalysis shape = AnalyzeVisits(visits, progress.measures.step, false);
  SliceMontageOptions options{ DescribeProgress(progress), {}, cut };
  return DrawSliceMontage(gray, shape.values, ColorByHeat(HeatAxis(shape.axisHistogram)), options);
}

itk::Index<3>
MiddleOfObjects(const itk::Image<float, 3> * gray, double lower)
{
  const auto            region = gray->GetBufferedRegion();
  std::array<double, 3> sum{};
  double                voxels = 0.0;
  for (itk::ImageRegionConstIteratorWithIndex<itk::Image<float, 3>> voxel(gray, region); !voxel.IsAtEnd(); ++voxel)
  {
    if (voxel.Get() > lower)
    {
      voxels += 1.0;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += static_cast<double>(voxel.GetIndex()[axis]);
      }
    }
  }
  itk::Index<3> middle;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    middle[axis] = voxels > 0.0 ? static_cast<itk::IndexValueType>(std::lround(sum[axis] / voxels))
                                : region.GetIndex(axis) + static_cast<itk::IndexValueType>(region.GetSize(axis) / 2);
  }
  return middle;
}

void
ResumeFromCheckpoint(CommandLine & commandLine, ParticleDiffusionImageFilter<itk::Image<float, 3>> * filter)
{
  const std::string path = commandLine.GetString("resume");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    ThrowCannotRead(path, errno);
  }
  ParticleState state;
  try
  {
    state = ReadParticleState(stream);
  }
  catch (const std::runtime_error & error)
  {
    throw InputError(path + " is not a valid checkpoint, " + error.what() + ": use a file written by --checkpoint");
  }
  if (state.step > filter->GetTimeSteps())
  {
    throw ParameterError("the checkpoint " + path + " is from step " + std::to_string(state.step) +
                         ": increase --timeSteps to at least this step");
  }
  filter->SetInitialState(std::move(state));
  commandLine.AllowReplacing("resume");
}

struct ParticleMonitor::Impl
{
  Impl(CommandLine & line, FilterType * watched)
    : commandLine(line)
    , filter(watched)
    , preview(line.GetString("preview"))
    , checkpoint(line.GetString("checkpoint"))
    , previewEvery(line.GetDouble("previewEvery"))
  {
    commandLine.LeaveOutOfProvenance("previewEvery");
    // Reject unwritable outputs now.
    Register(checkpoint);
    if (std::filesystem::path(preview).extension() == ".html")
    {
      RegisterPage();
    }
    else
    {
      Register(preview);
    }
  }

  void
  RegisterPage()
  {
    page.emplace(preview, [this](const std::string & path) { return temporary.at(path); });
    commandLine.MakeFolder(page->DataFolder());
    for (const std::string & path : page->PageFiles())
    {
      Register(path);
    }
    Register(page->StateFile());
  }

  void
  Register(const std::string & path)
  {
    if (!path.empty())
    {
      temporary[path] = commandLine.Output(path);
    }
  }

  void
  Publish(const std::string & path)
  {
    commandLine.Publish(path);
    Register(path);
  }

  double
  RateSinceLastPreview()
  {
    const std::uint64_t step = filter->GetMeasures().step;
    const double        rate = static_cast<double>(step - previewStep) / std::max(1e-9, SecondsSince(previewTime));
    previewStep = step;
    previewTime = Clock::now();
    return rate;
  }

  void
  WritePreview(double stepsPerSecond, bool isFinished)
  {
    const ParticleMeasures & measures = filter->GetMeasures();
    const double             epsilon = filter->GetEpsilon().value_or(measures.automaticEpsilon);
    const ParticleProgress   progress{ measures, filter->GetTimeSteps(), stepsPerSecond, epsilon };
    if (page)
    {
      WritePage();
      page->WriteState(AnalyzeVisits(filter->GetOutput(), measures.step),
                       { measures.step, DescribeProgress(progress), isFinished });
      return;
    }
    if (!cut)
    {
      cut = MiddleOfObjects(filter->GetInput(), filter->GetWindowLower());
    }
    WritePng(DrawParticlePreview(filter->GetInput(), filter->GetOutput(), *cut, progress), temporary[preview]);
  }

  /** Writes the constant part on the first call. */
  void
  WritePage()
  {
    if (!isPageWritten)
    {
      HeatExplorerContent content;
      content.title = "Shapeton diffusion";
      content.gray = filter->GetInput();
      page->WritePage(content, previewEvery);
      isPageWritten = true;
    }
  }

  void
  PublishPreview()
  {
    if (!page)
    {
      Publish(preview);
      return;
    }
    for (const std::string & path : page->PageFiles())
    {
      if (temporary.erase(path) > 0)
      {
        commandLine.Publish(path);
      }
    }
    Publish(page->StateFile());
  }

  void
  WriteCheckpoint()
  {
    std::ofstream stream(temporary[checkpoint], std::ios::binary);
    WriteParticleState(filter->GetState(), stream);
    stream.close();
    if (!stream)
    {
      throw OutputError("cannot write the checkpoint " + checkpoint + "; free some space or choose another folder");
    }
  }

  void
  Look()
  {
    constexpr double patience = 5.0; // times the duration of a preview
    if (!preview.empty() && SecondsSince(previewTime) >= std::max(previewEvery, patience * secondsOfPreview))
    {
      const double rate = RateSinceLastPreview();
      WritePreview(rate, false);
      PublishPreview();
      secondsOfPreview = SecondsSince(previewTime);
    }
    if (!checkpoint.empty() && SecondsSince(checkpointTime) >= secondsBetweenCheckpoints)
    {
      WriteCheckpoint();
      Publish(checkpoint);
      checkpointTime = Clock::now();
    }
  }

  CommandLine &                      commandLine;
  FilterType *                       filter;
  const std::string                  preview;
  const std::string                  checkpoint;
  const double                       previewEvery;
  std::map<std::string, std::string> temporary;
  std::optional<itk::Index<3>>       cut;
  std::optional<LiveExplorer>        page; // if the preview is a page
  bool                               isPageWritten{ false };
  double                             secondsOfPreview{ 0.0 }; // duration of the last one
  unsigned long                      observer{ 0 };
  const Clock::time_point            start{ Clock::now() };
  Clock::time_point                  previewTime{ start };
  Clock::time_point                  checkpointTime{ start };
  std::uint64_t                      previewStep{ 0 };
};

ParticleMonitor::ParticleMonitor(CommandLine & commandLine, FilterType * filter)
  : m_Impl(std::make_unique<Impl>(commandLine, filter))
{
  filter->SetWantState(!m_Impl->checkpoint.empty());
  auto command = itk::SimpleMemberCommand<Impl>::New();
  command->SetCallbackFunction(m_Impl.get(), &Impl::Look);
  m_Impl->observer = filter->AddObserver(itk::IterationEvent(), command);
}

ParticleMonitor::~ParticleMonitor() { m_Impl->filter->RemoveObserver(m_Impl->observer); }

void
ParticleMonitor::Finish()
{
  if (!m_Impl->preview.empty())
  {
    m_Impl->WritePreview(
      static_cast<double>(m_Impl->filter->GetMeasures().step) / std::max(1e-9, SecondsSince(m_Impl->start)), true);
  }
  if (!m_Impl->checkpoint.empty())
  {
    m_Impl->WriteCheckpoint();
  }
}
} // namespace shapeton
