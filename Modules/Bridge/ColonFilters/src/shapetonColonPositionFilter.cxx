#include "shapetonColonPositionFilter.h"

namespace shapeton
{
ColonPositionFilter::ColonPositionFilter()
{
  this->SetPrimaryInputName("FlatColon");
  this->AddRequiredInputName("Centerline");
  this->AddRequiredInputName("Landmarks");
  this->AddRequiredInputName("Folds");
  this->SetNumberOfRequiredInputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

itk::DataObject::Pointer
ColonPositionFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return ResultObject<ColonPosition>::New().GetPointer();
}

ResultObject<ColonPosition> *
ColonPositionFilter::GetOutput()
{
  return static_cast<ResultObject<ColonPosition> *>(this->itk::ProcessObject::GetOutput(0));
}

void
ColonPositionFilter::Compute()
{
  this->SetResult(0,
                  MakeColonPosition(m_PositionName,
                                    this->GetFlatColon()->Share(),
                                    this->GetCenterline()->Get(),
                                    this->GetLandmarks()->Get(),
                                    this->GetFolds()->Get().folds));
}

void
ColonPositionFilter::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "PositionName: " << m_PositionName << std::endl;
}
} // namespace shapeton
