#ifndef shapetonColonModelFilter_h
#define shapetonColonModelFilter_h

#include "shapetonColonLumenOptionsMethods.h"
#include "shapetonColonModel.h"
#include "shapetonColonWallOptionsMethods.h"
#include "shapetonImageGrid.h"
#include "shapetonStageFilter.h"

#include "itkImageToMeshFilter.h"

namespace shapeton
{
/** \class ColonModelFilter
 * \brief Pipeline filter for BuildColonModel(), the core of the tool ColonSegmentation: from a CT colonography to the
 * wall of the colon.
 *
 * Combines ColonLumenImageFilter, ElectronicCleansingImageFilter, ColonCenterlineFilter and ColonWallFilter, finds the
 * ileocecal valve, and cuts off the terminal ileum.
 *
 * \par Inputs and Outputs
 * Input: a CT in HU, scalar voxels of any type. Optional input LumenMask: replaces the automatic lumen, on the grid of
 * the CT. Outputs: 0 the simplified wall, 1 the repaired one, 2 the raw one; 3 the centerline, CurveSet; 4 the complete
 * ColonModel, whose images start at index 0.
 *
 * Throws InputError if no prepared colon is found or the mask is on another grid, and the exceptions of
 * BuildColonModel().
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputImage, typename TOutputMesh = PipelineMesh>
class ColonModelFilter
  : public ColonWallOptionsMethods<
      ColonLumenOptionsMethods<StageFilter<itk::ImageToMeshFilter<TInputImage, TOutputMesh>,
                                           ColonModelSettings,
                                           TOutputMesh,
                                           TOutputMesh,
                                           TOutputMesh,
                                           ResultObject<CurveSet>,
                                           ResultObject<ColonModel>>>>
{
public:
  shapetonStageFilterMacro(ColonModelFilter);

  shapetonInputMacro(LumenMask, LumenMaskImage);
  using itk::MeshSource<TOutputMesh>::GetOutput; // for any index
  shapetonOutputMacro(Centerline, 3);
  shapetonOutputMacro(Model, 4);

protected:
  void
  VerifyInputInformation() const override
  {
    Superclass::VerifyInputInformation();
    const auto * const ct = static_cast<const TInputImage *>(this->itk::ProcessObject::GetInput(0));
    if (this->GetLumenMask() && !HaveSameGrid(ct, this->GetLumenMask()))
    {
      throw InputError("the lumen mask and the CT have different grids: use a mask on the grid of the CT");
    }
  }

  void
  Compute() override
  {
    const auto options = this->ReportingOptions();
    const auto ct = FloatsFromIndexZero(this->GetInput());
    ColonModel model = this->GetLumenMask() ? BuildColonModel(ct, FromIndexZero(this->GetLumenMask()), options)
                                            : BuildColonModel(ct, options);
    RequireSuccess(model);
    const ColonWall & wall = model.wall;
    this->SetOutputs(wall.simplified, wall.repaired, wall.raw, model.centerline.curve, std::move(model));
  }
};
} // namespace shapeton

#endif
