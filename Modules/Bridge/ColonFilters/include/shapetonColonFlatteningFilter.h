#ifndef shapetonColonFlatteningFilter_h
#define shapetonColonFlatteningFilter_h

#include "shapetonColonFlattening.h"
#include "shapetonFlatColon.h"
#include "shapetonMeshAdapter.h"
#include "shapetonStageFilter.h"

#include "itkMeshToMeshFilter.h"

namespace shapeton
{
/** \class ColonFlatteningFilter
 * \brief Pipeline filter of FlattenColon(): the flat map of a tube.
 *
 * \par Inputs and Outputs
 * Input: a tube, such as output 0 of ColonModelFilter. Optional input Centerline: identifies the rectum if the mesh
 * does not. Output 0: the tube cut open, its points in space, with the arrays of \ref FlatSurface; use a PipelineMesh.
 * Output 1: ColonFlattening. Output 2: FlatColon, the input of the filters for folds, landmarks, positions and
 * candidates.
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh, typename TOutputMesh = TInputMesh>
class ColonFlatteningFilter : public StageFilter<itk::MeshToMeshFilter<TInputMesh, TOutputMesh>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ColonFlatteningFilter);

  using Self = ColonFlatteningFilter;
  using Superclass = StageFilter<itk::MeshToMeshFilter<TInputMesh, TOutputMesh>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = ColonFlatteningOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ColonFlatteningFilter);

  itkSetInputMacro(Centerline, ResultObject<CurveSet>);
  itkGetInputMacro(Centerline, ResultObject<CurveSet>);

  /** \name See ColonFlatteningOptions for units, ranges and defaults */
  ///@{
  shapetonOptionMacro(Metric, metric);
  shapetonOptionMacro(Time, time);
  shapetonOptionMacro(Eigenpairs, eigenpairs);
  shapetonOptionMacro(RemoveHandles, removeHandles);
  itkBooleanMacro(RemoveHandles);
  ///@}

  ResultObject<ColonFlattening> *
  GetFlatteningOutput()
  {
    return static_cast<ResultObject<ColonFlattening> *>(this->itk::ProcessObject::GetOutput(1));
  }
  ResultObject<FlatColon> *
  GetFlatColonOutput()
  {
    return static_cast<ResultObject<FlatColon> *>(this->itk::ProcessObject::GetOutput(2));
  }

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType index) override
  {
    switch (index)
    {
      case 1:
        return ResultObject<ColonFlattening>::New().GetPointer();
      case 2:
        return ResultObject<FlatColon>::New().GetPointer();
      default:
        return Superclass::MakeOutput(index);
    }
  }

protected:
  ColonFlatteningFilter()
  {
    this->SetNumberOfRequiredOutputs(3);
    for (unsigned int i = 0; i < 3; ++i)
    {
      this->SetNthOutput(i, this->MakeOutput(i));
    }
  }
  ~ColonFlatteningFilter() override = default;

  void
  GenerateOutputInformation() override
  {} // information cannot be copied between different mesh types

  void
  Compute() override
  {
    ColonFlatteningOptions options = m_Options;
    options.progress = this->Reporter();
    if (this->GetCenterline())
    {
      options.centerline = this->GetCenterline()->Get();
    }
    ColonFlattening flattening = FlattenColon(SurfaceOf(*this->GetInput()), "the mesh", options);
    HandOver(flattening.map.flat, this->GetOutput());
    this->GetFlatColonOutput()->Set(std::make_shared<const FlatColon>(flattening.map.flat));
    this->SetResult(1, std::move(flattening));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Metric: " << static_cast<int>(m_Options.metric) << std::endl;
    os << indent << "Time: " << m_Options.time << std::endl;
    os << indent << "Eigenpairs: " << m_Options.eigenpairs << std::endl;
    os << indent << "RemoveHandles: " << m_Options.removeHandles << std::endl;
  }

private:
  OptionsType m_Options;
};

/** \class FlatColonFilter
 * \brief Makes a FlatColon, the input of the filters for folds, landmarks, positions and candidates, from a mesh with
 * the arrays of \ref FlatSurface, for example one read from a file or changed by other filters.
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh>
class FlatColonFilter : public StageFilter<itk::ProcessObject>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(FlatColonFilter);

  using Self = FlatColonFilter;
  using Superclass = StageFilter<itk::ProcessObject>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = FlatColonGridOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(FlatColonFilter);

  using Superclass::SetInput;
  void
  SetInput(const TInputMesh * mesh)
  {
    this->SetNthInput(0, const_cast<TInputMesh *>(mesh));
  }

  /** See FlatColonGridOptions. */
  shapetonOptionMacro(PixelSize, pixelSize);

  ResultObject<FlatColon> *
  GetOutput()
  {
    return static_cast<ResultObject<FlatColon> *>(this->itk::ProcessObject::GetOutput(0));
  }

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType) override
  {
    return ResultObject<FlatColon>::New().GetPointer();
  }

protected:
  FlatColonFilter()
  {
    this->SetNumberOfRequiredInputs(1);
    this->SetNthOutput(0, this->MakeOutput(0));
  }
  ~FlatColonFilter() override = default;

  void
  Compute() override
  {
    const auto * const mesh = static_cast<const TInputMesh *>(this->itk::ProcessObject::GetInput(0));
    const auto         flat = std::make_shared<const FlatColon>(SurfaceOf(*mesh), m_Options, "the mesh");
    flat->Grid(); // reject a mesh that is not flat here rather than later
    this->GetOutput()->Set(flat);
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "PixelSize: " << m_Options.pixelSize << std::endl;
  }

private:
  OptionsType m_Options;
};
} // namespace shapeton

#endif
