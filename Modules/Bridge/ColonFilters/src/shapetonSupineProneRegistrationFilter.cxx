#include "shapetonSupineProneRegistrationFilter.h"

namespace shapeton
{
SupineProneRegistrationFilter::SupineProneRegistrationFilter()
{
  this->SetPrimaryInputName("Source");
  this->AddRequiredInputName("Target");
  this->SetNumberOfRequiredInputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

itk::DataObject::Pointer
SupineProneRegistrationFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return ResultObject<SupineProneRegistration>::New().GetPointer();
}

ResultObject<SupineProneRegistration> *
SupineProneRegistrationFilter::GetOutput()
{
  return static_cast<ResultObject<SupineProneRegistration> *>(this->itk::ProcessObject::GetOutput(0));
}

void
SupineProneRegistrationFilter::Compute()
{
  SupineProneOptions options = m_Options;
  options.progress = this->Reporter();
  this->SetResult(0, RegisterColonPositions(this->GetSource()->Get(), this->GetTarget()->Get(), options));
}

void
SupineProneRegistrationFilter::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Map: " << (m_Options.map == SupineProneMap::Default ? "Default" : "Published") << std::endl;
  os << indent
     << "Matching: " << (m_Options.matching == FoldMatchingMethod::Hungarian ? "Hungarian" : "DualDecomposition")
     << std::endl;
  os << indent << "SegmentWise: " << m_Options.isSegmentWise << std::endl;
  os << indent << "Refine: " << m_Options.refines << std::endl;
  os << indent << "GreatestDilatation: " << m_Options.greatestDilatation << std::endl;
}
} // namespace shapeton
