#ifndef shapetonVolumeGradientImageFilter_h
#define shapetonVolumeGradientImageFilter_h

#include "shapetonIndexedOutputs.h"
#include "shapetonITKCompatibility.h"
#include "shapetonVolumeGradientOperator.h"

#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <array>
#include <vector>

namespace shapeton
{
/** \class VolumeGradientImageFilter
 * \brief Base class of filters that use the volume gradient operator: p and the intensity window.
 *
 * The filters process the whole volume at once.
 *
 * \ingroup ShapetonHeat */
template <typename TInputImage, typename TOutputImage>
class ITK_TEMPLATE_EXPORT VolumeGradientImageFilter : public itk::ImageToImageFilter<TInputImage, TOutputImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VolumeGradientImageFilter);

  using Self = VolumeGradientImageFilter;
  using Superclass = itk::ImageToImageFilter<TInputImage, TOutputImage>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  static_assert(TInputImage::ImageDimension == 3, "the volume gradient operator is defined on volumes");

  itkOverrideGetNameOfClassMacro(VolumeGradientImageFilter);

  using Superclass::MakeOutput;
  shapetonIndexedOutputsMacro();

  /** Steepness p of (2.5), nonnegative: an edge insulates if the half gradient reaches 1 / p. Default 7, unless
   * documented otherwise. */
  itkSetMacro(P, double);
  itkGetConstMacro(P, double);

  /** Intensities that map to 0 and to 1, for CT in Hounsfield units. Default: the minimum and maximum intensity,
   * which WindowLower and WindowUpper return after Update(). */
  void
  SetIntensityWindow(double lower, double upper);
  itkGetConstMacro(WindowLower, double);
  itkGetConstMacro(WindowUpper, double);

protected:
  /** `p`: the default value of P. */
  explicit VolumeGradientImageFilter(double p = 7.0) : m_P(p) {}
  ~VolumeGradientImageFilter() override = default;

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

  /** The intensities of the input: its buffer for float pixels, otherwise a copy in `converted`. */
  const float *
  GetIntensities(std::vector<float> & converted) const;

  /** p, window and spacing; computes the window from the intensities if it is not set. */
  VolumeGradientOperator::Parameters
  MakeOperatorParameters(const float * intensities);

private:
  double m_P;
  bool   m_HasWindow{ false };
  double m_WindowLower{ 0.0 };
  double m_WindowUpper{ 0.0 };
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonVolumeGradientImageFilter.hxx"
#endif

#endif
