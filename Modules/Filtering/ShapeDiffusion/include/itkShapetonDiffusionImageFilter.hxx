#ifndef itkShapetonDiffusionImageFilter_hxx
#define itkShapetonDiffusionImageFilter_hxx

#include "itkShapetonDiffusionImageFilter.h"
#include "itkVisitDensity.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace itk
{
template <typename TInputImage>
ShapetonDiffusionImageFilter<TInputImage>::ShapetonDiffusionImageFilter()
{
  this->SetNumberOfRequiredInputs(1);
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::SetIntensityWindow(double lower, double upper)
{
  m_HasWindow = true;
  m_WindowLower = lower;
  m_WindowUpper = upper;
  this->Modified();
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::SetHistogramSteps(const StepsType & steps)
{
  m_HistogramSteps = steps;
  this->Modified();
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::SetInitialState(ShapetonState state)
{
  m_InitialState = std::make_shared<ShapetonState>(std::move(state));
  this->Modified();
}

template <typename TInputImage>
ShapetonState
ShapetonDiffusionImageFilter<TInputImage>::GetState() const
{
  return m_Diffusion ? m_Diffusion->GetState() : m_FinalState;
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_TimeSteps < 1)
  {
    itkExceptionMacro("TimeSteps must be at least 1");
  }
  if (m_HasWindow && !(m_WindowLower < m_WindowUpper))
  {
    itkExceptionMacro("the intensity window [" << m_WindowLower << ", " << m_WindowUpper << "] is empty or reversed");
  }
  if (!(m_Epsilon >= 0.0))
  {
    itkExceptionMacro("Epsilon must not be negative, got " << m_Epsilon);
  }
  const bool ascend = std::adjacent_find(m_HistogramSteps.begin(), m_HistogramSteps.end(), std::greater_equal<>()) ==
                      m_HistogramSteps.end();
  if (!ascend || (!m_HistogramSteps.empty() && (m_HistogramSteps.front() < 1 || m_HistogramSteps.back() > m_TimeSteps)))
  {
    itkExceptionMacro("the HistogramSteps must ascend and lie between 1 and TimeSteps");
  }
  if (m_InitialState && m_InitialState->step > m_TimeSteps)
  {
    itkExceptionMacro("the initial state is of step " << m_InitialState->step << ", beyond TimeSteps, " << m_TimeSteps);
  }
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  if (auto * const input = const_cast<TInputImage *>(this->GetInput()))
  {
    input->SetRequestedRegionToLargestPossibleRegion();
  }
  if (auto * const mask = const_cast<MaskImageType *>(this->GetMaskImage()))
  {
    mask->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::ChooseParameters(const std::array<std::size_t, 3> & size)
{
  if (!m_AutomaticDistance && !m_AutomaticNumberOfShapetons)
  {
    return;
  }
  std::array<double, 3> spacing{};
  std::copy_n(this->GetInput()->GetSpacing().Begin(), 3, spacing.begin());
  try
  {
    m_AutomaticShapetons = ChooseShapetons(size, spacing, m_FeatureSize, m_TimeSteps);
  }
  catch (const std::invalid_argument & error)
  {
    throw ShapetonInputError(__FILE__, __LINE__, error.what(), ITK_LOCATION);
  }
  if (m_AutomaticDistance)
  {
    m_Distance = m_AutomaticShapetons.distance;
  }
  if (m_AutomaticNumberOfShapetons)
  {
    m_NumberOfShapetons = m_AutomaticShapetons.shapetons;
  }
}

template <typename TInputImage>
ShapetonDiffusionSettings
ShapetonDiffusionImageFilter<TInputImage>::MakeSettings(const float * intensities, std::size_t number)
{
  if (!m_HasWindow && number > 0)
  {
    const auto ends = std::minmax_element(intensities, intensities + number);
    m_WindowLower = *ends.first;
    m_WindowUpper = *ends.second;
  }
  ShapetonDiffusionSettings settings;
  settings.volumeGradient.p = m_P;
  settings.volumeGradient.lower = m_WindowLower;
  settings.volumeGradient.upper = m_WindowUpper;
  std::copy_n(this->GetInput()->GetSpacing().Begin(), 3, settings.volumeGradient.spacing.begin());
  settings.shapetons = m_NumberOfShapetons;
  settings.distance = m_Distance;
  settings.directionSampling = m_DirectionSampling;
  settings.pathRule = m_PathRule;
  settings.placement = m_Placement;
  settings.seed = m_Seed;
  return settings;
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::ThrowIfAborted() const
{
  if (this->GetAbortGenerateData())
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::PlaceShapetons()
{
  const TInputImage * const   input = this->GetInput();
  const MaskImageType * const mask = this->GetMaskImage();
  if (mask && mask->GetBufferedRegion().GetSize() != input->GetBufferedRegion().GetSize())
  {
    itkExceptionMacro("the mask differs from the input in size");
  }
  const std::size_t          number = input->GetBufferedRegion().GetNumberOfPixels();
  std::array<std::size_t, 3> size{};
  std::copy_n(input->GetBufferedRegion().GetSize().begin(), 3, size.begin());

  this->ChooseParameters(size);

  std::vector<float> converted;
  const float *      intensities = nullptr;
  if constexpr (std::is_same_v<typename TInputImage::PixelType, float>)
  {
    intensities = input->GetBufferPointer();
  }
  else
  {
    converted.assign(input->GetBufferPointer(), input->GetBufferPointer() + number);
    intensities = converted.data();
  }
  m_Diffusion = std::make_unique<ShapetonDiffusion>(intensities,
                                                    size,
                                                    this->MakeSettings(intensities, number),
                                                    mask ? mask->GetBufferPointer() : nullptr,
                                                    this->GetOutput()->GetBufferPointer(),
                                                    [this] {
                                                      this->UpdateProgress(this->GetProgress());
                                                      this->ThrowIfAborted();
                                                    });
  if (m_InitialState)
  {
    try
    {
      m_Diffusion->SetState(*m_InitialState);
    }
    catch (const std::invalid_argument & error)
    {
      throw ShapetonInputError(__FILE__, __LINE__, error.what(), ITK_LOCATION);
    }
  }
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::TakeSteps()
{
  const std::optional<SteadyRule> rule =
    m_UntilSteady ? std::optional<SteadyRule>({ m_Epsilon, m_AutomaticEpsilon }) : std::nullopt;
  const auto observer = [this](const ShapetonMeasures & measures) {
    m_Measures = measures;
    this->UpdateProgress(static_cast<float>(measures.step) / static_cast<float>(m_TimeSteps));
    this->InvokeEvent(IterationEvent());
    this->ThrowIfAborted();
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
    m_Diffusion->Run(m_TimeSteps, rule, observer);
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
ShapetonDiffusionImageFilter<TInputImage>::GenerateData()
{
  VisitsImageType * const visits = this->GetOutput();
  visits->SetBufferedRegion(visits->GetLargestPossibleRegion());
  visits->Allocate();
  m_Measures = ShapetonMeasures();
  m_FinalState = ShapetonState();
  const struct Release // also when the run is aborted: the volume's weights are large
  {
    ~Release() { diffusion.reset(); }
    std::unique_ptr<ShapetonDiffusion> & diffusion;
  } release{ m_Diffusion };
  try
  {
    this->PlaceShapetons();
    this->TakeSteps();
    if (m_WantState)
    {
      m_FinalState = m_Diffusion->GetState();
    }
  }
  catch (const std::domain_error & error)
  {
    throw ShapetonInputError(__FILE__, __LINE__, error.what(), ITK_LOCATION);
  }
  catch (const std::logic_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
}

template <typename TInputImage>
void
ShapetonDiffusionImageFilter<TInputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "P: " << m_P << std::endl;
  os << indent << "HasWindow: " << m_HasWindow << std::endl;
  os << indent << "WindowLower: " << m_WindowLower << std::endl;
  os << indent << "WindowUpper: " << m_WindowUpper << std::endl;
  os << indent << "NumberOfShapetons: " << m_NumberOfShapetons << std::endl;
  os << indent << "Distance: " << m_Distance << std::endl;
  os << indent << "FeatureSize: " << m_FeatureSize << std::endl;
  os << indent << "AutomaticDistance: " << m_AutomaticDistance << std::endl;
  os << indent << "AutomaticNumberOfShapetons: " << m_AutomaticNumberOfShapetons << std::endl;
  os << indent << "TimeSteps: " << m_TimeSteps << std::endl;
  os << indent << "DirectionSampling: " << NameOf(m_DirectionSampling) << std::endl;
  os << indent << "PathRule: " << NameOf(m_PathRule) << std::endl;
  os << indent << "Placement: " << NameOf(m_Placement) << std::endl;
  os << indent << "Seed: " << m_Seed << std::endl;
  os << indent << "UntilSteady: " << m_UntilSteady << std::endl;
  os << indent << "Epsilon: " << m_Epsilon << std::endl;
  os << indent << "AutomaticEpsilon: " << m_AutomaticEpsilon << std::endl;
  os << indent << "HistogramSteps: " << m_HistogramSteps.size() << std::endl;
  os << indent << "WantState: " << m_WantState << std::endl;
  os << indent << "HasInitialState: " << (m_InitialState != nullptr) << std::endl;
}
} // namespace itk

#endif
