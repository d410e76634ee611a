#include "shapetonColonCenterlineFilter.h"

#include "shapetonExceptions.h"

namespace shapeton
{
ColonCenterlineFilter::ColonCenterlineFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->SetNthOutput(1, this->MakeOutput(1));
}

itk::DataObject::Pointer
ColonCenterlineFilter::MakeOutput(DataObjectPointerArraySizeType index)
{
  return index == 1 ? itk::DataObject::Pointer(ResultObject<ColonCenterline>::New())
                    : itk::DataObject::Pointer(ResultObject<CurveSet>::New());
}

void
ColonCenterlineFilter::SetInput(const LumenMask * labels)
{
  this->SetNthInput(0, const_cast<LumenMask *>(labels));
}

const LumenMask *
ColonCenterlineFilter::GetInput() const
{
  return static_cast<const LumenMask *>(this->itk::ProcessObject::GetInput(0));
}

ResultObject<CurveSet> *
ColonCenterlineFilter::GetOutput()
{
  return static_cast<ResultObject<CurveSet> *>(this->itk::ProcessObject::GetOutput(0));
}

ResultObject<ColonCenterline> *
ColonCenterlineFilter::GetCenterlineOutput()
{
  return static_cast<ResultObject<ColonCenterline> *>(this->itk::ProcessObject::GetOutput(1));
}

void
ColonCenterlineFilter::Compute()
{
  ColonCenterlineOptions options = m_Options;
  options.progress = this->Reporter();
  ColonCenterline centerline = TraceColonCenterline(FromIndexZero(this->GetInput()), options);
  if (!centerline.failure.empty())
  {
    throw InputError(centerline.failure);
  }
  this->SetResult(0, CurveSet(centerline.curve));
  this->SetResult(1, std::move(centerline));
}

void
ColonCenterlineFilter::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Exponent: " << m_Options.exponent << std::endl;
  os << indent << "Start: ";
  m_Options.start ? os << *m_Options.start << std::endl : os << "(found in the lumen)" << std::endl;
  os << indent << "SeedPoints: " << m_Options.seedPoints.size() << std::endl;
  os << indent << "MinimumVolume: " << m_Options.minimumVolume << std::endl;
  os << indent << "MinimumExtent: " << m_Options.minimumExtent << std::endl;
  os << indent << "Step: " << m_Options.step << std::endl;
  os << indent << "Smoothing: " << m_Options.smoothing << std::endl;
  os << indent << "GapRadius: " << m_Options.gapRadius << std::endl;
}
} // namespace shapeton
