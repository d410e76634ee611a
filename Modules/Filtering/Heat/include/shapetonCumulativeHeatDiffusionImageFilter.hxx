#ifndef shapetonCumulativeHeatDiffusionImageFilter_hxx
#define shapetonCumulativeHeatDiffusionImageFilter_hxx

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonFilterProgress.h"

#include <algorithm>
#include <type_traits>

namespace shapeton
{
template <typename TInputImage>
CumulativeHeatDiffusionImageFilter<TInputImage>::CumulativeHeatDiffusionImageFilter()
{
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(1, HeatImageType::New());
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::SetSnapshotSteps(const StepsType &        steps,
                                                                  const SnapshotConsumer & consumer)
{
  this->m_Options.snapshotSteps = steps;
  m_SnapshotConsumer = consumer;
  this->Modified();
}

template <typename TInputImage>
HeatParameterChoice
CumulativeHeatDiffusionImageFilter<TInputImage>::ChooseParameters(const GivenHeatParameters & given,
                                                                  const std::string &         modality,
                                                                  const Progress &            progress)
{
  const auto choose = [&modality](const float *                           intensities,
                                  const std::array<std::size_t, 3> &      size,
                                  const CumulativeHeatDiffusionSettings & settings,
                                  const GivenHeatParameters &             fixed,
                                  const Progress &                        part) {
    return ChooseHeatParameters(intensities, size, settings, fixed, modality, part);
  };
  return this->ChooseParametersBy(choose, given, progress);
}

template <typename TInputImage>
HeatParameterChoice
CumulativeHeatDiffusionImageFilter<TInputImage>::ChooseParametersBy(const ParameterChooser &    choose,
                                                                    const GivenHeatParameters & given,
                                                                    const Progress &            progress)
{
  this->VerifyPreconditions();
  auto * const input = const_cast<TInputImage *>(this->GetInput());
  input->UpdateOutputInformation();
  input->SetRequestedRegionToLargestPossibleRegion();
  input->Update();
  std::vector<float>              converted;
  CumulativeHeatDiffusionSettings settings = this->m_Options;
  std::copy_n(this->GetInput()->GetSpacing().Begin(), 3, settings.spacing.begin());
  const HeatParameterChoice choice =
    choose(this->GetIntensities(converted), this->GetVolumeSize(), settings, given, progress);
  this->UseParameters(choice);
  return choice;
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::UseParameters(const HeatParameterChoice & choice)
{
  if (choice.intensityWindow[0] < choice.intensityWindow[1]) // not of a constant volume
  {
    this->SetIntensityWindow(choice.intensityWindow);
  }
  this->SetP(choice.p);
  this->SetSmoothing(choice.smoothing);
  this->SetTimeSteps(choice.timeSteps);
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::HandOut(std::uint64_t step, const std::vector<float> & values) const
{
  auto snapshot = HeatImageType::New();
  snapshot->CopyInformation(this->GetOutput());
  snapshot->SetRegions(this->GetOutput()->GetLargestPossibleRegion());
  snapshot->GetPixelContainer()->SetImportPointer(const_cast<float *>(values.data()), values.size(), false);
  m_SnapshotConsumer(step, snapshot);
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::GenerateData()
{
  const TInputImage * const input = this->GetInput();
  HeatImageType * const     heat = this->GetOutput();
  heat->SetBufferedRegion(heat->GetLargestPossibleRegion());
  heat->Allocate();
  HeatImageType * const initialHeat = this->GetInitialHeatOutput();
  if (m_WantInitialHeat)
  {
    initialHeat->SetBufferedRegion(initialHeat->GetLargestPossibleRegion());
    initialHeat->Allocate();
  }
  else
  {
    initialHeat->Initialize(); // clears the previous result
  }
  // Other pixel types are converted into the output buffer, which the heat overwrites at the end.
  const float * intensities = heat->GetBufferPointer();
  if constexpr (std::is_same_v<typename TInputImage::PixelType, float>)
  {
    intensities = input->GetBufferPointer();
  }
  else
  {
    std::transform(input->GetBufferPointer(),
                   input->GetBufferPointer() + input->GetBufferedRegion().GetNumberOfPixels(),
                   heat->GetBufferPointer(),
                   [](auto value) { return static_cast<float>(value); });
  }
  try
  {
    CumulativeHeatDiffusionSettings settings = this->m_Options;
    const auto                      parameters = this->MakeOperatorParameters(intensities);
    settings.intensityWindow = { { parameters.lower, parameters.upper } };
    settings.spacing = parameters.spacing;
    m_Result = DiffuseCumulativeHeat(
      intensities,
      this->GetVolumeSize(),
      settings,
      heat->GetBufferPointer(),
      m_WantInitialHeat ? initialHeat->GetBufferPointer() : nullptr,
      m_SnapshotConsumer
        ? [this](std::uint64_t step, const std::vector<float> & values) { this->HandOut(step, values); }
        : HeatSnapshotConsumer(),
      [this](double share) { ReportProgress(*this, share); });
  }
  catch (const std::logic_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "WantComponents: " << this->m_Options.wantComponents << std::endl;
  os << indent << "HistogramSteps: " << this->m_Options.histogramSteps.size() << std::endl;
  os << indent << "WantInitialHeat: " << m_WantInitialHeat << std::endl;
  os << indent << "SnapshotSteps: " << this->m_Options.snapshotSteps.size() << std::endl;
}
} // namespace shapeton

#endif
