#ifndef shapetonHeatDiffusionMetricFilter_h
#define shapetonHeatDiffusionMetricFilter_h

#include "shapetonHeatDiffusionMetric.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** Options of HeatDiffusionMetricFilter. \ingroup ShapetonColonFilters */
struct HeatDiffusionMetricFilterOptions
{
  /** Diffusion time (mm^2), positive; DefaultDiffusionTime() suits tubes. */
  double time{ 1.0 };
};

/** \class HeatDiffusionMetricFilter
 * \brief Pipeline filter of ComputeHeatDiffusionMetric(): the heat diffusion distances of the edges of a mesh.
 *
 * \par Inputs and Outputs
 * Input: a triangle mesh, a single manifold. Output: HeatDiffusionMetric, with the edges of SurfaceConnectivity of the
 * mesh (SurfaceOf()).
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh>
class HeatDiffusionMetricFilter
  : public StageFilter<itk::ProcessObject, HeatDiffusionMetricFilterOptions, ResultObject<HeatDiffusionMetric>>
{
public:
  shapetonStageFilterMacro(HeatDiffusionMetricFilter);

  using Superclass::SetInput;
  shapetonRequiredInputMacro(Input, TInputMesh);

  /** See HeatDiffusionMetricFilterOptions. */
  shapetonOptionMacro(Time, time);

protected:
  void
  Compute() override
  {
    const Progress progress = this->Reporter().Part("Metric", 0.0, 1.0);
    this->SetOutputs(ComputeHeatDiffusionMetric(SurfaceOf(*this->GetInput()), this->GetTime(), progress));
  }
};
} // namespace shapeton

#endif
