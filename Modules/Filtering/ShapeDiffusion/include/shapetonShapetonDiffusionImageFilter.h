#ifndef shapetonShapetonDiffusionImageFilter_h
#define shapetonShapetonDiffusionImageFilter_h

#include "shapetonHeatHistogram.h"
#include "shapetonITKCompatibility.h"
#include "shapetonShapetonDiffusion.h"
#include "shapetonShapetonParameters.h"
#include "shapetonVolumeDiffusionImageFilter.h"

#include "itkImage.h"

#include <memory>
#include <vector>

namespace shapeton
{
/** \class ShapetonInputError
 * \brief The input of shapeton diffusion leaves no place for shapetons, or its initial state belongs to another run.
 * \ingroup ShapeDiffusion */
class ShapetonInputError : public itk::ExceptionObject
{
public:
  using itk::ExceptionObject::ExceptionObject;
  itkOverrideGetNameOfClassMacro(ShapetonInputError);
};

/** \class ShapetonDiffusionImageFilter
 * \brief Describes each voxel by the number of visits of particles that move at random through the volume (shapeton
 * diffusion).
 *
 * Shapetons start at random places. In each step every shapeton draws a direction from the six edge weights of its
 * voxel, moves by a fixed distance, and adds one visit to the voxel where it ends. The more often a voxel is visited
 * the more its surroundings hold shapetons back.
 *
 * \par Inputs and Outputs
 * Input 0: a scalar volume of finite intensities. Input 1, optional: a mask on the same grid; shapetons start where it
 * is not 0. Output: the visits, on the grid of the input; they sum to shapetons x steps.
 *
 * \par Events
 * IterationEvent several times a second while the filter runs, at the ends of steps: GetOutput() then holds the visits
 * so far and GetMeasures() tells how far the run has come, so that a program can show the density as it grows. In the
 * middle of longer steps there is a ProgressEvent. SetAbortGenerateData takes effect within a tenth of a second.
 *
 * \par Going on
 * GetState() gives all that is needed to go on; a filter with the same input and settings and SetInitialState() ends,
 * byte for byte, as if it had run from the start.
 *
 * \par Errors
 * ShapetonInputError for an empty mask, for a volume without initial heat where shapetons are to be placed by it, for a
 * feature size that the volume cannot show, and for an initial state of another run; ExceptionObject for settings out
 * of range.
 *
 * Results have the same bytes for any number of threads, which follow ITK's global setting, and on any CPU. Memory: 20
 * bytes a voxel besides the input, 4 more unless its pixels are float.
 *
 * Source: Gurijala, Shape-based analysis, chapter 3 and appendix 8. Differences: directions follow the solid angle
 * (DirectionSampling), long steps may be stopped by walls (PathRule), the steady rule (3.10) uses normalised densities.
 *
 * \ingroup ShapeDiffusion
 */
template <typename TInputImage>
class ITK_TEMPLATE_EXPORT ShapetonDiffusionImageFilter
  : public VolumeDiffusionImageFilter<TInputImage, itk::Image<std::uint32_t, 3>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ShapetonDiffusionImageFilter);

  using Self = ShapetonDiffusionImageFilter;
  using Superclass = VolumeDiffusionImageFilter<TInputImage, itk::Image<std::uint32_t, 3>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using VisitsImageType = itk::Image<std::uint32_t, 3>;
  using MaskImageType = itk::Image<unsigned char, 3>;
  using StepsType = std::vector<std::uint64_t>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ShapetonDiffusionImageFilter);

  /** Where shapetons start: voxels that are not 0. The grid must be that of the input. */
  void
  SetMaskImage(const MaskImageType * mask)
  {
    this->SetNthInput(1, const_cast<MaskImageType *>(mask));
  }
  const MaskImageType *
  GetMaskImage() const
  {
    return itkDynamicCastInDebugMode<const MaskImageType *>(this->ProcessObject::GetInput(1));
  }

  /** Number of shapetons; at least 1. Default 65000. */
  itkSetMacro(NumberOfShapetons, std::uint32_t);
  itkGetConstMacro(NumberOfShapetons, std::uint32_t);

  /** Length of a step in (0, 1], in units of the longest side of the volume in mm; the same in mm in all directions.
   * Default 0.01. */
  itkSetMacro(Distance, double);
  itkGetConstMacro(Distance, double);

  /** Size in mm of the features that are looked for: with AutomaticDistance and AutomaticNumberOfShapetons these are
   * chosen by it (ChooseShapetons) when the filter runs, and Distance and NumberOfShapetons then hold what was chosen.
   * Default 0, off, off. */
  itkSetMacro(FeatureSize, double);
  itkGetConstMacro(FeatureSize, double);
  itkSetMacro(AutomaticDistance, bool);
  itkGetConstMacro(AutomaticDistance, bool);
  itkBooleanMacro(AutomaticDistance);
  itkSetMacro(AutomaticNumberOfShapetons, bool);
  itkGetConstMacro(AutomaticNumberOfShapetons, bool);
  itkBooleanMacro(AutomaticNumberOfShapetons);

  /** What ChooseShapetons() found, and why; valid after Update() where it was asked. */
  const AutomaticShapetons &
  GetAutomaticShapetons() const
  {
    return m_AutomaticShapetons;
  }

  /** Default SolidAngle. */
  itkSetEnumMacro(DirectionSampling, DirectionSampling);
  itkGetConstMacro(DirectionSampling, DirectionSampling);

  /** Default Endpoint. */
  itkSetEnumMacro(PathRule, PathRule);
  itkGetConstMacro(PathRule, PathRule);

  /** Default Uniform. */
  itkSetEnumMacro(Placement, ShapetonPlacement);
  itkGetConstMacro(Placement, ShapetonPlacement);

  /** Any number; the same gives the same result. Default 1. */
  itkSetMacro(Seed, std::uint64_t);
  itkGetConstMacro(Seed, std::uint64_t);

  /** Where the last Update() was computed. */
  const DeviceUse &
  GetDeviceUse() const
  {
    return m_DeviceUse;
  }

  /** Stop when the density is steady by (3.10) with Epsilon, or with the epsilon that the run itself suggests
   * (AutomaticEpsilon). Default off, 0.05, off. */
  itkSetMacro(UntilSteady, bool);
  itkGetConstMacro(UntilSteady, bool);
  itkBooleanMacro(UntilSteady);
  itkSetMacro(Epsilon, double);
  itkGetConstMacro(Epsilon, double);
  itkSetMacro(AutomaticEpsilon, bool);
  itkGetConstMacro(AutomaticEpsilon, bool);
  itkBooleanMacro(AutomaticEpsilon);

  /** Steps after which the visits are counted in the histogram; ascending, in [1, TimeSteps]. Default none. */
  void
  SetHistogramSteps(const StepsType & steps);
  const StepsType &
  GetHistogramSteps() const
  {
    return m_HistogramSteps;
  }

  /** Goes on from a state in place of placing shapetons; TimeSteps still counts from the start of the first run. */
  void
  SetInitialState(ShapetonState state);

  /** Keep the state after the last step for GetState(); default off. */
  itkSetMacro(WantState, bool);
  itkGetConstMacro(WantState, bool);
  itkBooleanMacro(WantState);

  /** The state after the last step taken: during an IterationEvent, and with WantState also after Update(). */
  ShapetonState
  GetState() const;

  /** How far the run has come. */
  const ShapetonMeasures &
  GetMeasures() const
  {
    return m_Measures;
  }

  /** Rows for the HistogramSteps that were reached; steps before an initial state have none. */
  const HeatHistogram &
  GetHistogram() const
  {
    return m_Histogram;
  }

