#ifndef shapetonSupineProneRegistrationFilter_h
#define shapetonSupineProneRegistrationFilter_h

#include "shapetonStageFilter.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** \class SupineProneRegistrationFilter
 * \brief Pipeline filter of RegisterColonPositions(): the map between the walls of a colon in two positions.
 *
 * \par Inputs and Outputs
 * Inputs Source and Target, each the output of a ColonPositionFilter. Output: SupineProneRegistration.
 *
 * \ingroup ShapetonColonFilters */
class SupineProneRegistrationFilter
  : public StageFilter<itk::ProcessObject, SupineProneOptions, ResultObject<SupineProneRegistration>>
{
public:
  shapetonStageFilterMacro(SupineProneRegistrationFilter);

  shapetonRequiredInputMacro(Source, ResultObject<ColonPosition>);
  shapetonRequiredInputMacro(Target, ResultObject<ColonPosition>);

  /** \name See SupineProneOptions for ranges and defaults */
  ///@{
  shapetonEnumOptionMacro(Map, map, "Default", "Published");
  shapetonEnumOptionMacro(Matching, matching, "Hungarian", "DualDecomposition");
  shapetonOptionMacro(SegmentWise, isSegmentWise);
  itkBooleanMacro(SegmentWise);
  shapetonOptionMacro(Refine, refines);
  itkBooleanMacro(Refine);
  shapetonOptionMacro(GreatestDilatation, greatestDilatation);
  ///@}

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
