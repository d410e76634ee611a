#include "shapetonHeatObjectsImageFilter.h"

#include "shapetonFilterProgress.h"

namespace shapeton
{
std::vector<const HeatObjectsImageFilter::InputImageType *>
HeatObjectsImageFilter::Heats() const
{
  std::vector<const InputImageType *> heats;
  for (unsigned int i = 0; i < this->GetNumberOfIndexedInputs(); ++i)
  {
    heats.push_back(this->GetInput(i));
  }
  return heats;
}

itk::Image<unsigned char, 3>::Pointer
HeatObjectsImageFilter::GetMask(int object) const
{
  return MaskOfObject(m_Objects, object, this->Heats());
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
  HeatObjectList list =
    FindHeatObjects(this->Heats(), m_Options, Progress([this](double share) { ReportProgress(*this, share); }));
  this->GraftOutput(list.labels);
  m_Objects = std::move(list.objects);
}
} // namespace shapeton
