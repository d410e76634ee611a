#ifndef shapetonVolumeDiffusionImageFilter_h
#define shapetonVolumeDiffusionImageFilter_h

#include "shapetonDevice.h"
#include "shapetonVolumeGradientImageFilter.h"

#include <cstdint>

namespace shapeton
{
/** \class VolumeDiffusionImageFilter
 * \brief What the filters share that let heat or particles diffuse through a volume step by step.
 *
 * \ingroup ShapeDiffusion
 */
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

  /** Number of time steps; at least 1. The default is that of the filter. */
  itkSetMacro(TimeSteps, std::uint64_t);
  itkGetConstMacro(TimeSteps, std::uint64_t);

  /** Where the diffusion is computed: by default on the GPU where one is there and has the memory, else on the CPU; the
   * output is the same bytes. Update() throws DeviceError where Device::Cuda is asked for and cannot be used. */
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
