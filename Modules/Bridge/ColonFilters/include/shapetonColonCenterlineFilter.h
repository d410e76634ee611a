#ifndef shapetonColonCenterlineFilter_h
#define shapetonColonCenterlineFilter_h

#include "ShapetonColonFiltersExport.h"

#include "shapetonColonCenterline.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class ColonCenterlineFilter
 * \brief Pipeline filter of TraceColonCenterline(): the centerline of a colon from the labels of its lumen.
 *
 * \par Inputs and Outputs
 * Input: labels or a mask; nonzero voxels are lumen. Output 0: the curve, CurveSet. Output 1: ColonCenterline with
 * gaps, pieces and further results.
 *
 * \ingroup ShapetonColonFilters */
class ShapetonColonFilters_EXPORT ColonCenterlineFilter : public StageFilter<itk::ProcessObject>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ColonCenterlineFilter);

  using Self = ColonCenterlineFilter;
  using Superclass = StageFilter<itk::ProcessObject>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = ColonCenterlineOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ColonCenterlineFilter);

  using Superclass::SetInput;
  void
  SetInput(const LumenMask * labels);
  const LumenMask *
  GetInput() const;

  /** \name See ColonCenterlineOptions for units, ranges and defaults */
  ///@{
  shapetonOptionMacro(Exponent, exponent);
  shapetonOptionMacro(Start, start);
  shapetonOptionMacro(SeedPoints, seedPoints);
  shapetonOptionMacro(MinimumVolume, minimumVolume);
  shapetonOptionMacro(MinimumExtent, minimumExtent);
  shapetonOptionMacro(Step, step);
  shapetonOptionMacro(Smoothing, smoothing);
  shapetonOptionMacro(GapRadius, gapRadius);
  ///@}

  ResultObject<CurveSet> *
  GetOutput();
  ResultObject<ColonCenterline> *
  GetCenterlineOutput();

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  ColonCenterlineFilter();
  ~ColonCenterlineFilter() override = default;

  void
  Compute() override;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

private:
  OptionsType m_Options;
};
} // namespace shapeton

#endif
