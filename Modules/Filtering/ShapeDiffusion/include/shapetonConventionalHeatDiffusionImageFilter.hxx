#ifndef shapetonConventionalHeatDiffusionImageFilter_hxx
#define shapetonConventionalHeatDiffusionImageFilter_hxx

#include "shapetonConventionalHeatDiffusionImageFilter.h"

#include <stdexcept>
#include <vector>

namespace shapeton
{
template <typename TInputImage>
void
ConventionalHeatDiffusionImageFilter<TInputImage>::GenerateData()
{
  this->AllocateOutputs();
  std::vector<float>  converted;
  const float * const intensities = this->GetIntensities(converted);
  try
  {
    const VolumeGradientOperator volumeGradient(
      intensities, this->GetVolumeSize(), this->MakeOperatorParameters(intensities));
    DiffuseConventionalHeat(volumeGradient,
                            m_TimeStepLength,
                            this->GetTimeSteps(),
                            m_SourceHeat,
                            this->GetOutput()->GetBufferPointer(),
                            [this](double share) { this->ReportProgress(share); });
  }
  catch (const std::logic_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
}

template <typename TInputImage>
void
ConventionalHeatDiffusionImageFilter<TInputImage>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "TimeStepLength: " << m_TimeStepLength << std::endl;
  os << indent << "SourceHeat: " << m_SourceHeat << std::endl;
}
} // namespace shapeton

#endif
