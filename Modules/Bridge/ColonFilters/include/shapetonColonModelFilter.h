#ifndef shapetonColonModelFilter_h
#define shapetonColonModelFilter_h

#include "shapetonColonModel.h"
#include "shapetonExceptions.h"
#include "shapetonMeshAdapter.h"
#include "shapetonStageFilter.h"
#include "shapetonVolume.h"

#include "itkImageToMeshFilter.h"

namespace shapeton
{
/** \class ColonModelFilter
 * \brief Pipeline filter of BuildColonModel(), the core of the tool ColonSegmentation: from a CT colonography to the
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
class ColonModelFilter : public StageFilter<itk::ImageToMeshFilter<TInputImage, TOutputMesh>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ColonModelFilter);

  using Self = ColonModelFilter;
  using Superclass = StageFilter<itk::ImageToMeshFilter<TInputImage, TOutputMesh>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = ColonModelOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ColonModelFilter);

  itkSetInputMacro(LumenMask, LumenMaskImage);
  itkGetInputMacro(LumenMask, LumenMaskImage);

  /** \name See ColonModelOptions */
  ///@{
  shapetonOptionMacro(PatientPosition, patientPosition);
  shapetonOptionMacro(SeedPoints, seedPoints);
  shapetonOptionMacro(NumberOfFaces, faces);
  shapetonOptionMacro(KeepPieces, keepPieces);
  itkBooleanMacro(KeepPieces);
  ///@}

  using itk::MeshSource<TOutputMesh>::GetOutput; // for any index
  ResultObject<CurveSet> *
  GetCenterlineOutput()
  {
    return static_cast<ResultObject<CurveSet> *>(this->itk::ProcessObject::GetOutput(3));
  }
  ResultObject<ColonModel> *
  GetModelOutput()
  {
    return static_cast<ResultObject<ColonModel> *>(this->itk::ProcessObject::GetOutput(4));
  }

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType index) override
  {
    switch (index)
    {
      case 3:
        return ResultObject<CurveSet>::New().GetPointer();
      case 4:
        return ResultObject<ColonModel>::New().GetPointer();
      default:
        return Superclass::MakeOutput(index);
    }
  }

protected:
  ColonModelFilter()
  {
    this->SetNumberOfRequiredOutputs(5);
    for (unsigned int i = 0; i < 5; ++i)
    {
      this->SetNthOutput(i, this->MakeOutput(i));
    }
  }
  ~ColonModelFilter() override = default;

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
    ColonModelOptions options = m_Options;
    options.progress = this->Reporter();
    const auto ct = FloatsFromIndexZero(this->GetInput());
    ColonModel model = this->GetLumenMask() ? BuildColonModel(ct, FromIndexZero(this->GetLumenMask()), options)
                                            : BuildColonModel(ct, options);
    if (!model.failure.empty())
    {
      throw InputError(model.failure);
    }
    HandOver(model.wall.simplified, this->GetOutput(0));
    HandOver(model.wall.repaired, this->GetOutput(1));
    HandOver(model.wall.raw, this->GetOutput(2));
    this->SetResult(3, CurveSet(model.centerline.curve));
    this->SetResult(4, std::move(model));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "PatientPosition: " << m_Options.patientPosition << std::endl;
    os << indent << "SeedPoints: " << m_Options.seedPoints.size() << std::endl;
    os << indent << "NumberOfFaces: " << m_Options.faces << std::endl;
    os << indent << "KeepPieces: " << m_Options.keepPieces << std::endl;
  }

private:
  OptionsType m_Options;
};
} // namespace shapeton

#endif
