#ifndef shapetonColonCenterlineFilter_h
#define shapetonColonCenterlineFilter_h

#include "shapetonColonCenterline.h"
#include "shapetonColonCenterlineOptionsMethods.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class ColonCenterlineFilter
 * \brief Pipeline filter for TraceColonCenterline(): the centerline of a colon from the labels of its lumen.
 *
 * \par Inputs and Outputs Input: labels or a mask; nonzero voxels are lumen. Output 0: the curve, CurveSet. Output 1:
 * ColonCenterline with gaps, pieces and other results.
 *
 * \ingroup ShapetonColonFilters */
class ColonCenterlineFilter
  : public ColonCenterlineOptionsMethods<
      StageFilter<itk::ProcessObject, ColonCenterlineSettings, ResultObject<CurveSet>, ResultObject<ColonCenterline>>>
{
public:
  shapetonStageFilterMacro(ColonCenterlineFilter);

  using Superclass::SetInput;
  shapetonRequiredInputMacro(Input, LumenMask);
  shapetonOutputMacro(Centerline, 1);

protected:
  void
  Compute() override
  {
    ColonCenterline centerline = TraceColonCenterline(FromIndexZero(this->GetInput()), this->ReportingOptions());
    RequireSuccess(centerline);
    this->SetOutputs(centerline.curve, std::move(centerline));
  }
};
} // namespace shapeton

#endif
