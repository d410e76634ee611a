#include "shapetonHaustralFoldsFilter.h"

#include "shapetonFlatCoordinateMap.h"

namespace shapeton
{
HaustralFoldsFilter::HaustralFoldsFilter()
{
  this->SetPrimaryInputName("FlatColon");
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(1, this->MakeOutput(1));
}

itk::DataObject::Pointer
HaustralFoldsFilter::MakeOutput(DataObjectPointerArraySizeType index)
{
  return index == 1 ? itk::DataObject::Pointer(ResultObject<HaustralFolds>::New()) : Superclass::MakeOutput(index);
}

ResultObject<HaustralFolds> *
HaustralFoldsFilter::GetFoldsOutput()
{
  return static_cast<ResultObject<HaustralFolds> *>(this->itk::ProcessObject::GetOutput(1));
}

void
HaustralFoldsFilter::GenerateOutputInformation()
{
  const_cast<ResultObject<FlatColon> *>(this->GetFlatColon())->Update();
  SetFlatSpace(this->GetFlatColon()->Get().Grid(), this->GetOutput());
}

void
HaustralFoldsFilter::Compute()
{
  HaustralFoldOptions options = m_Options;
  options.progress = this->Reporter().Part("Folds", 0.0, 1.0);
  options.taeniae = this->GetTaeniae() ? &this->GetTaeniae()->Get() : nullptr;
  HaustralFolds folds = FindHaustralFolds(this->GetFlatColon()->Get(), options);
  HandOver(folds.labels.GetPointer(), this->GetOutput());
  this->SetResult(1, std::move(folds));
}

void
HaustralFoldsFilter::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << (m_Options.scheme == HaustralFoldScheme::GraphCut ? "GraphCut" : "Published")
     << std::endl;
  os << indent << "MinimumLength: " << m_Options.minimumLength << std::endl;
  os << indent << "MinimumArea: " << m_Options.minimumArea << std::endl;
  os << indent << "MinimumElongation: " << m_Options.minimumElongation << std::endl;
  os << indent << "MinimumAngle: " << m_Options.minimumAngle << std::endl;
  os << indent << "SmoothingTime: " << m_Options.smoothingTime << std::endl;
  os << indent << "Smoothness: " << m_Options.smoothness << std::endl;
  os << indent << "Contrast: " << m_Options.contrast << std::endl;
  os << indent << "PublishedLow: " << m_Options.publishedLow << std::endl;
  os << indent << "PublishedHigh: " << m_Options.publishedHigh << std::endl;
}
} // namespace shapeton
