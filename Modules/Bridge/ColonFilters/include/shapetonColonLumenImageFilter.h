#ifndef shapetonColonLumenImageFilter_h
#define shapetonColonLumenImageFilter_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonExceptions.h"
#include "shapetonStageFilter.h"

#include "itkImageToImageFilter.h"

namespace shapeton
{
/** \class ColonLumenImageFilter
 * \brief Pipeline filter of SegmentColonLumen(): gas and tagged fluid in the colon of a CT colonography.
 *
 * \par Inputs and Outputs
 * Input: a CT in HU, scalar voxels of any type, any axes. Output 0: labels on its grid, 1 gas, 2 fluid. Output 1: the
 * complete ColonLumen, the input of ElectronicCleansingImageFilter; its labels start at index 0.
 *
 * Throws InputError if no prepared colon is found, unless KeepPartial is on, and the exceptions of SegmentColonLumen().
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputImage>
class ColonLumenImageFilter : public StageFilter<itk::ImageToImageFilter<TInputImage, itk::Image<unsigned char, 3>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ColonLumenImageFilter);

  using Self = ColonLumenImageFilter;
  using Superclass = StageFilter<itk::ImageToImageFilter<TInputImage, itk::Image<unsigned char, 3>>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using LabelImageType = itk::Image<unsigned char, 3>;
  using OptionsType = ColonLumenOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ColonLumenImageFilter);

  /** \name See ColonLumenOptions */
  ///@{
  shapetonOptionMacro(PatientPosition, patientPosition);
  shapetonOptionMacro(SeedPoints, seedPoints);
  ///@}

  /** Return partial results, with ColonLumen::failure, if the colon is not sufficiently distended or tagged. Default
   * off. */
  itkSetMacro(KeepPartial, bool);
  itkGetConstMacro(KeepPartial, bool);
  itkBooleanMacro(KeepPartial);

  ResultObject<ColonLumen> *
  GetLumenOutput()
  {
    return static_cast<ResultObject<ColonLumen> *>(this->itk::ProcessObject::GetOutput(1));
  }

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType index) override
  {
    return index == 1 ? itk::DataObject::Pointer(ResultObject<ColonLumen>::New()) : Superclass::MakeOutput(index);
  }

protected:
  ColonLumenImageFilter()
  {
    this->SetNumberOfRequiredOutputs(2);
    this->SetNthOutput(1, this->MakeOutput(1));
  }
  ~ColonLumenImageFilter() override = default;

  void
  Compute() override
  {
    ColonLumenOptions options = m_Options;
    options.progress = this->Reporter();
    ColonLumen lumen = SegmentColonLumen(FloatsFromIndexZero(this->GetInput()), options);
    if (!lumen.failure.empty() && !m_KeepPartial)
    {
      throw InputError(lumen.failure);
    }
    HandOver(lumen.labels.GetPointer(), this->GetOutput());
    this->SetResult(1, std::move(lumen));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "PatientPosition: " << m_Options.patientPosition << std::endl;
    os << indent << "SeedPoints: " << m_Options.seedPoints.size() << std::endl;
    os << indent << "KeepPartial: " << m_KeepPartial << std::endl;
  }

private:
  OptionsType m_Options;
  bool        m_KeepPartial{ false };
};
} // namespace shapeton

#endif
