#ifndef shapetonElectronicCleansingImageFilter_h
#define shapetonElectronicCleansingImageFilter_h

#include "shapetonElectronicCleansing.h"
#include "shapetonImageGrid.h"
#include "shapetonStageFilter.h"

#include "itkImageToImageFilter.h"

namespace shapeton
{
/** \class ElectronicCleansingImageFilter
 * \brief Pipeline filter for CleanseColon(): a CT without tagged fluid.
 *
 * \par Inputs and Outputs
 * Input: a CT in HU. Input Lumen: output 1 of the ColonLumenImageFilter of the same CT. Output 0: the CT with gas
 * instead of fluid, float. Output 1: CleansedColon with the occupancy, the input of ColonWallFilter; it starts at index
 * 0. Throws InputError if the lumen is not on the grid of the CT.
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputImage>
class ElectronicCleansingImageFilter
  : public StageFilter<itk::ImageToImageFilter<TInputImage, itk::Image<float, 3>>,
                       NoOptions,
                       itk::Image<float, 3>,
                       ResultObject<CleansedColon>>
{
public:
  shapetonStageFilterMacro(ElectronicCleansingImageFilter);

  shapetonRequiredInputMacro(Lumen, ResultObject<ColonLumen>);
  shapetonOutputMacro(Cleansed, 1);

protected:
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
    this->SetOutputs(cleansed.ct.GetPointer(), std::move(cleansed));
  }
};
} // namespace shapeton

#endif
