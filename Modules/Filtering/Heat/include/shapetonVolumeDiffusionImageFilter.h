#ifndef shapetonVolumeDiffusionImageFilter_h
#define shapetonVolumeDiffusionImageFilter_h

#include "shapetonDeviceOptionsMethods.h"
#include "shapetonVolumeDiffusionOptionsMethods.h"
#include "shapetonVolumeGradientImageFilter.h"

namespace shapeton
{
/** \class VolumeDiffusionImageFilter
 * \brief Base class of filters for the diffusion of heat or particles through a volume in time steps.
 *
 * \ingroup ShapetonHeat */
template <typename TInputImage, typename TOutputImage, typename TOptions>
class ITK_TEMPLATE_EXPORT VolumeDiffusionImageFilter
  : public VolumeDiffusionOptionsMethods<
      DeviceOptionsMethods<VolumeGradientImageFilter<TInputImage, TOutputImage, TOptions>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VolumeDiffusionImageFilter);

  using Self = VolumeDiffusionImageFilter;
  using Superclass = typename VolumeDiffusionImageFilter::VolumeDiffusionOptionsMethods;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkOverrideGetNameOfClassMacro(VolumeDiffusionImageFilter);

protected:
  VolumeDiffusionImageFilter() = default;
  ~VolumeDiffusionImageFilter() override = default;
};
} // namespace shapeton

#endif
