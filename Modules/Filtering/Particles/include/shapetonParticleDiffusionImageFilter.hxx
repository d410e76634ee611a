#ifndef shapetonParticleDiffusionImageFilter_hxx
#define shapetonParticleDiffusionImageFilter_hxx

#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonFilterProgress.h"
#include "shapetonVisitDensity.h"

#include <algorithm>
#include <utility>

namespace shapeton
{
template <typename TInputImage>
ParticleDiffusionImageFilter<TInputImage>::ParticleDiffusionImageFilter()
{
  this->SetNumberOfRequiredInputs(1);
}

template <typename TInputImage>
void
ParticleDiffusionImageFilter<TInputImage>::SetHistogramSteps(const StepsType & steps)
{
  m_HistogramSteps = steps;
  this->Modified();
}

template <typename TInputImage>
void
ParticleDiffusionImageFilter<TInputImage>::SetInitialState(ParticleState state)
{
  m_InitialState = std::make_shared<ParticleState>(std::move(state));
  this->Modified();
}

template <typename TInputImage>
ParticleState
ParticleDiffusionImageFilter<TInputImage>::GetState() const
{
  return m_Diffusion ? m_Diffusion->GetState() : m_FinalState;
}

template <typename TInputImage>
void
ParticleDiffusionImageFilter<TInputImage>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const bool ascend = std::adjacent_find(m_HistogramSteps.begin(), m_HistogramSteps.end(), std::greater_equal<>()) ==
                      m_HistogramSteps.end();
  RequireParameter(ascend && (m_HistogramSteps.empty() ||
                              (m_HistogramSteps.front() >= 1 && m_HistogramSteps.back() <= this->GetTimeSteps())),
                   "the histogram steps must be ascending and between 1 and the parameter \"timeSteps\"");
  RequireParameter(!m_InitialState || m_InitialState->step <= this->GetTimeSteps(),
                   "the initial state is of step " + std::to_string(m_InitialState ? m_InitialState->step : 0) +
                     ", beyond the parameter \"timeSteps\" = " + std::to_string(this->GetTimeSteps()));
}

template <typename TInputImage>
void
ParticleDiffusionImageFilter<TInputImage>::PlaceShapetons()
{
  const MaskImageType * const mask = this->GetMaskImage();
  const VolumeView            volume(this->GetInput());
  if (mask)
  {
    RequirePixels(mask, "the mask");
  }
  m_Diffusion = std::make_unique<ParticleDiffusion>(volume,
                                                    this->OptionsFor(volume),
                                                    mask ? mask->GetBufferPointer() : nullptr,
                                                    this->GetOutput()->GetBufferPointer(),
                                                    [this] { RepeatProgress(*this); });
  m_DeviceUse = m_Diffusion->GetDeviceUse();
  if (m_InitialState)
  {
    m_Diffusion->SetState(*m_InitialState);
  }
}

template <typename TInputImage>
void
ParticleDiffusionImageFilter<TInputImage>::TakeSteps()
{
  const std::optional<SteadyRule> rule =
    this->GetUntilSteady()
      ? std::optional<SteadyRule>({ this->GetEpsilon().value_or(0.0), !this->GetEpsilon().has_value() })
      : std::nullopt;
  const auto observer = [this](const ParticleMeasures & measures) {
    m_Measures = measures;
    this->InvokeEvent(itk::IterationEvent());
    ReportProgress(*this, static_cast<double>(measures.step) / static_cast<double>(this->GetTimeSteps()));
  };
  const std::uint64_t first = m_Diffusion->GetMeasures().step;
  StepsType           rows;
  std::copy_if(m_HistogramSteps.begin(), m_HistogramSteps.end(), std::back_inserter(rows), [first](std::uint64_t step) {
    return step > first;
  });
  m_Histogram = HeatHistogram(rows);
  std::size_t reached = 0;
  for (; reached < rows.size(); ++reached)
  {
    m_Diffusion->Run(rows[reached], rule, observer);
    if (m_Diffusion->GetMeasures().step < rows[reached])
    {
      break; // steady
    }
    AddVisitsToRow(this->GetOutput(), reached, m_Histogram);
  }
  if (reached == rows.size())
  {
    m_Diffusion->Run(this->GetTimeSteps(), rule, observer);
  }
  m_Measures = m_Diffusion->GetMeasures();
  if (reached < rows.size())
  {
    rows.resize(reached);
    HeatHistogram cut(rows);
    for (std::size_t row = 0; row < reached; ++row)
    {
      cut.AddToRow(row, m_Histogram.GetRow(row));
    }
    m_Histogram = cut;
  }
}

template <typename TInputImage>
void
ParticleDiffusionImageFilter<TInputImage>::GenerateData()
{
  VisitsImageType * const visits = this->GetOutput();
  visits->SetBufferedRegion(visits->GetLargestPossibleRegion());
  visits->Allocate();
  m_Measures = ParticleMeasures();
  m_FinalState = ParticleState();
  const struct Release // also if the run is aborted, because the weights of the volume are large
  {
    ~Release() { diffusion.reset(); }
    std::unique_ptr<ParticleDiffusion> & diffusion;
  } release{ m_Diffusion };
  this->PlaceShapetons();
  this->TakeSteps();
  if (m_WantState)
  {
    m_FinalState = m_Diffusion->GetState();
  }
}

template <typename TInputImage>
void
ParticleDiffusionImageFilter<TInputImage>::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "HistogramSteps: " << m_HistogramSteps.size() << std::endl;
  os << indent << "WantState: " << m_WantState << std::endl;
  os << indent << "HasInitialState: " << (m_InitialState != nullptr) << std::endl;
}
} // namespace shapeton

#endif
