#ifndef shapetonElectronicCleansingImageFilter_h
#define shapetonElectronicCleansingImageFilter_h

#include "shapetonElectronicCleansing.h"
#include "shapetonExceptions.h"
#include "shapetonStageFilter.h"
#include "shapetonVolume.h"

#include "itkImageToImageFilter.h"

namespace shapeton
{
/** \class ElectronicCleansingImageFilter
 * \brief Pipeline filter of CleanseColon(): a CT without tagged fluid.
 *
 * \par Inputs and Outputs
 * Input: a CT in HU. Input Lumen: output 1 of the ColonLumenImageFilter of the same CT. Output 0: the CT with gas
 * instead of fluid, float. Output 1: CleansedColon with the occupancy, the input of ColonWallFilter; it starts at index
 * 0. Throws InputError if the lumen is not on the grid of the CT.
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputImage>
class ElectronicCleansingImageFilter : public StageFilter<itk::ImageToImageFilter<TInputImage, itk::Image<float, 3>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ElectronicCleansingImageFilter);

  using Self = ElectronicCleansingImageFilter;
  using Superclass = StageFilter<itk::ImageToImageFilter<TInputImage, itk::Image<float, 3>>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ElectronicCleansingImageFilter);

  itkSetInputMacro(Lumen, ResultObject<ColonLumen>);
  itkGetInputMacro(Lumen, ResultObject<ColonLumen>);

  ResultObject<CleansedColon> *
  GetCleansedOutput()
  {
    return static_cast<ResultObject<CleansedColon> *>(this->itk::ProcessObject::GetOutput(1));
  }

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType index) override
  {
    return index == 1 ? itk::DataObject::Pointer(ResultObject<CleansedColon>::New()) : Superclass::MakeOutput(index);
  }

protected:
  ElectronicCleansingImageFilter()
  {
    this->AddRequiredInputName("Lumen");
    this->SetNumberOfRequiredOutputs(2);
    this->SetNthOutput(1, this->MakeOutput(1));
  }
  ~ElectronicCleansingImageFilter() override = default;

  void
  Compute() override
  {
    const auto         ct = FloatsFromIndexZero(this->GetInput());
    const ColonLumen & lumen = this->GetLumen()->Get();
    if (lumen.labels && !HaveSameGrid(ct, lumen.labels))
    {
      throw InputError("the lumen and the CT have different grids: use the lumen of this CT");
    }
    CleansedColon cleansed = CleanseColon(ct, lumen, this->Reporter());
    HandOver(cleansed.ct.GetPointer(), this->GetOutput());
    this->SetResult(1, std::move(cleansed));
  }
};
} // namespace shapeton

#endif
