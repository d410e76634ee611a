#ifndef shapetonVolumeGradientImageFilter_h
#define shapetonVolumeGradientImageFilter_h

#include "shapetonExceptions.h"
#include "shapetonFilterInput.h"
#include "shapetonFilterOptions.h"
#include "shapetonIndexedOutputs.h"
#include "shapetonITKCompatibility.h"
#include "shapetonImageGrid.h"
#include "shapetonVolumeGradientOperator.h"
#include "shapetonVolumeGradientOptionsMethods.h"

#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <array>

namespace shapeton
{
/** \class VolumeGradientImageFilter
 * \brief Base class of filters that use the volume gradient operator: p and the intensity window.
 *
 * The filters process the whole volume at once. Its pixels are scalars.
 *
 * \ingroup ShapetonHeat */
template <typename TInputImage, typename TOutputImage, typename TOptions>
class ITK_TEMPLATE_EXPORT VolumeGradientImageFilter
  : public VolumeGradientOptionsMethods<FilterWithOptions<TOptions, itk::ImageToImageFilter<TInputImage, TOutputImage>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VolumeGradientImageFilter);

  using Self = VolumeGradientImageFilter;
  using Superclass = typename VolumeGradientImageFilter::VolumeGradientOptionsMethods;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkOverrideGetNameOfClassMacro(VolumeGradientImageFilter);

  using Superclass::MakeOutput;
  shapetonIndexedOutputsMacro();

  using Superclass::SetIntensityWindow;
  void
  SetIntensityWindow(double lower, double upper)
  {
    this->SetIntensityWindow(std::array<double, 2>{ { lower, upper } });
  }
  /** The intensities mapped to 0 and 1 by the last Update(). */
  double
  GetWindowLower() const
  {
    return m_Window[0];
  }
  double
  GetWindowUpper() const
  {
    return m_Window[1];
  }

protected:
  VolumeGradientImageFilter() = default;
  ~VolumeGradientImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;
  void
  VerifyPreconditions() const override;
  /** Throws InputError if another input does not have the grid of the volume, see HaveSameGrid(). */
  void
  VerifyInputInformation() const override;
  void
  GenerateInputRequestedRegion() override;
  void
  EnlargeOutputRequestedRegion(itk::DataObject * output) override;

  /** The options, with the window of the volume if none is set. */
  TOptions
  OptionsFor(const VolumeView & volume);

private:
  std::array<double, 2> m_Window{ { 0.0, 0.0 } };
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonVolumeGradientImageFilter.hxx"
#endif

#endif
