#ifndef shapetonColonLumenImageFilter_h
#define shapetonColonLumenImageFilter_h

#include "shapetonColonLumenOptionsMethods.h"
#include "shapetonColonLumenSegmentation.h"
#include "shapetonStageFilter.h"

#include "itkImageToImageFilter.h"

namespace shapeton
{
/** \class ColonLumenImageFilter
 * \brief Pipeline filter for SegmentColonLumen(): gas and tagged fluid in the colon of a CT colonography.
 *
 * \par Inputs and Outputs
 * Input: a CT in HU, scalar voxels of any type, any axes. Output 0: labels on its grid, 1 gas, 2 fluid. Output 1: the
 * complete ColonLumen, the input of ElectronicCleansingImageFilter; its labels start at index 0.
 *
 * Throws InputError if no prepared colon is found, unless KeepPartial is on, and the exceptions of SegmentColonLumen().
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputImage>
class ColonLumenImageFilter
  : public ColonLumenOptionsMethods<StageFilter<itk::ImageToImageFilter<TInputImage, itk::Image<unsigned char, 3>>,
                                                ColonLumenSettings,
                                                itk::Image<unsigned char, 3>,
                                                ResultObject<ColonLumen>>>
{
public:
  shapetonStageFilterMacro(ColonLumenImageFilter);

  using LabelImageType = itk::Image<unsigned char, 3>;

  shapetonOutputMacro(Lumen, 1);

  /** Whether to return partial results, with ColonLumen::failure, if the colon is not sufficiently distended or tagged.
   * Default off. */
  itkSetMacro(KeepPartial, bool);
  itkGetConstMacro(KeepPartial, bool);
  itkBooleanMacro(KeepPartial);

protected:
  void
  Compute() override
  {
    ColonLumen lumen = SegmentColonLumen(FloatsFromIndexZero(this->GetInput()), this->ReportingOptions());
    if (!m_KeepPartial)
    {
      RequireSuccess(lumen);
    }
    this->SetOutputs(lumen.labels.GetPointer(), std::move(lumen));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "KeepPartial: " << m_KeepPartial << std::endl;
  }

private:
  bool m_KeepPartial{ false };
};
} // namespace shapeton

#endif
