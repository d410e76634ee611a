#ifndef shapetonSupineProneRegistrationFilter_h
#define shapetonSupineProneRegistrationFilter_h

#include "shapetonStageFilter.h"
#include "shapetonSupineProneOptionsMethods.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** \class SupineProneRegistrationFilter
 * \brief Pipeline filter for RegisterColonPositions(): the map between the walls of a colon in two positions.
 *
 * \par Inputs and Outputs
 * Inputs Source and Target, each the output of a ColonPositionFilter. Output: SupineProneRegistration.
 *
 * \ingroup ShapetonColonFilters */
class SupineProneRegistrationFilter
  : public SupineProneOptionsMethods<
      StageFilter<itk::ProcessObject, SupineProneSettings, ResultObject<SupineProneRegistration>>>
{
public:
  shapetonStageFilterMacro(SupineProneRegistrationFilter);

  shapetonRequiredInputMacro(Source, ResultObject<ColonPosition>);
  shapetonRequiredInputMacro(Target, ResultObject<ColonPosition>);

protected:
  void
  Compute() override
  {
    this->SetOutputs(
      RegisterColonPositions(this->GetSource()->Get(), this->GetTarget()->Get(), this->ReportingOptions()));
  }
};
} // namespace shapeton

#endif
