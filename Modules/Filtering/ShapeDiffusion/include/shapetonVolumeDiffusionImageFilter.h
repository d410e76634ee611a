#ifndef shapetonVolumeDiffusionImageFilter_h
#define shapetonVolumeDiffusionImageFilter_h

#include "shapetonDevice.h"
#include "shapetonITKCompatibility.h"
#include "shapetonVolumeGradientOperator.h"

#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class VolumeDiffusionImageFilter
 * \brief What the filters share that let heat or particles diffuse through a volume by its volume gradient operator.
 *
 * They work on the whole volume at once.
 *
 * \ingroup ShapeDiffusion
 */
template <typename TInputImage, typename TOutputImage>
class ITK_TEMPLATE_EXPORT VolumeDiffusionImageFilter : public itk::ImageToImageFilter<TInputImage, TOutputImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VolumeDiffusionImageFilter);

  using Self = VolumeDiffusionImageFilter;
  using Superclass = itk::ImageToImageFilter<TInputImage, TOutputImage>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  static_assert(TInputImage::ImageDimension == 3, "the volume gradient operator is defined on volumes");

  itkOverrideGetNameOfClassMacro(VolumeDiffusionImageFilter);

  /** Steepness p of (2.5): an edge insulates where the half gradient reaches 1 / p. Not negative. Default 7. */
  itkSetMacro(P, double);
  itkGetConstMacro(P, double);

  /** Intensities that map to 0 and to 1, for CT in Hounsfield units. Default: the least and the greatest intensity,
   * which WindowLower and WindowUpper hold after Update(). */
  void
  SetIntensityWindow(double lower, double upper);
  itkGetConstMacro(WindowLower, double);
  itkGetConstMacro(WindowUpper, double);

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
  void
  GenerateInputRequestedRegion() override;
  void
  EnlargeOutputRequestedRegion(itk::DataObject * output) override;

  std::array<std::size_t, 3>
  GetVolumeSize() const;

  /** The intensities of the input: those of the image itself where its pixels are float, else written to `converted`.
   */
  const float *
  GetIntensities(std::vector<float> & converted) const;

  /** p, window and spacing; finds the window in the intensities where none was set. */
  VolumeGradientOperator::Parameters
  MakeOperatorParameters(const float * intensities);

  /** Reports progress; throws ProcessAborted where the run is to be aborted. */
  void
  ReportProgress(double share);

private:
  double        m_P{ 7.0 };
  bool          m_HasWindow{ false };
  double        m_WindowLower{ 0.0 };
  double        m_WindowUpper{ 0.0 };
  std::uint64_t m_TimeSteps;
  Device        m_Device{ Device::Automatic };
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonVolumeDiffusionImageFilter.hxx"
#endif

#endif
