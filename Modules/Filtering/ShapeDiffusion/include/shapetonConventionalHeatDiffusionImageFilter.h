#ifndef shapetonConventionalHeatDiffusionImageFilter_h
#define shapetonConventionalHeatDiffusionImageFilter_h

#include "shapetonITKCompatibility.h"
#include "shapetonProgress.h"
#include "shapetonVolumeDiffusionImageFilter.h"

#include <cstdint>

namespace shapeton
{
/** The heat that stays on its source when each voxel in turn is the only one with heat: `sourceHeat` times the diagonal
 * of (1 - dt L)^timeSteps, in double precision; see ConventionalHeatDiffusionImageFilter. `heat` holds as many values
 * as the volume has voxels, x fastest. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT void
DiffuseConventionalHeat(const VolumeGradientOperator & volumeGradient,
                        double                         timeStepLength,
                        std::uint64_t                  timeSteps,
                        double                         sourceHeat,
                        float *                        heat,
                        const Progress &               progress = {});

/** \class ConventionalHeatDiffusionImageFilter
 * \brief Heat diffusion from one voxel at a time (dissertation 2.2.1): the slow reference that CHD replaces.
 *
 * Each voxel is the source once: it alone holds SourceHeat, heat flows for TimeSteps steps by the same operator as in
 * CHD, and what is left on the source is its value. The cost grows with the square of the number of voxels: for small
 * volumes.
 *
 * At steady state a closed component of n voxels holds SourceHeat / n, and not its mean initial heat: unlike what 2.3.2
 * says, conventional and cumulative diffusion do not agree there.
 *
 * \par Inputs and Outputs
 * Input: a scalar volume of finite intensities. Output: the heat, float, on the grid of the input.
 *
 * \ingroup ShapeDiffusion
 */
template <typename TInputImage>
class ITK_TEMPLATE_EXPORT ConventionalHeatDiffusionImageFilter
  : public VolumeDiffusionImageFilter<TInputImage, itk::Image<float, 3>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ConventionalHeatDiffusionImageFilter);

  using Self = ConventionalHeatDiffusionImageFilter;
  using Superclass = VolumeDiffusionImageFilter<TInputImage, itk::Image<float, 3>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ConventionalHeatDiffusionImageFilter);

  /** Length dt of a time step in (0, 1/12]. Default 1/12. */
  itkSetMacro(TimeStepLength, double);
  itkGetConstMacro(TimeStepLength, double);

  /** The heat of the source, in (0, 1]. Default 1. */
  itkSetMacro(SourceHeat, double);
  itkGetConstMacro(SourceHeat, double);

protected:
  ConventionalHeatDiffusionImageFilter() : Superclass(100) {}
  ~ConventionalHeatDiffusionImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;
  void
  GenerateData() override;

private:
  double m_TimeStepLength{ 1.0 / 12.0 };
  double m_SourceHeat{ 1.0 };
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonConventionalHeatDiffusionImageFilter.hxx"
#endif

#endif
