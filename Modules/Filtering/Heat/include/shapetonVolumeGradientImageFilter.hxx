#ifndef shapetonVolumeGradientImageFilter_hxx
#define shapetonVolumeGradientImageFilter_hxx

#include "shapetonVolumeGradientImageFilter.h"

#include <algorithm>
#include <type_traits>

namespace shapeton
{
template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const auto & window = this->GetIntensityWindow();
  RequireParameter(!window || (*window)[0] < (*window)[1],
                   "the parameter \"intensityWindow\" requires two numbers, the lower one first");
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::GenerateInputRequestedRegion()
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

template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::EnlargeOutputRequestedRegion(itk::DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
std::array<std::size_t, 3>
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::GetVolumeSize() const
{
  std::array<std::size_t, 3> size{};
  std::copy_n(this->GetInput()->GetBufferedRegion().GetSize().begin(), 3, size.begin());
  return size;
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
const float *
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::GetIntensities(std::vector<float> & converted) const
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

template <typename TInputImage, typename TOutputImage, typename TOptions>
VolumeGradientOperator::Parameters
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::MakeOperatorParameters(const float * intensities)
{
  const auto window = WindowOf(this->m_Options, intensities, this->GetInput()->GetBufferedRegion().GetNumberOfPixels());
  m_WindowLower = window[0];
  m_WindowUpper = window[1];
  VolumeGradientOperator::Parameters parameters;
  parameters.p = this->GetP();
  parameters.lower = m_WindowLower;
  parameters.upper = m_WindowUpper;
  std::copy_n(this->GetInput()->GetSpacing().Begin(), 3, parameters.spacing.begin());
  return parameters;
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "WindowLower: " << m_WindowLower << std::endl;
  os << indent << "WindowUpper: " << m_WindowUpper << std::endl;
}
} // namespace shapeton

#endif
