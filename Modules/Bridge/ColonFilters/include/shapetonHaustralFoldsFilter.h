#ifndef shapetonHaustralFoldsFilter_h
#define shapetonHaustralFoldsFilter_h

#include "shapetonFlatCoordinateMap.h"
#include "shapetonHaustralFoldOptionsMethods.h"
#include "shapetonHaustralFolds.h"
#include "shapetonStageFilter.h"

#include "itkImageSource.h"

namespace shapeton
{
/** \class HaustralFoldsFilter
 * \brief Pipeline filter for FindHaustralFolds(): the haustral folds on the flat map of a colon.
 *
 * \par Inputs and Outputs
 * Input FlatColon. Optional input Taeniae, curves on the wall that split folds. Output 0: labels on the grid of the
 * flat colon. The grid size is known only once the flat colon exists, so UpdateOutputInformation() updates the input.
 * Output 1: HaustralFolds.
 *
 * \ingroup ShapetonColonFilters */
class HaustralFoldsFilter
  : public HaustralFoldOptionsMethods<StageFilter<itk::ImageSource<itk::Image<unsigned short, 2>>,
                                                  HaustralFoldSettings,
                                                  itk::Image<unsigned short, 2>,
                                                  ResultObject<HaustralFolds>>>
{
public:
  shapetonStageFilterMacro(HaustralFoldsFilter);

  shapetonRequiredInputMacro(FlatColon, ResultObject<FlatColon>);
  shapetonInputMacro(Taeniae, ResultObject<CurveSet>);
  shapetonOutputMacro(Folds, 1);

protected:
  void
  GenerateOutputInformation() override
  {
    const_cast<ResultObject<FlatColon> *>(this->GetFlatColon())->Update();
    SetFlatSpace(this->GetFlatColon()->Get().Grid(), this->GetOutput());
  }

  void
  Compute() override
  {
    HaustralFoldSettings options = this->ReportingOptions();
    options.progress = options.progress.Part("Folds", 0.0, 1.0);
    options.taeniae = this->GetTaeniae() ? &this->GetTaeniae()->Get() : nullptr;
    HaustralFolds folds = FindHaustralFolds(this->GetFlatColon()->Get(), options);
    this->SetOutputs(folds.labels.GetPointer(), std::move(folds));
  }
};
} // namespace shapeton

#endif
