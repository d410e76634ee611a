#ifndef shapetonColonPositionFilter_h
#define shapetonColonPositionFilter_h

#include "shapetonColonLandmarks.h"
#include "shapetonColonPosition.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class ColonPositionFilter
 * \brief Pipeline filter for MakeColonPosition(): the colon in one position, prepared for registration.
 *
 * \par Inputs and Outputs
 * Inputs FlatColon, Centerline, Landmarks, Folds. Output: ColonPosition, the input of SupineProneRegistrationFilter.
 *
 * \ingroup ShapetonColonFilters */
class ColonPositionFilter : public StageFilter<itk::ProcessObject, NoOptions, ResultObject<ColonPosition>>
{
public:
  shapetonStageFilterMacro(ColonPositionFilter);

  shapetonRequiredInputMacro(FlatColon, ResultObject<FlatColon>);
  shapetonRequiredInputMacro(Centerline, ResultObject<CurveSet>);
  shapetonRequiredInputMacro(Landmarks, ResultObject<ColonLandmarks>);
  shapetonRequiredInputMacro(Folds, ResultObject<HaustralFolds>);

  /** Name in messages. Default "the colon". */
  itkSetStringMacro(PositionName);
  itkGetStringMacro(PositionName);

protected:
  void
  Compute() override
  {
    this->SetOutputs(MakeColonPosition(m_PositionName,
                                       this->GetFlatColon()->Share(),
                                       this->GetCenterline()->Get(),
                                       this->GetLandmarks()->Get(),
                                       this->GetFolds()->Get().folds));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "PositionName: " << m_PositionName << std::endl;
  }

private:
  std::string m_PositionName{ "the colon" };
};
} // namespace shapeton

#endif
