#ifndef shapetonPolypCandidatesFilter_h
#define shapetonPolypCandidatesFilter_h

#include "shapetonColonLandmarks.h"
#include "shapetonColonModel.h"
#include "shapetonMeshAdapter.h"
#include "shapetonPolypSearch.h"
#include "shapetonStageFilter.h"

namespace shapeton
{
/** \class PolypCandidatesFilter
 * \brief Pipeline filter of SearchPolyps(): polyp-like sites of the wall. For research use; a candidate is not a
 * finding.
 *
 * \par Inputs and Outputs
 * Input: the repaired wall, such as output 1 of ColonModelFilter. Input Model: its ColonModel, with lumen, cleansed CT,
 * centerline and catheter. Optional inputs: FlatColon, for positions on the map, and with it Landmarks, for segments.
 * Output: the candidates in order of decreasing score.
 *
 * This filter measures the attenuation of heads on the unrounded CT; the tool ColonPolyps reads a CT in whole HU.
 *
 * \ingroup ShapetonColonFilters */
template <typename TInputMesh = PipelineMesh>
class PolypCandidatesFilter : public StageFilter<itk::ProcessObject>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PolypCandidatesFilter);

  using Self = PolypCandidatesFilter;
  using Superclass = StageFilter<itk::ProcessObject>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = PolypSearchOptions;
  using CandidatesType = std::vector<PolypCandidate>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(PolypCandidatesFilter);

  using Superclass::SetInput;
  void
  SetInput(const TInputMesh * wall)
  {
    this->SetNthInput(0, const_cast<TInputMesh *>(wall));
  }
  itkSetInputMacro(Model, ResultObject<ColonModel>);
  itkGetInputMacro(Model, ResultObject<ColonModel>);
  itkSetInputMacro(FlatColon, ResultObject<FlatColon>);
  itkGetInputMacro(FlatColon, ResultObject<FlatColon>);
  itkSetInputMacro(Landmarks, ResultObject<ColonLandmarks>);
  itkGetInputMacro(Landmarks, ResultObject<ColonLandmarks>);

  /** \name See PolypSearchOptions for ranges and defaults */
  ///@{
  shapetonOptionMacro(Preset, preset);
  shapetonOptionMacro(Sensitivity, sensitivity);
  ///@}

  ResultObject<CandidatesType> *
  GetOutput()
  {
    return static_cast<ResultObject<CandidatesType> *>(this->itk::ProcessObject::GetOutput(0));
  }

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType) override
  {
    return ResultObject<CandidatesType>::New().GetPointer();
  }

protected:
  PolypCandidatesFilter()
  {
    this->SetNumberOfRequiredInputs(1);
    this->AddRequiredInputName("Model");
    this->SetNthOutput(0, this->MakeOutput(0));
  }
  ~PolypCandidatesFilter() override = default;

  void
  VerifyPreconditions() const override
  {
    Superclass::VerifyPreconditions();
    if (this->GetLandmarks() && !this->GetFlatColon())
    {
      itkExceptionMacro("the input Landmarks requires the input FlatColon");
    }
  }

  void
  Compute() override
  {
    PolypSearchOptions options = m_Options;
    options.progress = this->Reporter();
    this->SetResult(0, SearchPolyps(this->Colon(), options));
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Preset: " << NameOf(m_Options.preset) << std::endl;
    os << indent << "Sensitivity: " << m_Options.sensitivity << std::endl;
  }

private:
  PolypColon
  Colon() const
  {
    const ColonModel & model = this->GetModel()->Get();
    PolypColon         colon;
    colon.wall = SurfaceOf(*static_cast<const TInputMesh *>(this->itk::ProcessObject::GetInput(0)));
    colon.centerline = model.centerline.curve;
    if (model.lumen.catheter && model.lumen.catheter->isSure)
    {
      colon.catheter = CurveOfCatheter(*model.lumen.catheter);
    }
    colon.lumen = model.lumen.labels;
    colon.ct = model.cleansed;
    if (this->GetFlatColon())
    {
      colon.flat = this->GetFlatColon()->Share();
    }
    if (this->GetLandmarks())
    {
      colon.segments = SegmentSurface(colon.flat->Surface(), this->GetLandmarks()->Get());
    }
    return colon;
  }

  OptionsType m_Options;
};
} // namespace shapeton

#endif
