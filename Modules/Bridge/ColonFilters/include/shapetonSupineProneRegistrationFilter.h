#ifndef shapetonSupineProneRegistrationFilter_h
#define shapetonSupineProneRegistrationFilter_h

#include "ShapetonColonFiltersExport.h"

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
class ShapetonColonFilters_EXPORT SupineProneRegistrationFilter : public StageFilter<itk::ProcessObject>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SupineProneRegistrationFilter);

  using Self = SupineProneRegistrationFilter;
  using Superclass = StageFilter<itk::ProcessObject>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = SupineProneOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(SupineProneRegistrationFilter);

  itkSetInputMacro(Source, ResultObject<ColonPosition>);
  itkGetInputMacro(Source, ResultObject<ColonPosition>);
  itkSetInputMacro(Target, ResultObject<ColonPosition>);
  itkGetInputMacro(Target, ResultObject<ColonPosition>);

  /** \name See SupineProneOptions for ranges and defaults */
  ///@{
  shapetonOptionMacro(Map, map);
  shapetonOptionMacro(Matching, matching);
  shapetonOptionMacro(SegmentWise, isSegmentWise);
  itkBooleanMacro(SegmentWise);
  shapetonOptionMacro(Refine, refines);
  itkBooleanMacro(Refine);
  shapetonOptionMacro(GreatestDilatation, greatestDilatation);
  ///@}

  ResultObject<SupineProneRegistration> *
  GetOutput();

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  SupineProneRegistrationFilter();
  ~SupineProneRegistrationFilter() override = default;

  void
  Compute() override;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

private:
  OptionsType m_Options;
};
} // namespace shapeton

#endif
