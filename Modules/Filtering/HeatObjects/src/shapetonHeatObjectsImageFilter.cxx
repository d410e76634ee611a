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
  for (unsigned int i = 0; i < this->GetNumberOfIndexedInputs(); ++i)
  {
    const_cast<InputImageType *>(this->GetInput(i))->SetRequestedRegionToLargestPossibleRegion();
  }
}

void
HeatObjectsImageFilter::EnlargeOutputRequestedRegion(itk::DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

void
HeatObjectsImageFilter::GenerateData()
{
  std::vector<const InputImageType *> heats;
  for (unsigned int i = 0; i < this->GetNumberOfIndexedInputs(); ++i)
  {
    heats.push_back(this->GetInput(i));
  }
  m_List = FindHeatObjects(heats, m_Options, Progress([this](double share) { ReportProgress(*this, share); }));
  this->GraftOutput(m_List.labels);
}
} // namespace shapeton
