#ifndef shapetonVolumeDiffusionImageFilter_h
#define shapetonVolumeDiffusionImageFilter_h

#include "shapetonDevice.h"
#include "shapetonVolumeGradientImageFilter.h"

#include <cstdint>

namespace shapeton
{
/** \class VolumeDiffusionImageFilter
 * \brief Base class of filters for the diffusion of heat or particles through a volume in time steps.
 *
 * \ingroup ShapetonHeat */
template <typename TInputImage, typename TOutputImage>
class ITK_TEMPLATE_EXPORT VolumeDiffusionImageFilter : public VolumeGradientImageFilter<TInputImage, TOutputImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VolumeDiffusionImageFilter);

  using Self = VolumeDiffusionImageFilter;
  using Superclass = VolumeGradientImageFilter<TInputImage, TOutputImage>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkOverrideGetNameOfClassMacro(VolumeDiffusionImageFilter);

  /** Number of time steps; at least 1. The default depends on the filter. */
  itkSetMacro(TimeSteps, std::uint64_t);
  itkGetConstMacro(TimeSteps, std::uint64_t);

  /** Device that computes the diffusion. Default: the GPU if one is available and has enough memory, else the CPU;
   * results are identical on all devices. Update() throws DeviceError if Device::Cuda is requested and cannot be used.
   */
  void
  SetDevice(Device device)
  {
    if (m_Device != device)
    {
      m_Device = device;
      this->Modified();
    }
  }
  Device
  GetDevice() const
  {
    return m_Device;
  }

protected:
  explicit VolumeDiffusionImageFilter(std::uint64_t timeSteps) : m_TimeSteps(timeSteps) {}
  ~VolumeDiffusionImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;
  void
  VerifyPreconditions() const override;

private:
  std::uint64_t m_TimeSteps;
  Device        m_Device{ Device::Automatic };
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonVolumeDiffusionImageFilter.hxx"
#endif

#endif
