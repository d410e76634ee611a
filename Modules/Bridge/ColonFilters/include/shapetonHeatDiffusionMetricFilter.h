#ifndef shapetonHeatDiffusionMetricFilter_h
#define shapetonHeatDiffusionMetricFilter_h

#include "shapetonHeatDiffusionMetric.h"
#include "shapetonMeshAdapter.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class HeatDiffusionMetricFilter
 * \brief Pipeline filter of ComputeHeatDiffusionMetric(): the heat diffusion distances of the edges of a mesh.
 *
 * \par Inputs and Outputs
 * Input: a triangle mesh, a single manifold. Output: HeatDiffusionMetric, with the edges of SurfaceConnectivity of the
 * mesh (SurfaceOf()).
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh>
class HeatDiffusionMetricFilter : public StageFilter<itk::ProcessObject>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(HeatDiffusionMetricFilter);

  using Self = HeatDiffusionMetricFilter;
  using Superclass = StageFilter<itk::ProcessObject>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(HeatDiffusionMetricFilter);

  using Superclass::SetInput;
  void
  SetInput(const TInputMesh * mesh)
  {
    this->SetNthInput(0, const_cast<TInputMesh *>(mesh));
  }

  /** Diffusion time (mm^2), positive; DefaultDiffusionTime() suits tubes. Default 1. */
  itkSetMacro(Time, double);
  itkGetConstMacro(Time, double);

  ResultObject<HeatDiffusionMetric> *
  GetOutput()
  {
    return static_cast<ResultObject<HeatDiffusionMetric> *>(this->itk::ProcessObject::GetOutput(0));
  }

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType) override
  {
    return ResultObject<HeatDiffusionMetric>::New().GetPointer();
  }

protected:
  HeatDiffusionMetricFilter()
  {
    this->SetNumberOfRequiredInputs(1);
    this->SetNthOutput(0, this->MakeOutput(0));
  }
  ~HeatDiffusionMetricFilter() override = default;

  void
  Compute() override
  {
    const auto * const mesh = static_cast<const TInputMesh *>(this->itk::ProcessObject::GetInput(0));
    const Progress     progress = this->Reporter().Part("Metric", 0.0, 1.0);
    this->SetResult(0, ComputeHeatDiffusionMetric(SurfaceOf(*mesh), m_Time, progress));
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
