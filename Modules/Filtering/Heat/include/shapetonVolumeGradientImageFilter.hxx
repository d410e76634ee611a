#ifndef shapetonVolumeGradientImageFilter_hxx
#define shapetonVolumeGradientImageFilter_hxx

#include "shapetonVolumeGradientImageFilter.h"

namespace shapeton
{
template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  RequireWindow(this->GetIntensityWindow());
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::VerifyInputInformation() const
{
  for (const auto & name : this->GetInputNames())
  {
    const auto * const other = dynamic_cast<const itk::ImageBase<3> *>(this->ProcessObject::GetInput(name));
    if (other && !HaveSameGrid(this->GetInput(), other))
    {
      throw InputError("a mask or label map has another grid than the volume; resample it to the grid of the volume");
    }
  }
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  RequestWholeInputs(*this);
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::EnlargeOutputRequestedRegion(itk::DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
TOptions
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::OptionsFor(const VolumeView & volume)
{
  m_Window = WindowOf(this->m_Options, volume);
  TOptions options = this->m_Options;
  options.intensityWindow = m_Window;
  return options;
}

template <typename TInputImage, typename TOutputImage, typename TOptions>
void
VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "WindowLower: " << m_Window[0] << std::endl;
  os << indent << "WindowUpper: " << m_Window[1] << std::endl;
}
} // namespace shapeton

#endif