protected:
  ShapetonDiffusionImageFilter();
  ~ShapetonDiffusionImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;
  void
  VerifyPreconditions() const override;
  void
  GenerateData() override;

private:
  void
  ChooseParameters();
  ShapetonDiffusionSettings
  MakeSettings(const float * intensities);
  void
  PlaceShapetons();
  void
  TakeSteps();

  std::uint32_t                  m_NumberOfShapetons{ 65000 };
  double                         m_Distance{ 0.01 };
  double                         m_FeatureSize{ 0.0 };
  bool                           m_AutomaticDistance{ false };
  bool                           m_AutomaticNumberOfShapetons{ false };
  AutomaticShapetons             m_AutomaticShapetons;
  DirectionSampling              m_DirectionSampling{ DirectionSampling::SolidAngle };
  PathRule                       m_PathRule{ PathRule::Endpoint };
  ShapetonPlacement              m_Placement{ ShapetonPlacement::Uniform };
  std::uint64_t                  m_Seed{ 1 };
  DeviceUse                      m_DeviceUse;
  bool                           m_UntilSteady{ false };
  double                         m_Epsilon{ 0.05 };
  bool                           m_AutomaticEpsilon{ false };
  StepsType                      m_HistogramSteps;
  bool                           m_WantState{ false };
  std::shared_ptr<ShapetonState> m_InitialState; // null: place the shapetons

  std::unique_ptr<ShapetonDiffusion> m_Diffusion; // while the filter runs
  ShapetonState                      m_FinalState;
  ShapetonMeasures                   m_Measures;
  HeatHistogram                      m_Histogram;
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonShapetonDiffusionImageFilter.hxx"
#endif

namespace shapeton
{
// Compiled once, in the library.
extern template class ShapeDiffusion_EXPORT ShapetonDiffusionImageFilter<itk::Image<float, 3>>;
extern template class ShapeDiffusion_EXPORT ShapetonDiffusionImageFilter<itk::Image<short, 3>>;
extern template class ShapeDiffusion_EXPORT ShapetonDiffusionImageFilter<itk::Image<unsigned char, 3>>;
} // namespace shapeton

#endif
