#include "shapetonColonCentrelineFilter.h"

#include "shapetonExceptions.h"

namespace shapeton
{
ColonCentrelineFilter::ColonCentrelineFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->SetNthOutput(1, this->MakeOutput(1));
}

itk::DataObject::Pointer
ColonCentrelineFilter::MakeOutput(DataObjectPointerArraySizeType index)
{
  return index == 1 ? itk::DataObject::Pointer(ResultObject<ColonCentreline>::New())
                    : itk::DataObject::Pointer(ResultObject<CurveSet>::New());
}

void
ColonCentrelineFilter::SetInput(const LumenMask * labels)
{
  this->SetNthInput(0, const_cast<LumenMask *>(labels));
}

const LumenMask *
ColonCentrelineFilter::GetInput() const
{
  return static_cast<const LumenMask *>(this->itk::ProcessObject::GetInput(0));
}

ResultObject<CurveSet> *
ColonCentrelineFilter::GetOutput()
{
  return static_cast<ResultObject<CurveSet> *>(this->itk::ProcessObject::GetOutput(0));
}

ResultObject<ColonCentreline> *
ColonCentrelineFilter::GetCentrelineOutput()
{
  return static_cast<ResultObject<ColonCentreline> *>(this->itk::ProcessObject::GetOutput(1));
}

void
ColonCentrelineFilter::Compute()
{
  ColonCentrelineOptions options = m_Options;
  options.progress = this->Reporter();
  ColonCentreline centreline = TraceColonCentreline(FromIndexZero(this->GetInput()), options);
  if (!centreline.failure.empty())
  {
    throw InputError(centreline.failure);
  }
  this->SetResult(0, CurveSet(centreline.curve));
  this->SetResult(1, std::move(centreline));
}

void
ColonCentrelineFilter::PrintSelf(std::ostream & os, itk::Indent indent) const
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
