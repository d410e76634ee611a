#ifndef shapetonColonFlatteningFilter_h
#define shapetonColonFlatteningFilter_h

#include "shapetonColonFlattening.h"
#include "shapetonColonFlatteningOptionsMethods.h"
#include "shapetonFlatColon.h"
#include "shapetonFlatColonGridOptionsMethods.h"
#include "shapetonStageFilter.h"

#include "itkMeshToMeshFilter.h"

namespace shapeton
{
/** \class ColonFlatteningFilter
 * \brief Pipeline filter for FlattenColon(): the flat map of a tube.
 *
 * \par Inputs and Outputs
 * Input: a tube, such as output 0 of ColonModelFilter. Optional input Centerline: identifies the rectum if the mesh
 * does not. Output 0: the tube cut open, its points in space, with the arrays of \ref FlatSurface; use a PipelineMesh.
 * Output 1: ColonFlattening. Output 2: FlatColon, the input of the filters for folds, landmarks, positions and
 * candidates.
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh, typename TOutputMesh = TInputMesh>
class ColonFlatteningFilter
  : public ColonFlatteningOptionsMethods<StageFilter<itk::MeshToMeshFilter<TInputMesh, TOutputMesh>,
                                                     ColonFlatteningSettings,
                                                     TOutputMesh,
                                                     ResultObject<ColonFlattening>,
                                                     ResultObject<FlatColon>>>
{
public:
  shapetonStageFilterMacro(ColonFlatteningFilter);

  shapetonInputMacro(Centerline, ResultObject<CurveSet>);
  shapetonOutputMacro(Flattening, 1);
  shapetonOutputMacro(FlatColon, 2);

protected:
  void
  Compute() override
  {
    ColonFlatteningSettings options = this->ReportingOptions();
    if (this->GetCenterline())
    {
      options.centerline = this->GetCenterline()->Get();
    }
    ColonFlattening flattening = FlattenColon(SurfaceOf(*this->GetInput()), "the mesh", options);
    const auto      flat = std::make_shared<const FlatColon>(flattening.map.flat);
    this->SetOutputs(flattening.map.flat, std::move(flattening), flat);
  }
};

/** \class FlatColonFilter
 * \brief Makes a FlatColon from a mesh with the arrays of \ref FlatSurface, for example one read from a file or changed
 * by other filters: the input of the filters for folds, landmarks, positions and candidates.
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh>
class FlatColonFilter
  : public FlatColonGridOptionsMethods<StageFilter<itk::ProcessObject, FlatColonGridOptions, ResultObject<FlatColon>>>
{
public:
  shapetonStageFilterMacro(FlatColonFilter);

  using Superclass::SetInput;
  shapetonRequiredInputMacro(Input, TInputMesh);

protected:
  void
  Compute() override
  {
    const auto flat = std::make_shared<const FlatColon>(SurfaceOf(*this->GetInput()), this->m_Options, "the mesh");
    flat->Grid(); // reject a mesh that is not flat here rather than later
    this->SetOutputs(flat);
  }
};
} // namespace shapeton

#endif
