#include "shapetonColonLandmarksFilter.h"

namespace shapeton
{
ColonLandmarksFilter::ColonLandmarksFilter()
{
  this->SetPrimaryInputName("FlatColon");
  this->AddRequiredInputName("Centerline");
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->SetNthOutput(1, this->MakeOutput(1));
}

itk::DataObject::Pointer
ColonLandmarksFilter::MakeOutput(DataObjectPointerArraySizeType index)
{
  return index == 1 ? itk::DataObject::Pointer(ResultObject<CurveSet>::New())
                    : itk::DataObject::Pointer(ResultObject<ColonLandmarks>::New());
}

ResultObject<ColonLandmarks> *
ColonLandmarksFilter::GetOutput()
{
  return static_cast<ResultObject<ColonLandmarks> *>(this->itk::ProcessObject::GetOutput(0));
}

ResultObject<CurveSet> *
ColonLandmarksFilter::GetTaeniaeOutput()
{
  return static_cast<ResultObject<CurveSet> *>(this->itk::ProcessObject::GetOutput(1));
}

void
ColonLandmarksFilter::Compute()
{
  ColonLandmarkOptions options = m_Options;
  options.progress = this->Reporter();
  ColonLandmarks landmarks = FindColonLandmarks(this->GetFlatColon()->Get(), this->GetCenterline()->Get(), options);
  this->SetResult(1, landmarks.taeniae.taeniae.empty() ? CurveSet() : TaeniaCurves(landmarks.taeniae));
  this->SetResult(0, std::move(landmarks));
}

void
ColonLandmarksFilter::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FlexureRule: " << (m_Options.flexureRule == shapeton::FlexureRule::Ordered ? "Ordered" : "Published")
     << std::endl;
  os << indent << "TaeniaRule: " << NameOf(m_Options.taeniaRule) << std::endl;
  os << indent << "Markers: " << m_Options.markers.size() << std::endl;
}
} // namespace shapeton
