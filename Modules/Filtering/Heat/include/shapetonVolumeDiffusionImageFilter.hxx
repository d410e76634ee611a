#ifndef shapetonVolumeDiffusionImageFilter_hxx
#define shapetonVolumeDiffusionImageFilter_hxx

#include "shapetonVolumeDiffusionImageFilter.h"

namespace shapeton
{
template <typename TInputImage, typename TOutputImage>
void
VolumeDiffusionImageFilter<TInputImage, TOutputImage>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  if (m_TimeSteps < 1)
  {
    itkExceptionMacro("TimeSteps must be at least 1");
  }
}

template <typename TInputImage, typename TOutputImage>
void
VolumeDiffusionImageFilter<TInputImage, TOutputImage>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "TimeSteps: " << m_TimeSteps << std::endl;
  os << indent << "Device: " << NameOf(m_Device) << std::endl;
}
} // namespace shapeton

#endif
