#ifndef itkConventionalHeatDiffusionImageFilter_hxx
#define itkConventionalHeatDiffusionImageFilter_hxx

#include "itkConventionalHeatDiffusionImageFilter.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace itk
{
template <typename TInputImage>
void
ConventionalHeatDiffusionImageFilter<TInputImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  if (auto * const input = const_cast<TInputImage *>(this->GetInput()))
  {
    input->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TInputImage>
void
ConventionalHeatDiffusionImageFilter<TInputImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TInputImage>
void
ConventionalHeatDiffusionImageFilter<TInputImage>::GenerateData()
{
  const TInputImage * const input = this->GetInput();
  const auto                region = input->GetBufferedRegion();
  const std::vector<float>  intensities(input->GetBufferPointer(),
                                       input->GetBufferPointer() + region.GetNumberOfPixels());
  this->AllocateOutputs();
  std::array<std::size_t, 3> size{};
  std::copy_n(region.GetSize().begin(), 3, size.begin());

  VolumeGradientOperator::Parameters parameters;
  parameters.p = m_P;
  const auto ends = std::minmax_element(intensities.begin(), intensities.end());
  parameters.lower = *ends.first;
  parameters.upper = *ends.second;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    parameters.spacing[axis] = input->GetSpacing()[axis];
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
    const VolumeGradientOperator volumeGradient(intensities.data(), size, parameters);
    DiffuseConventionalHeat(
      volumeGradient, m_TimeStepLength, m_TimeSteps, m_SourceHeat, this->GetOutput()->GetBufferPointer(), progress);
  }
  catch (const std::logic_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
}

template <typename TInputImage>
void
ConventionalHeatDiffusionImageFilter<TInputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "P: " << m_P << std::endl;
  os << indent << "TimeSteps: " << m_TimeSteps << std::endl;
  os << indent << "TimeStepLength: " << m_TimeStepLength << std::endl;
  os << indent << "SourceHeat: " << m_SourceHeat << std::endl;
}
} // namespace itk

#endif
