#ifndef shapetonCumulativeHeatDiffusionImageFilter_hxx
#define shapetonCumulativeHeatDiffusionImageFilter_hxx

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonFilterProgress.h"

#include <utility>

namespace shapeton
{
template <typename TInputImage>
CumulativeHeatDiffusionImageFilter<TInputImage>::CumulativeHeatDiffusionImageFilter()
{
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(1, HeatImageType::New());
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::SetSnapshotSteps(const StepsType &        steps,
                                                                  const SnapshotConsumer & consumer)
{
  this->m_Options.snapshotSteps = steps;
  m_SnapshotConsumer = consumer;
  this->Modified();
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::UseParameters(const HeatParameterChoice & choice)
{
  choice.ApplyTo(this->m_Options);
  this->Modified();
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::HandOut(std::uint64_t step, const std::vector<float> & values) const
{
  auto snapshot = HeatImageType::New();
  snapshot->CopyInformation(this->GetOutput());
  snapshot->SetRegions(this->GetOutput()->GetLargestPossibleRegion());
  snapshot->GetPixelContainer()->SetImportPointer(const_cast<float *>(values.data()), values.size(), false);
  m_SnapshotConsumer(step, snapshot);
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::GenerateData()
{
  HeatImageType * const heat = this->GetOutput();
  heat->SetBufferedRegion(heat->GetLargestPossibleRegion());
  heat->Allocate();
  HeatImageType * const initialHeat = this->GetInitialHeatOutput();
  if (m_WantInitialHeat)
  {
    initialHeat->SetBufferedRegion(initialHeat->GetLargestPossibleRegion());
    initialHeat->Allocate();
  }
  else
  {
    initialHeat->Initialize(); // clears the previous result
  }
  VolumeView volume = this->GetVolume();
  const auto settings = this->OptionsFor(volume);
  m_Result = DiffuseCumulativeHeat(
    std::move(volume),
    settings,
    heat->GetBufferPointer(),
    m_WantInitialHeat ? initialHeat->GetBufferPointer() : nullptr,
    m_SnapshotConsumer ? [this](std::uint64_t step, const std::vector<float> & values) { this->HandOut(step, values); }
                       : HeatSnapshotConsumer(),
    [this](double share) { ReportProgress(*this, share); });
}

template <typename TInputImage>
void
CumulativeHeatDiffusionImageFilter<TInputImage>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "WantComponents: " << this->m_Options.wantComponents << std::endl;
  os << indent << "HistogramSteps: " << this->m_Options.histogramSteps.size() << std::endl;
  os << indent << "WantInitialHeat: " << m_WantInitialHeat << std::endl;
  os << indent << "SnapshotSteps: " << this->m_Options.snapshotSteps.size() << std::endl;
}
} // namespace shapeton

#endif
