#ifndef itkCumulativeHeatDiffusionImageFilter_hxx
#define itkCumulativeHeatDiffusionImageFilter_hxx

#include "itkCumulativeHeatDiffusionImageFilter.h"

#include <algorithm>
#include <type_traits>

namespace itk
{
template <typename TInputImage>
CumulativeHeatDiffusionImageFilter<TInputImage>::CumulativeHeatDiffusionImageFilter()
{
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(1, HeatImageType::New());
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::SetIntensityWindow(double lower, double upper)
{
  m_HasWindow = true;
  m_WindowLower = lower;
  m_WindowUpper = upper;
  this->Modified();
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::SetHistogramSteps(const StepsType & steps)
{
  m_HistogramSteps = steps;
  this->Modified();
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::SetSnapshotSteps(const StepsType &        steps,
                                                                  const SnapshotConsumer & consumer)
{
  m_SnapshotSteps = steps;
  m_SnapshotConsumer = consumer;
  this->Modified();
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (!(m_P >= 0.0))
  {
    itkExceptionMacro("P must not be negative, got " << m_P);
  }
  if (m_TimeSteps < 1)
  {
    itkExceptionMacro("TimeSteps must be at least 1");
  }
  if (m_HasWindow && !(m_WindowLower < m_WindowUpper))
  {
    itkExceptionMacro("the intensity window [" << m_WindowLower << ", " << m_WindowUpper << "] is empty or reversed");
  }
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  if (auto * const input = const_cast<TInputImage *>(this->GetInput()))
  {
    input->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TInputImage>
CumulativeHeatDiffusionSettings
CumulativeHeatDiffusionImageFilter<TInputImage>::MakeSettings(const float *                      intensities,
                                                              const std::array<std::size_t, 3> & size)
{
  CumulativeHeatDiffusionSettings settings;
  settings.volumeGradient.lower = m_WindowLower;
  settings.volumeGradient.upper = m_WindowUpper;
  if (!m_HasWindow)
  {
    const auto ends = std::minmax_element(intensities, intensities + size[0] * size[1] * size[2]);
    settings.volumeGradient.lower = *ends.first;
    settings.volumeGradient.upper = *ends.second;
  }
  settings.volumeGradient.conductance = m_Conductance;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    settings.spacing[axis] = this->GetInput()->GetSpacing()[axis];
    settings.volumeGradient.spacing[axis] = m_IgnoreSpacing ? 1.0 : settings.spacing[axis];
  }
  settings.volumeGradient.p = m_P;
  settings.automaticP = m_AutomaticP;
  settings.method = m_Method;
  settings.timeSteps = m_TimeSteps;
  settings.timeStepLength = m_TimeStepLength;
  settings.tolerance = m_Tolerance;
  settings.untilSteady = m_UntilSteady;
  settings.histogramSteps = m_HistogramSteps;
  settings.snapshotSteps = m_SnapshotSteps;
  settings.wantComponents = m_WantComponents;
  return settings;
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
  const auto                 region = input->GetBufferedRegion();
  const std::size_t          number = region.GetNumberOfPixels();
  std::array<std::size_t, 3> size{};
  std::copy_n(region.GetSize().begin(), 3, size.begin());

  // Other pixel types are converted in the output, which the heat replaces at the end.
  const float * intensities = heat->GetBufferPointer();
  if constexpr (std::is_same_v<typename TInputImage::PixelType, float>)
  {
    intensities = input->GetBufferPointer();
  }
  else
  {
    std::transform(input->GetBufferPointer(),
                   input->GetBufferPointer() + number,
                   heat->GetBufferPointer(),
                   [](auto value) { return static_cast<float>(value); });
  }
  const auto progress = [this](double share) {
    this->UpdateProgress(static_cast<float>(share));
    if (this->GetAbortGenerateData())
    {
      throw ProcessAborted(__FILE__, __LINE__);
    }
  };
  try
  {
    m_Result = DiffuseCumulativeHeat(
      intensities,
      size,
      this->MakeSettings(intensities, size),
      heat->GetBufferPointer(),
      m_WantInitialHeat ? initialHeat->GetBufferPointer() : nullptr,
      m_SnapshotConsumer
        ? [this](std::uint64_t step, const std::vector<float> & values) { this->HandOut(step, values); }
        : HeatSnapshotConsumer(),
      progress);
  }
  catch (const std::logic_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "P: " << m_P << std::endl;
  os << indent << "AutomaticP: " << m_AutomaticP << std::endl;
  os << indent << "TimeSteps: " << m_TimeSteps << std::endl;
  os << indent << "TimeStepLength: " << m_TimeStepLength << std::endl;
  os << indent << "Method: " << (m_Method == Method::Chebyshev ? "Chebyshev" : "Explicit") << std::endl;
  os << indent << "Tolerance: " << m_Tolerance << std::endl;
  os << indent << "HasWindow: " << m_HasWindow << std::endl;
  os << indent << "WindowLower: " << m_WindowLower << std::endl;
  os << indent << "WindowUpper: " << m_WindowUpper << std::endl;
  os << indent << "Conductance: " << (m_Conductance == Conductance::Physical ? "Physical" : "Published") << std::endl;
  os << indent << "IgnoreSpacing: " << m_IgnoreSpacing << std::endl;
  os << indent << "UntilSteady: " << m_UntilSteady << std::endl;
  os << indent << "WantComponents: " << m_WantComponents << std::endl;
  os << indent << "WantInitialHeat: " << m_WantInitialHeat << std::endl;
  os << indent << "HistogramSteps: " << m_HistogramSteps.size() << std::endl;
  os << indent << "SnapshotSteps: " << m_SnapshotSteps.size() << std::endl;
}
} // namespace itk

#endif
