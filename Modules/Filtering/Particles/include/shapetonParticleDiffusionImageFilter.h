#ifndef shapetonParticleDiffusionImageFilter_h
#define shapetonParticleDiffusionImageFilter_h

#include "shapetonFilterInput.h"
#include "shapetonParticleDiffusionOptionsMethods.h"
#include "shapetonParticleOptionsMethods.h"
#include "shapetonHeatHistogram.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonVolumeDiffusionImageFilter.h"

#include "itkImage.h"

#include <memory>
#include <vector>

namespace shapeton
{
/** \class ParticleDiffusionImageFilter
 * \brief Describes each voxel by how often randomly moving particles visit it (shapeton diffusion).
 *
 * Shapetons start at random positions. In each step every shapeton draws a direction from the six edge weights of its
 * voxel, moves by a fixed distance, and adds one visit to its new voxel. Frequent visits indicate confining
 * surroundings.
 *
 * \par Inputs and Outputs
 * Input 0: a scalar volume of finite intensities. Input 1, optional: a mask on the same grid; shapetons start where it
 * is not 0. Output: the visits, on the grid of the input; they sum to shapetons x steps.
 *
 * \par Events
 * IterationEvent is invoked several times a second at the end of a step: GetOutput() then returns the current visits
 * and GetMeasures() the progress of the run, for example to display the density. ProgressEvent is invoked during longer
 * steps. SetAbortGenerateData takes effect within a tenth of a second.
 *
 * \par Continuing GetState() returns the state needed to continue. A filter with the same input and settings that
 * starts from it (SetInitialState()) yields the same result, bit for bit, as an uninterrupted run.
 *
 * \par Errors
 * Update() throws InputError for an unsuitable volume, an empty mask, placement by initial heat in a volume without
 * initial heat, and an initial state of another run; ParameterError for settings out of range. Both are derived from
 * itk::ExceptionObject.
 *
 * \par Defaults
 * They are those of the dissertation; ChooseShapetonParameters() chooses those that the tool uses.
 *
 * Results are bitwise identical for any number of threads (ITK's global setting) and on any CPU. Memory: 20 bytes per
 * voxel in addition to the input, 24 unless its pixels are float.
 *
 * Source: Gurijala, Shape-based analysis, chapter 3 and appendix 8. Differences: directions follow the solid angle
 * (DirectionSampling), long steps may be stopped by walls (PathRule), and the steady rule (3.10) uses normalized
 * densities.
 *
 * \ingroup ShapetonParticles */
template <typename TInputImage>
class ITK_TEMPLATE_EXPORT ParticleDiffusionImageFilter
  : public ParticleDiffusionOptionsMethods<ParticleOptionsMethods<
      VolumeDiffusionImageFilter<TInputImage, itk::Image<std::uint32_t, 3>, ParticleDiffusionOptions>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ParticleDiffusionImageFilter);

  using Self = ParticleDiffusionImageFilter;
  using Superclass = typename ParticleDiffusionImageFilter::ParticleDiffusionOptionsMethods;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using VisitsImageType = itk::Image<std::uint32_t, 3>;
  using MaskImageType = itk::Image<unsigned char, 3>;
  using StepsType = std::vector<std::uint64_t>;

  shapetonNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ParticleDiffusionImageFilter);

  /** Mask of the start voxels (not 0). Its grid must be that of the input. */
  void
  SetMaskImage(const MaskImageType * mask)
  {
    this->SetNthInput(1, const_cast<MaskImageType *>(mask));
  }
  const MaskImageType *
  GetMaskImage() const
  {
    return InputOfType<MaskImageType>(this->ProcessObject::GetInput(1), "mask");
  }

  /** The device used by the last Update(). */
  const DeviceUse &
  GetDeviceUse() const
  {
    return m_DeviceUse;
  }

  /** Steps recorded as rows of the visit histogram; ascending, in [1, TimeSteps]. Default none. */
  void
  SetHistogramSteps(const StepsType & steps);
  const StepsType &
  GetHistogramSteps() const
  {
    return m_HistogramSteps;
  }

  /** Continue from a state instead of placing shapetons; TimeSteps still counts from the start of the first run. */
  void
  SetInitialState(ParticleState state);

  /** Keep the state after the last step for GetState(); default off. */
  itkSetMacro(WantState, bool);
  itkGetConstMacro(WantState, bool);
  itkBooleanMacro(WantState);

  /** The state after the last completed step: during an IterationEvent, and with WantState also after Update(). */
  ParticleState
  GetState() const;

  /** Measures of the run so far. */
  const ParticleMeasures &
  GetMeasures() const
  {
    return m_Measures;
  }

  /** Rows for the HistogramSteps that were reached; there are no rows for steps before an initial state. */
  const HeatHistogram &
  GetHistogram() const
  {
    return m_Histogram;
  }

protected:
  ParticleDiffusionImageFilter();
  ~ParticleDiffusionImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;
  void
  VerifyPreconditions() const override;
  void
  GenerateData() override;

private:
  void
  PlaceShapetons();
  void
  TakeSteps();

  DeviceUse                      m_DeviceUse;
  StepsType                      m_HistogramSteps;
  bool                           m_WantState{ false };
  std::shared_ptr<ParticleState> m_InitialState; // null: place the shapetons

  std::unique_ptr<ParticleDiffusion> m_Diffusion; // while the filter runs
  ParticleState                      m_FinalState;
  ParticleMeasures                   m_Measures;
  HeatHistogram                      m_Histogram;
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonParticleDiffusionImageFilter.hxx"
#endif

namespace shapeton
{
// Compiled once, in the library.
extern template class ShapetonParticles_EXPORT ParticleDiffusionImageFilter<itk::Image<float, 3>>;
extern template class ShapetonParticles_EXPORT ParticleDiffusionImageFilter<itk::Image<short, 3>>;
extern template class ShapetonParticles_EXPORT ParticleDiffusionImageFilter<itk::Image<unsigned char, 3>>;
} // namespace shapeton

#endif
