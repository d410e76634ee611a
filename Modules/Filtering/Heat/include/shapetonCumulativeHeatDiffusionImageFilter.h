#ifndef shapetonCumulativeHeatDiffusionImageFilter_h
#define shapetonCumulativeHeatDiffusionImageFilter_h

#include "shapetonCumulativeHeatDiffusionOptionsMethods.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonFilterWithDomain.h"
#include "shapetonITKCompatibility.h"
#include "shapetonVolumeDiffusionImageFilter.h"

#include "itkImage.h"

#include <functional>

namespace shapeton
{
/** \class CumulativeHeatDiffusionImageFilter
 * \brief Describes each voxel by its heat after diffusion from all voxels at once (CHD).
 *
 * Each voxel starts with the initial heat (2.3) and heat flows between neighbors by the volume gradient operator
 * (2.4)-(2.6): f_i += dt * sum_j c_ij (f_j - f_i). A few steps reveal local shape (edges, corners), and many steps
 * reveal whole objects: a closed object converges to its mean initial heat, which depends on its shape and size.
 *
 * \par Inputs and Outputs Input: a scalar volume of finite intensities. Domain, optional: see FilterWithDomain. Output
 * 0: the heat after the last step, in [0, 1], float, on the grid of the input. Output 1: the initial heat. After
 * Update(), GetResult() returns the last step, the heat histogram and the components.
 *
 * \par Parameters The CumulativeHeatDiffusionOptions, and the following. The filter processes the whole volume at once,
 * with ITK's global number of threads. Memory: about 8 single-precision copies of the volume, 13 with a histogram.
 * Results are bitwise identical for any number of threads.
 *
 * Source: Gurijala, Shape-based analysis, chapter 2. Differences: the source specifies neither the time step nor the
 * scaling of intensities; (2.4) is read as a product on anisotropic grids; steps are taken by a Chebyshev expansion.
 *
 * \ingroup ShapetonHeat */
template <typename TInputImage>
class ITK_TEMPLATE_EXPORT CumulativeHeatDiffusionImageFilter
  : public CumulativeHeatDiffusionOptionsMethods<
      FilterWithDomain<VolumeDiffusionImageFilter<TInputImage, itk::Image<float, 3>, CumulativeHeatDiffusionSettings>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CumulativeHeatDiffusionImageFilter);

  using Self = CumulativeHeatDiffusionImageFilter;
  using Superclass = typename CumulativeHeatDiffusionImageFilter::CumulativeHeatDiffusionOptionsMethods;
  using OptionsType = typename Superclass::OptionsType;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using HeatImageType = itk::Image<float, 3>;
  using Solver = HeatDiffusionSolver::Method;
  using Conductance = VolumeGradientOperator::Conductance;
  using StepsType = std::vector<std::uint64_t>;

  shapetonNewMacro(Self);
  itkOverrideGetNameOfClassMacro(CumulativeHeatDiffusionImageFilter);

  /** Sets window, p, smoothing and number of steps, for example to the result of ChooseHeatParameters(); by default,
   * the filter uses the published values. */
  void
  UseParameters(const HeatParameterChoice & choice);

  /** Whether to find the components and their exact converged heat, see FindShapeComponents(), and the classes with
   * their coherence. Default off. */
  virtual void
  SetWantComponents(bool value)
  {
    this->SetOption(this->m_Options.wantComponents, value);
  }
  virtual bool
  GetWantComponents() const
  {
    return this->m_Options.wantComponents;
  }
  itkBooleanMacro(WantComponents);

  /** Steps recorded as rows of the heat histogram; ascending, at most TimeSteps. Default none. */
  virtual void
  SetHistogramSteps(const StepsType & steps)
  {
    this->SetOption(this->m_Options.histogramSteps, steps);
  }
  virtual const StepsType &
  GetHistogramSteps() const
  {
    return this->m_Options.histogramSteps;
  }

  /** Receives the heat after `step`, on the grid of the input; valid during the call. */
  using SnapshotConsumer = std::function<void(std::uint64_t step, const HeatImageType * heat)>;

  /** Steps whose heat is passed to the consumer, ascending, at most TimeSteps. Default none. */
  void
  SetSnapshotSteps(const StepsType & steps, const SnapshotConsumer & consumer);

  /** Result of the last Update(), except for the heat. */
  const CumulativeHeatDiffusionResult &
  GetResult() const
  {
    return m_Result;
  }

  HeatImageType *
  GetInitialHeatOutput()
  {
    return dynamic_cast<HeatImageType *>(this->ProcessObject::GetOutput(1));
  }

  /** Whether to compute output 1. Default off; output 1 is then empty and must not be connected. */
  itkSetMacro(WantInitialHeat, bool);
  itkGetConstMacro(WantInitialHeat, bool);
  itkBooleanMacro(WantInitialHeat);

protected:
  CumulativeHeatDiffusionImageFilter();
  ~CumulativeHeatDiffusionImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;
  void
  GenerateData() override;

private:
  void
  HandOut(std::uint64_t step, const std::vector<float> & values) const;

  bool                          m_WantInitialHeat{ false };
  SnapshotConsumer              m_SnapshotConsumer;
  CumulativeHeatDiffusionResult m_Result;
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonCumulativeHeatDiffusionImageFilter.hxx"
#endif

namespace shapeton
{
// Compiled once, in the library.
extern template class ShapetonHeat_EXPORT CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>>;
extern template class ShapetonHeat_EXPORT CumulativeHeatDiffusionImageFilter<itk::Image<short, 3>>;
extern template class ShapetonHeat_EXPORT CumulativeHeatDiffusionImageFilter<itk::Image<unsigned char, 3>>;
} // namespace shapeton

#endif
