#ifndef shapetonColonLandmarksFilter_h
#define shapetonColonLandmarksFilter_h

#include "shapetonColonLandmarkOptionsMethods.h"
#include "shapetonColonLandmarks.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class ColonLandmarksFilter
 * \brief Pipeline filter for FindColonLandmarks(): flexures, segments and taeniae of a flat colon.
 *
 * \par Inputs and Outputs
 * Inputs FlatColon and Centerline. Output 0: ColonLandmarks. Output 1: the taeniae as curves, CurveSet; empty if they
 * were not found.
 *
 * \ingroup ShapetonColonFilters */
class ColonLandmarksFilter
  : public ColonLandmarkOptionsMethods<
      StageFilter<itk::ProcessObject, ColonLandmarkSettings, ResultObject<ColonLandmarks>, ResultObject<CurveSet>>>
{
public:
  shapetonStageFilterMacro(ColonLandmarksFilter);

  shapetonRequiredInputMacro(FlatColon, ResultObject<FlatColon>);
  shapetonRequiredInputMacro(Centerline, ResultObject<CurveSet>);
  shapetonOutputMacro(Taeniae, 1);

  /** See ColonLandmarkSettings. */
  void
  SetMarkers(const std::vector<Eigen::Vector3d> & markers)
  {
    this->SetOption(this->m_Options.markers, markers);
  }
  const std::vector<Eigen::Vector3d> &
  GetMarkers() const
  {
    return this->m_Options.markers;
  }

protected:
  void
  Compute() override
  {
    ColonLandmarks landmarks =
      FindColonLandmarks(this->GetFlatColon()->Get(), this->GetCenterline()->Get(), this->ReportingOptions());
    CurveSet taeniae = landmarks.taeniae.taeniae.empty() ? CurveSet() : TaeniaCurves(landmarks.taeniae);
    this->SetOutputs(std::move(landmarks), std::move(taeniae));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Markers: " << this->m_Options.markers.size() << std::endl;
  }
};
} // namespace shapeton

#endif
