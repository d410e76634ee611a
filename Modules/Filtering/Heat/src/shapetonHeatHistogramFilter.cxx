#include "shapetonHeatHistogramFilter.h"

#include "shapetonFilterProgress.h"

#include <algorithm>

namespace shapeton
{
HeatHistogramFilter::HeatHistogramFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

HeatHistogramFilter::~HeatHistogramFilter() = default;

itk::DataObject::Pointer
HeatHistogramFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

void
HeatHistogramFilter::AddHeat(const HeatImageType * heat, std::uint64_t timeStep)
{
  if (!heat)
  {
    itkExceptionMacro("the heat of time step " << timeStep << " is missing");
  }
  if (!m_TimeSteps.empty() && timeStep < m_TimeSteps.back())
  {
    itkExceptionMacro("time step " << timeStep << " comes after " << m_TimeSteps.back()
                                   << "; add heats in ascending order");
  }
  this->SetNthInput(m_TimeSteps.size(), const_cast<HeatImageType *>(heat));
  m_TimeSteps.push_back(timeStep);
}

const HeatHistogramFilter::OutputType *
HeatHistogramFilter::GetOutput() const
{
  return static_cast<const OutputType *>(this->ProcessObject::GetOutput(0));
}

void
HeatHistogramFilter::GenerateData()
{
  HeatHistogram histogram(m_TimeSteps);
  for (std::size_t row = 0; row < m_TimeSteps.size(); ++row)
  {
    const auto * const heat = static_cast<const HeatImageType *>(this->GetInput(row));
    histogram.AddToRow(row, heat->GetBufferPointer(), heat->GetBufferedRegion().GetNumberOfPixels());
    ReportProgress(*this, (row + 1.0) / m_TimeSteps.size());
  }
  static_cast<OutputType *>(this->ProcessObject::GetOutput(0))->Set(histogram);
}

void
HeatHistogramFilter::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "TimeSteps: " << m_TimeSteps.size() << std::endl;
}
} // namespace shapeton
