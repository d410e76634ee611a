#include "shapetonHeatObjectsImageFilter.h"

#include "shapetonFilterProgress.h"
#include "shapetonInterruption.h"

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
  RequestWholeInputs(*this);
}

void
HeatObjectsImageFilter::EnlargeOutputRequestedRegion(itk::DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

void
HeatObjectsImageFilter::GenerateData()
{
  m_List = {};
  const Interruption interruption([this] { AbortIfAsked(*this); });
  const Progress     progress([this](double share) { ReportProgress(*this, share); });
  m_List = HeatObjectTree(this->GetInput(), m_Options, this->GetDomain(), progress).List();
  this->GraftOutput(m_List.labels);
  progress("Finding objects", 1.0);
}
} // namespace shapeton
