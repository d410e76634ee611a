#ifndef shapetonStageFilter_h
#define shapetonStageFilter_h

#include "shapetonFilterProgress.h"
#include "shapetonIndexedOutputs.h"
#include "shapetonInterruption.h"
#include "shapetonMeshAdapter.h"
#include "shapetonProgress.h"
#include "shapetonResultObject.h"

#include "itkCastImageFilter.h"
#include "itkImage.h"
#include "itkProcessObject.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

/** Set and Get methods of a parameter stored in m_Options of type OptionsType. */
#define shapetonOptionMacro(name, member)                                                                              \
  virtual void Set##name(const decltype(OptionsType::member) & value)                                                  \
  {                                                                                                                    \
    if (m_Options.member != value)                                                                                     \
    {                                                                                                                  \
      m_Options.member = value;                                                                                        \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual const decltype(OptionsType::member) & Get##name() const { return m_Options.member; }                         \
  ITK_MACROEND_NOOP_STATEMENT

namespace shapeton
{
/** \class StageFilter
 * \brief Base class of the virtual colonoscopy filters: they process whole inputs, report progress, can be aborted, and
 * throw ITK exceptions.
 *
 * \tparam TSuperclass itk::ProcessObject or a class derived from it.
 * \ingroup ShapetonColonFilters */
template <typename TSuperclass>
class StageFilter : public TSuperclass
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(StageFilter);

  using Self = StageFilter;
  using Superclass = TSuperclass;

  itkOverrideGetNameOfClassMacro(StageFilter);

  using Superclass::MakeOutput;
  shapetonIndexedOutputsMacro();

  /** Description of the current stage while progress is reported; empty before and after. */
  itkGetConstReferenceMacro(Stage, std::string);

protected:
  StageFilter() = default;
  ~StageFilter() override = default;

  /** Forwards progress and stage to ITK observers, and aborts on request. */
  shapeton::Progress
  Reporter()
  {
    return shapeton::Progress([this](const std::string & stage, double share) {
      m_Stage = stage;
      ReportProgress(*this, share);
    });
  }

  virtual void
  Compute() = 0;

  void
  GenerateData() override
  {
    const Interruption interruption([this] { AbortIfAsked(*this); });
    const struct Clear // also after an abort
    {
      ~Clear() { stage.clear(); }
      std::string & stage;
    } clear{ m_Stage };
    try
    {
      this->Compute();
    }
    catch (const std::logic_error & error) // errors of the calling code
    {
      itkExceptionMacro(<< error.what());
    }
    catch (const std::runtime_error & error) // no solution
    {
      itkExceptionMacro(<< error.what());
    }
  }

  void
  GenerateInputRequestedRegion() override
  {
    Superclass::GenerateInputRequestedRegion();
    for (const auto & name : this->GetInputNames())
    {
      if (auto * const input = this->ProcessObject::GetInput(name))
      {
        input->SetRequestedRegionToLargestPossibleRegion();
      }
    }
  }

  void
  EnlargeOutputRequestedRegion(itk::DataObject * output) override
  {
    Superclass::EnlargeOutputRequestedRegion(output);
    output->SetRequestedRegionToLargestPossibleRegion();
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Stage: " << m_Stage << std::endl;
  }

  template <typename TResult>
  void
  SetResult(unsigned int output, TResult && result)
  {
    using Object = ResultObject<std::decay_t<TResult>>;
    static_cast<Object *>(this->ProcessObject::GetOutput(output))->Set(std::forward<TResult>(result));
  }

private:
  std::string m_Stage;
};

/** \name Images for functions on whole volumes
 * The buffered region of an image with its first voxel at index 0 and the same position. */
///@{
/** Shares the voxels without copying. \ingroup ShapetonColonFilters */
template <typename TImage>
typename TImage::ConstPointer
FromIndexZero(const TImage * image)
{
  auto       view = TImage::New();
  const auto region = image->GetBufferedRegion();
  view->SetRegions(region.GetSize());
  view->SetSpacing(image->GetSpacing());
  view->SetDirection(image->GetDirection());
  view->SetOrigin(image->template TransformIndexToPhysicalPoint<double>(region.GetIndex()));
  view->SetPixelContainer(const_cast<typename TImage::PixelContainer *>(image->GetPixelContainer()));
  return view.GetPointer();
}

/** Converts voxels to float if necessary. \ingroup ShapetonColonFilters */
template <typename TImage>
itk::Image<float, 3>::ConstPointer
FloatsFromIndexZero(const TImage * image)
{
  const auto view = FromIndexZero(image);
  if constexpr (std::is_same_v<TImage, itk::Image<float, 3>>)
  {
    return view;
  }
  else
  {
    const auto cast = itk::CastImageFilter<TImage, itk::Image<float, 3>>::New();
    cast->SetInput(view);
    cast->Update();
    return cast->GetOutput();
  }
}

/** Copies the voxels of an image that starts at index 0 to the output of a filter with its regions set. Downstream
 * filters may then modify the output in place without changing other results.
 * \pre Both have the same size. \ingroup ShapetonColonFilters */
template <typename TImage>
void
HandOver(const TImage * voxels, TImage * output)
{
  output->SetBufferedRegion(output->GetLargestPossibleRegion());
  output->Allocate();
  std::copy_n(voxels->GetBufferPointer(), voxels->GetBufferedRegion().GetNumberOfPixels(), output->GetBufferPointer());
}
///@}

/** Fills the output mesh of a filter. \ingroup ShapetonColonFilters */
template <typename TMesh, typename = typename TMesh::MeshTraits>
void
HandOver(const SurfaceMesh & surface, TMesh * output)
{
  output->Initialize(); // the pipeline does this only if data may be released
  FillMesh(surface, *output);
  output->SetBufferedRegion(output->GetRequestedRegion()); // else the pipeline considers it incomplete
}
} // namespace shapeton

#endif
