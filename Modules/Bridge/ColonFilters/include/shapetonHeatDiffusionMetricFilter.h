#ifndef shapetonHeatDiffusionMetricFilter_h
#define shapetonHeatDiffusionMetricFilter_h

#include "shapetonHeatDiffusionMetric.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class HeatDiffusionMetricFilter
 * \brief Pipeline filter for ComputeHeatDiffusionMetric(): the heat diffusion distances of the edges of a mesh.
 *
 * \par Inputs and Outputs
 * Input: a triangle mesh, a single manifold. Output: HeatDiffusionMetric, with the edges of SurfaceConnectivity of the
 * mesh (SurfaceOf()).
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh>
class HeatDiffusionMetricFilter : public StageFilter<itk::ProcessObject, NoOptions, ResultObject<HeatDiffusionMetric>>
{
public:
  shapetonStageFilterMacro(HeatDiffusionMetricFilter);

  using Superclass::SetInput;
  shapetonRequiredInputMacro(Input, TInputMesh);

  /** Diffusion time (mm^2), positive; DefaultDiffusionTime() suits tubes. Default 1. */
  itkSetMacro(Time, double);
  itkGetConstMacro(Time, double);

protected:
  void
  Compute() override
  {
    const Progress progress = this->Reporter().Part("Metric", 0.0, 1.0);
    this->SetOutputs(ComputeHeatDiffusionMetric(SurfaceOf(*this->GetInput()), m_Time, progress));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Time: " << m_Time << std::endl;
  }

private:
  double m_Time{ 1.0 };
};
} // namespace shapeton

#endif
