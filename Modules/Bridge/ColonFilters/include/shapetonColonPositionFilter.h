#ifndef shapetonColonPositionFilter_h
#define shapetonColonPositionFilter_h

#include "ShapetonColonFiltersExport.h"

#include "shapetonColonLandmarks.h"
#include "shapetonColonPosition.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class ColonPositionFilter
 * \brief Pipeline filter of MakeColonPosition(): the colon in one position, prepared for registration.
 *
 * \par Inputs and Outputs
 * Inputs FlatColon, Centerline, Landmarks, Folds. Output: ColonPosition, the input of SupineProneRegistrationFilter.
 *
 * \ingroup ShapetonColonFilters */
class ShapetonColonFilters_EXPORT ColonPositionFilter : public StageFilter<itk::ProcessObject>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ColonPositionFilter);

  using Self = ColonPositionFilter;
  using Superclass = StageFilter<itk::ProcessObject>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ColonPositionFilter);

  itkSetInputMacro(FlatColon, ResultObject<FlatColon>);
  itkGetInputMacro(FlatColon, ResultObject<FlatColon>);
  itkSetInputMacro(Centerline, ResultObject<CurveSet>);
  itkGetInputMacro(Centerline, ResultObject<CurveSet>);
  itkSetInputMacro(Landmarks, ResultObject<ColonLandmarks>);
  itkGetInputMacro(Landmarks, ResultObject<ColonLandmarks>);
  itkSetInputMacro(Folds, ResultObject<HaustralFolds>);
  itkGetInputMacro(Folds, ResultObject<HaustralFolds>);

  /** Name in messages. Default "the colon". */
  itkSetStringMacro(PositionName);
  itkGetStringMacro(PositionName);

  ResultObject<ColonPosition> *
  GetOutput();

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  ColonPositionFilter();
  ~ColonPositionFilter() override = default;

  void
  Compute() override;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

private:
  std::string m_PositionName{ "the colon" };
};
} // namespace shapeton

#endif
