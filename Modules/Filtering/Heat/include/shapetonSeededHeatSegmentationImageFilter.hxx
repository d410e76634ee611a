#ifndef shapetonSeededHeatSegmentationImageFilter_hxx
#define shapetonSeededHeatSegmentationImageFilter_hxx

#include "shapetonSeededHeatSegmentationImageFilter.h"
#include "shapetonFilterProgress.h"
#include "shapetonMappedImage.h"

#include <algorithm>
#include <tuple>

namespace shapeton
{
template <typename TInputImage>
SeededHeatSegmentationImageFilter<TInputImage>::SeededHeatSegmentationImageFilter()
{
  this->AddRequiredInputName("Seeds");
  this->AddOptionalInputName("LabelsBefore");
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(1, HeatImageType::New());
}

template <typename TInputImage>
itk::DataObject::Pointer
SeededHeatSegmentationImageFilter<TInputImage>::MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType index)
{
  return index == 1 ? itk::DataObject::Pointer(HeatImageType::New()) : Superclass::MakeOutput(index);
}

template <typename TInputImage>
bool
SeededHeatSegmentationImageFilter<TInputImage>::Origin::operator==(const Origin & other) const
{
  const auto all = [](const Origin & o) {
    return std::make_tuple(o.pixels,
                           o.time,
                           o.timeOfDomain,
                           o.options.p,
                           o.options.intensityWindow,
                           o.options.smoothing,
                           o.options.leastWeight,
                           o.options.tolerance,
                           o.options.keepProbabilities);
  };
  return all(*this) == all(other);
}

/** Rebuilds operator and solver unless input and parameters are unchanged. */
template <typename TInputImage>
void
SeededHeatSegmentationImageFilter<TInputImage>::PrepareSolver()
{
  const TInputImage * const input = this->GetInput();
  const VolumeView          volume = this->GetVolume();
  const auto * const        domain = this->GetDomain();
  const Origin              origin{
    input->GetBufferPointer(), input->GetMTime(), domain ? domain->GetMTime() : 0, this->OptionsFor(volume)
  };
  if (m_Solver && m_Origin && *m_Origin == origin)
  {
    return;
  }
  m_Solver.reset();
  m_RemarksOnWindow = RemarksOnWindow(volume, origin.options.intensityWindow.value());
  m_Operator = std::make_unique<const VolumeGradientOperator>(
    volume, origin.options, VolumeGradientOperator::Conductance::Physical, origin.options.leastWeight, [this](double) {
      ReportProgress(*this, 0.0);
    });
  m_Solver = std::make_unique<SeededHeatSolver>(*m_Operator, origin.options);
  m_Origin = origin;
}

template <typename TInputImage>
void
SeededHeatSegmentationImageFilter<TInputImage>::GenerateData()
{
  this->AllocateOutputs();
  const LabelImageType * const seeds = this->GetSeeds();
  const LabelImageType * const before = this->GetLabelsBefore();
  RequirePixels(seeds, "the label map of seeds");
  if (before)
  {
    RequirePixels(before, "the label map before");
  }
  m_LabelValues.clear(); // nothing of the last run remains after an error
  m_Grid = nullptr;
  this->PrepareSolver();
  const SeededHeatResult & result = m_Solver->Solve(
    seeds->GetBufferPointer(),
    [this](double share) { ReportProgress(*this, share); },
    before ? before->GetBufferPointer() : nullptr);
  std::copy(result.labels.begin(), result.labels.end(), this->GetOutput()->GetBufferPointer());
  std::copy(result.uncertainty.begin(), result.uncertainty.end(), this->GetUncertaintyOutput()->GetBufferPointer());
  m_Grid = HeatImageType::New();
  m_Grid->CopyInformation(this->GetOutput());
  m_Grid->SetRegions(this->GetOutput()->GetBufferedRegion());
  m_LabelValues = result.labelValues;
  m_Iterations = result.iterations;
  m_Remarks = m_RemarksOnWindow;
  AppendRemarks(m_Remarks, result.remarks);
  if (!this->GetKeepProbabilities())
  {
    m_Solver.reset();
    m_Operator.reset();
  }
}

template <typename TInputImage>
typename SeededHeatSegmentationImageFilter<TInputImage>::HeatImageType::Pointer
SeededHeatSegmentationImageFilter<TInputImage>::GetProbabilities(unsigned short label) const
{
  RequireParameter(m_Solver && m_Grid, "the probabilities were not kept; set KeepProbabilities and update the filter");
  auto image = NewImageOn<HeatImageType>(m_Grid);
  m_Solver->GetProbabilities(label, image->GetBufferPointer());
  return image;
}

template <typename TInputImage>
void
SeededHeatSegmentationImageFilter<TInputImage>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Iterations: " << m_Iterations << std::endl;
}
} // namespace shapeton

#endif
