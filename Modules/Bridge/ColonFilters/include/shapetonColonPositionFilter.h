#ifndef shapetonColonPositionFilter_h
#define shapetonColonPositionFilter_h

#include "shapetonColonLandmarks.h"
#include "shapetonColonPosition.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** Options of ColonPositionFilter. \ingroup ShapetonColonFilters */
struct ColonPositionFilterOptions
{
  /** Name in messages. */
  std::string positionName{ "the colon" };
};

/** \class ColonPositionFilter
 * \brief Pipeline filter of MakeColonPosition(): the colon in one position, prepared for registration.
 *
 * \par Inputs and Outputs
 * Inputs FlatColon, Centerline, Landmarks, Folds. Output: ColonPosition, the input of SupineProneRegistrationFilter.
 *
 * \ingroup ShapetonColonFilters */
class ColonPositionFilter
  : public StageFilter<itk::ProcessObject, ColonPositionFilterOptions, ResultObject<ColonPosition>>
{
public:
  shapetonStageFilterMacro(ColonPositionFilter);

  shapetonRequiredInputMacro(FlatColon, ResultObject<FlatColon>);
  shapetonRequiredInputMacro(Centerline, ResultObject<CurveSet>);
  shapetonRequiredInputMacro(Landmarks, ResultObject<ColonLandmarks>);
  shapetonRequiredInputMacro(Folds, ResultObject<HaustralFolds>);

  /** See ColonPositionFilterOptions. */
  shapetonOptionMacro(PositionName, positionName);

protected:
  void
  Compute() override
  {
    this->SetOutputs(MakeColonPosition(this->GetPositionName(),
                                       this->GetFlatColon()->Share(),
                                       this->GetCenterline()->Get(),
                                       this->GetLandmarks()->Get(),
                                       this->GetFolds()->Get().folds));
  }
};
} // namespace shapeton

#endif
