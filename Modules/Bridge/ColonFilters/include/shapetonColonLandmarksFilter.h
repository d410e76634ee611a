#ifndef shapetonColonLandmarksFilter_h
#define shapetonColonLandmarksFilter_h

#include "ShapetonColonFiltersExport.h"

#include "shapetonColonLandmarks.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class ColonLandmarksFilter
 * \brief Pipeline filter of FindColonLandmarks(): flexures, segments and taeniae of a flat colon.
 *
 * \par Inputs and Outputs
 * Inputs FlatColon and Centerline. Output 0: ColonLandmarks. Output 1: the taeniae as curves, CurveSet; empty if they
 * were not found.
 *
 * \ingroup ShapetonColonFilters */
class ShapetonColonFilters_EXPORT ColonLandmarksFilter : public StageFilter<itk::ProcessObject>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ColonLandmarksFilter);

  using Self = ColonLandmarksFilter;
  using Superclass = StageFilter<itk::ProcessObject>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = ColonLandmarkOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ColonLandmarksFilter);

  itkSetInputMacro(FlatColon, ResultObject<FlatColon>);
  itkGetInputMacro(FlatColon, ResultObject<FlatColon>);
  itkSetInputMacro(Centerline, ResultObject<CurveSet>);
  itkGetInputMacro(Centerline, ResultObject<CurveSet>);

  /** \name See ColonLandmarkOptions */
  ///@{
  shapetonOptionMacro(FlexureRule, flexureRule);
  shapetonOptionMacro(TaeniaRule, taeniaRule);
  shapetonOptionMacro(Markers, markers);
  ///@}

  ResultObject<ColonLandmarks> *
  GetOutput();
  ResultObject<CurveSet> *
  GetTaeniaeOutput();

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  ColonLandmarksFilter();
  ~ColonLandmarksFilter() override = default;

  void
  Compute() override;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

private:
  OptionsType m_Options;
};
} // namespace shapeton

#endif
