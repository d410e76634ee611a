#ifndef shapetonPolypCandidatesFilter_h
#define shapetonPolypCandidatesFilter_h

#include "shapetonColonLandmarks.h"
#include "shapetonColonModel.h"
#include "shapetonPolypSearch.h"
#include "shapetonPolypSearchOptionsMethods.h"
#include "shapetonPolypSensitivityOptionsMethods.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class PolypCandidatesFilter
 * \brief Pipeline filter for SearchPolyps(): polyp-like sites of the wall. For research use; a candidate is not a
 * finding.
 *
 * \par Inputs and Outputs
 * Input: the repaired wall, such as output 1 of ColonModelFilter. Input Model: its ColonModel, with lumen, cleansed CT,
 * centerline and catheter. Optional inputs: FlatColon, for positions on the map, and with it Landmarks, for segments.
 * Output: the candidates in order of decreasing score.
 *
 * This filter measures the attenuation of heads on the unrounded CT; the tool ColonPolyps reads a CT rounded to whole
 * HU.
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh>
class PolypCandidatesFilter
  : public PolypSearchOptionsMethods<PolypSensitivityOptionsMethods<
      StageFilter<itk::ProcessObject, PolypSearchSettings, ResultObject<std::vector<PolypCandidate>>>>>
{
public:
  shapetonStageFilterMacro(PolypCandidatesFilter);

  using CandidatesType = std::vector<PolypCandidate>;

  using Superclass::SetInput;
  shapetonRequiredInputMacro(Input, TInputMesh);
  shapetonRequiredInputMacro(Model, ResultObject<ColonModel>);
  shapetonInputMacro(FlatColon, ResultObject<FlatColon>);
  shapetonInputMacro(Landmarks, ResultObject<ColonLandmarks>);

protected:
  void
  VerifyPreconditions() const override
  {
    Superclass::VerifyPreconditions();
    if (this->GetLandmarks() && !this->GetFlatColon())
    {
      itkExceptionMacro("the input Landmarks requires the input FlatColon");
    }
  }

  void
  Compute() override
  {
    this->SetOutputs(SearchPolyps(this->Colon(), this->ReportingOptions()));
  }

private:
  PolypColon
  Colon() const
  {
    const ColonModel & model = this->GetModel()->Get();
    PolypColon         colon;
    colon.wall = SurfaceOf(*this->GetInput());
    colon.centerline = model.centerline.curve;
    if (model.lumen.catheter && model.lumen.catheter->isSure)
    {
      colon.catheter = CurveOfCatheter(*model.lumen.catheter);
    }
    colon.lumen = model.lumen.labels;
    colon.ct = model.cleansed;
    if (this->GetFlatColon())
    {
      colon.flat = this->GetFlatColon()->Share();
    }
    if (this->GetLandmarks())
    {
      colon.segments = SegmentSurface(colon.flat->Surface(), this->GetLandmarks()->Get());
    }
    return colon;
  }
};
} // namespace shapeton

#endif
