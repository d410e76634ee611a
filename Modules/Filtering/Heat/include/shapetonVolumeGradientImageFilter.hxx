#ifndef shapetonVolumeGradientImageFilter_hxx
#define shapetonVolumeGradientImageFilter_hxx

#include "shapetonVolumeGradientImageFilter.h"

#include <algorithm>
#include <type_traits>

namespace shapeton
{
template <typename TInputImage, typename TOutputImage>
void
VolumeGradientImageFilter<TInputImage, TOutputImage>::SetIntensityWindow(double lower, double upper)
{
  if (m_HasWindow && m_WindowLower == lower && m_WindowUpper == upper)
  {
    return;
  }
  m_HasWindow = true;
  m_WindowLower = lower;
  m_WindowUpper = upper;
  this->Modified();
}

template <typename TInputImage, typename TOutputImage>
void
VolumeGradientImageFilter<TInputImage, TOutputImage>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  if (!(m_P >= 0.0))
  {
    itkExceptionMacro("P must not be negative, got " << m_P);
  }
  if (m_HasWindow && !(m_WindowLower < m_WindowUpper))
  {
    itkExceptionMacro("the intensity window [" << m_WindowLower << ", " << m_WindowUpper << "] is empty or reversed");
  }
}

template <typename TInputImage, typename TOutputImage>
void
VolumeGradientImageFilter<TInputImage, TOutputImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  for (const auto & name : this->GetInputNames())
  {
    if (auto * const input = this->ProcessObject::GetInput(name))
    {
      input->SetRequestedRegionToLargestPossibleRegion();
    }
  }
}

template <typename TInputImage, typename TOutputImage>
void
VolumeGradientImageFilter<TInputImage, TOutputImage>::EnlargeOutputRequestedRegion(itk::DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TInputImage, typename TOutputImage>
std::array<std::size_t, 3>
VolumeGradientImageFilter<TInputImage, TOutputImage>::GetVolumeSize() const
{
  std::array<std::size_t, 3> size{};
  std::copy_n(this->GetInput()->GetBufferedRegion().GetSize().begin(), 3, size.begin());
  return size;
}

template <typename TInputImage, typename TOutputImage>
const float *
VolumeGradientImageFilter<TInputImage, TOutputImage>::GetIntensities(std::vector<float> & converted) const
{
  const auto * const pixels = this->GetInput()->GetBufferPointer();
  if constexpr (std::is_same_v<typename TInputImage::PixelType, float>)
  {
    return pixels;
  }
  else
  {
    converted.assign(pixels, pixels + this->GetInput()->GetBufferedRegion().GetNumberOfPixels());
    return converted.data();
  }
}

template <typename TInputImage, typename TOutputImage>
VolumeGradientOperator::Parameters
VolumeGradientImageFilter<TInputImage, TOutputImage>::MakeOperatorParameters(const float * intensities)
{
  const std::size_t number = this->GetInput()->GetBufferedRegion().GetNumberOfPixels();
  if (!m_HasWindow && number > 0)
  {
    const auto ends = std::minmax_element(intensities, intensities + number);
    m_WindowLower = *ends.first;
    m_WindowUpper = *ends.second;
  }
  VolumeGradientOperator::Parameters parameters;
  parameters.p = m_P;
  parameters.lower = m_WindowLower;
  parameters.upper = m_WindowUpper;
  std::copy_n(this->GetInput()->GetSpacing().Begin(), 3, parameters.spacing.begin());
  return parameters;
}

template <typename TInputImage, typename TOutputImage>
void
VolumeGradientImageFilter<TInputImage, TOutputImage>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "P: " << m_P << std::endl;
  os << indent << "HasWindow: " << m_HasWindow << std::endl;
  os << indent << "WindowLower: " << m_WindowLower << std::endl;
  os << indent << "WindowUpper: " << m_WindowUpper << std::endl;
}
} // namespace shapeton

#endif
