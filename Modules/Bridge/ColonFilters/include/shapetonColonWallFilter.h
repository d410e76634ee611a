#ifndef shapetonColonWallFilter_h
#define shapetonColonWallFilter_h

#include "shapetonColonWall.h"
#include "shapetonColonWallOptionsMethods.h"
#include "shapetonElectronicCleansing.h"
#include "shapetonStageFilter.h"

#include "itkMeshSource.h"

namespace shapeton
{
/** \class ColonWallFilter
 * \brief Pipeline filter for BuildColonWall(): the wall of a colon as a mesh.
 *
 * \par Inputs and Outputs
 * Either the input Cleansed, output 1 of ElectronicCleansingImageFilter, or the input Mask, a mask of the lumen. Input
 * Centerline: output of ColonCenterlineFilter. Outputs: 0 the simplified wall, for flattening, 1 the repaired one, 2
 * the raw one with its handles; 3 ColonWall with its report. A PipelineMesh stores all arrays.
 *
 * \ingroup ShapetonColonFilters */
template <typename TOutputMesh = PipelineMesh>
class ColonWallFilter
  : public ColonWallOptionsMethods<StageFilter<itk::MeshSource<TOutputMesh>,
                                               ColonWallSettings,
                                               TOutputMesh,
                                               TOutputMesh,
                                               TOutputMesh,
                                               ResultObject<ColonWall>>>
{
public:
  shapetonStageFilterMacro(ColonWallFilter);

  shapetonInputMacro(Cleansed, ResultObject<CleansedColon>);
  shapetonInputMacro(Mask, LumenMaskImage);
  shapetonRequiredInputMacro(Centerline, ResultObject<CurveSet>);
  shapetonOutputMacro(Wall, 3);

protected:
  void
  VerifyPreconditions() const override
  {
    Superclass::VerifyPreconditions();
    if ((this->GetCleansed() == nullptr) == (this->GetMask() == nullptr))
    {
      itkExceptionMacro("set one of the inputs Cleansed and Mask");
    }
  }

  void
  Compute() override
  {
    const auto       options = this->ReportingOptions();
    const CurveSet & line = this->GetCenterline()->Get();
    ColonWall        wall = this->GetMask() ? BuildColonWallFromMask(FromIndexZero(this->GetMask()), line, options)
                                            : BuildColonWall(this->GetCleansed()->Get().occupancy, line, options);
    this->SetOutputs(wall.simplified, wall.repaired, wall.raw, std::move(wall));
  }
};
} // namespace shapeton

#endif
