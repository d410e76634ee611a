#ifndef shapetonColonWallFilter_h
#define shapetonColonWallFilter_h

#include "shapetonColonWall.h"
#include "shapetonElectronicCleansing.h"
#include "shapetonMeshAdapter.h"
#include "shapetonStageFilter.h"

#include "itkMeshSource.h"

namespace shapeton
{
/** \class ColonWallFilter
 * \brief Pipeline filter of BuildColonWall(): the wall of a colon as a mesh.
 *
 * \par Inputs and Outputs
 * Either the input Cleansed, output 1 of ElectronicCleansingImageFilter, or the input Mask, a mask of the lumen. Input
 * Centerline: output of ColonCenterlineFilter. Outputs: 0 the simplified wall, for flattening, 1 the repaired one, 2
 * the raw one with its handles; 3 ColonWall with its report. A PipelineMesh stores all arrays.
 *
 * \ingroup ShapetonColonFilters */
template <typename TOutputMesh = PipelineMesh>
class ColonWallFilter : public StageFilter<itk::MeshSource<TOutputMesh>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ColonWallFilter);

  using Self = ColonWallFilter;
  using Superclass = StageFilter<itk::MeshSource<TOutputMesh>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = ColonWallOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ColonWallFilter);

  itkSetInputMacro(Cleansed, ResultObject<CleansedColon>);
  itkGetInputMacro(Cleansed, ResultObject<CleansedColon>);
  itkSetInputMacro(Mask, LumenMaskImage);
  itkGetInputMacro(Mask, LumenMaskImage);
  itkSetInputMacro(Centerline, ResultObject<CurveSet>);
  itkGetInputMacro(Centerline, ResultObject<CurveSet>);

  /** \name See ColonWallOptions for units, ranges and defaults */
  ///@{
  shapetonOptionMacro(NumberOfFaces, faces);
  shapetonOptionMacro(BridgeRadius, bridgeRadius);
  shapetonOptionMacro(NormalLimit, normalLimit);
  shapetonOptionMacro(TangentialLimit, tangentialLimit);
  shapetonOptionMacro(KeepPieces, keepPieces);
  itkBooleanMacro(KeepPieces);
  shapetonOptionMacro(MaskSmoothing, maskSmoothing);
  ///@}

  ResultObject<ColonWall> *
  GetWallOutput()
  {
    return static_cast<ResultObject<ColonWall> *>(this->itk::ProcessObject::GetOutput(3));
  }

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType index) override
  {
    return index == 3 ? itk::DataObject::Pointer(ResultObject<ColonWall>::New()) : Superclass::MakeOutput(index);
  }

protected:
  ColonWallFilter()
  {
    this->SetPrimaryInputName("Centerline");
    this->SetNumberOfRequiredInputs(1);
    this->SetNumberOfRequiredOutputs(4);
    for (unsigned int i = 0; i < 4; ++i)
    {
      this->SetNthOutput(i, this->MakeOutput(i));
    }
  }
  ~ColonWallFilter() override = default;

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
  GenerateOutputInformation() override
  {} // the centerline has no information to copy to a mesh

  void
  Compute() override
  {
    ColonWallOptions options = m_Options;
    options.progress = this->Reporter();
    const CurveSet & line = this->GetCenterline()->Get();
    ColonWall        wall = this->GetMask() ? BuildColonWallFromMask(FromIndexZero(this->GetMask()), line, options)
                                            : BuildColonWall(this->GetCleansed()->Get().occupancy, line, options);
    HandOver(wall.simplified, this->GetOutput(0));
    HandOver(wall.repaired, this->GetOutput(1));
    HandOver(wall.raw, this->GetOutput(2));
    this->SetResult(3, std::move(wall));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "NumberOfFaces: " << m_Options.faces << std::endl;
    os << indent << "BridgeRadius: " << m_Options.bridgeRadius << std::endl;
    os << indent << "NormalLimit: " << m_Options.normalLimit << std::endl;
    os << indent << "TangentialLimit: " << m_Options.tangentialLimit << std::endl;
    os << indent << "KeepPieces: " << m_Options.keepPieces << std::endl;
    os << indent << "MaskSmoothing: " << m_Options.maskSmoothing << std::endl;
  }

private:
  OptionsType m_Options;
};
} // namespace shapeton

#endif
