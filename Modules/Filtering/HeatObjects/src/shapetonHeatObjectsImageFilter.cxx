#include "shapetonHeatObjectsImageFilter.h"

#include "shapetonFilterProgress.h"

namespace shapeton
{
itk::Image<unsigned char, 3>::Pointer
HeatObjectsImageFilter::GetMask(int object) const
{
  return MaskOfObject(m_List, object);
}

void
HeatObjectsImageFilter::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  const_cast<InputImageType *>(this->GetInput())->SetRequestedRegionToLargestPossibleRegion();
}

void
HeatObjectsImageFilter::EnlargeOutputRequestedRegion(itk::DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

void
HeatObjectsImageFilter::GenerateData()
{
  m_List =
    FindHeatObjects(this->GetInput(), m_Options, Progress([this](double share) { ReportProgress(*this, share); }));
  this->GraftOutput(m_List.labels);
}
} // namespace shapeton
