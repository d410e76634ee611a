#ifndef shapetonStageFilter_h
#define shapetonStageFilter_h

#include "shapetonExceptions.h"
#include "shapetonFilterInput.h"
#include "shapetonFilterOptions.h"
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
#include <array>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

/** \name Members of a filter derived from StageFilter
 * For the public part of its class. */
///@{
/** Types, New() and the name of the class. */
#define shapetonStageFilterMacro(name)                                                                                 \
  ITK_DISALLOW_COPY_AND_MOVE(name);                                                                                    \
  using Self = name;                                                                                                   \
  using Superclass = typename name::StageFilter;                                                                       \
  using Pointer = itk::SmartPointer<Self>;                                                                             \
  using ConstPointer = itk::SmartPointer<const Self>;                                                                  \
  using OptionsType = typename Superclass::OptionsType;                                                                \
  shapetonNewMacro(Self);                                                                                              \
  itkOverrideGetNameOfClassMacro(name);                                                                                \
                                                                                                                       \
protected:                                                                                                             \
  name() = default;                                                                                                    \
  ~name() override = default;                                                                                          \
                                                                                                                       \
public:                                                                                                                \
  static_assert(true, "")

/** Set and Get methods of a required input. The first one is the primary input unless the superclass has one. */
#define shapetonRequiredInputMacro(name, type)                                                                         \
  shapetonInputMacro(name, type);                                                                                      \
                                                                                                                       \
protected:                                                                                                             \
  const bool m_Requires##name{ this->RequireInput(#name) };                                                            \
                                                                                                                       \
public:                                                                                                                \
  static_assert(true, "")

/** Get method of an output. */
#define shapetonOutputMacro(name, index)                                                                               \
  auto * Get##name##Output() { return this->template OutputAt<index>(); }                                              \
  ITK_MACROEND_NOOP_STATEMENT
///@}

namespace shapeton
{
/** \name Images for functions that process whole volumes
 * The buffered region of an image, shifted so that its first voxel is at index 0; positions in space and DICOM fields
 * are unchanged. */
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
  view->SetMetaDataDictionary(image->GetMetaDataDictionary());
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
    const auto floats = cast->GetOutput();
    floats->SetMetaDataDictionary(image->GetMetaDataDictionary());
    return floats;
  }
}

/** Copies the voxels of an image that starts at index 0 to the output of a filter whose regions are set. Downstream
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

/** Fills the output object of a filter. \ingroup ShapetonColonFilters */
template <typename TResult, typename TValue>
void
HandOver(TValue && value, ResultObject<TResult> * output)
{
  output->Set(std::forward<TValue>(value));
}

/** Throws InputError if `result.failure` states why a stage has no result. \ingroup ShapetonColonFilters */
template <typename TResult>
void
RequireSuccess(const TResult & result)
{
  if (!result.failure.empty())
  {
    throw InputError(result.failure);
  }
}

/** Placeholder for a stage that has no options. \ingroup ShapetonColonFilters */
struct NoOptions
{
  template <typename TOptions, typename TVisitor>
  static void
  VisitOptions(TOptions &, const TVisitor &)
  {}
};

/** \class StageFilter
 * \brief Base class of the virtual colonoscopy filters: they process whole inputs, report progress, can be aborted, and
 * throw ITK exceptions.
 *
 * A derived class declares its inputs and other outputs with the macros of this header, inherits the methods of its
 * options from the generated mixins, and calls the function of its stage in Compute().
 *
 * \tparam TSuperclass itk::ProcessObject or a class derived from it.
 * \tparam TOptions options of the stage.
 * \tparam TOutputs types of all outputs: images or meshes as in the superclass, ResultObject for other results.
 * \ingroup ShapetonColonFilters */
template <typename TSuperclass, typename TOptions, typename... TOutputs>
class StageFilter : public FilterWithOptions<TOptions, TSuperclass>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(StageFilter);

  using Self = StageFilter;
  using Superclass = FilterWithOptions<TOptions, TSuperclass>;
  template <unsigned int VIndex>
  using OutputType = std::tuple_element_t<VIndex, std::tuple<TOutputs...>>;

  itkOverrideGetNameOfClassMacro(StageFilter);

  using Superclass::GetOutput;
  OutputType<0> *
  GetOutput()
  {
    return this->OutputAt<0>();
  }

  itk::DataObject::Pointer
  MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType index) override
  {
    using Maker = itk::DataObject::Pointer (*)();
    static constexpr std::array<Maker, sizeof...(TOutputs)> makers{ [] {
      return itk::DataObject::Pointer(TOutputs::New());
    }... };
    return makers.at(index)();
  }
  shapetonIndexedOutputsMacro();

  /** Description of the current stage while progress is reported; empty before and after. */
  itkGetConstReferenceMacro(Stage, std::string);

protected:
  StageFilter()
  {
    this->SetNumberOfRequiredOutputs(sizeof...(TOutputs));
    for (unsigned int i = 0; i < sizeof...(TOutputs); ++i)
    {
      this->SetNthOutput(i, this->MakeOutput(i));
    }
  }
  ~StageFilter() override = default;

  template <unsigned int VIndex>
  OutputType<VIndex> *
  OutputAt()
  {
    return static_cast<OutputType<VIndex> *>(this->itk::ProcessObject::GetOutput(VIndex));
  }

  /** Called by the macro; returns true. */
  bool
  RequireInput(const char * name)
  {
    if (this->GetNumberOfRequiredInputs() > 0)
    {
      return this->AddRequiredInputName(name);
    }
    this->SetPrimaryInputName(name);
    this->SetNumberOfRequiredInputs(1);
    return true;
  }

  /** Forwards progress and stage to ITK observers, and aborts on request. */
  shapeton::Progress
  Reporter()
  {
    return shapeton::Progress([this](const std::string & stage, double share) {
      m_Stage = stage;
      ReportProgress(*this, share);
    });
  }

  /** The options with a progress callback, for one call of the stage. */
  TOptions
  ReportingOptions()
  {
    TOptions options = this->m_Options;
    options.progress = this->Reporter();
    return options;
  }

  /** Runs the stage and calls SetOutputs(). */
  virtual void
  Compute() = 0;

  /** Hands over one value for each output, in their order. */
  template <typename... TValues>
  void
  SetOutputs(TValues &&... values)
  {
    unsigned int index = 0;
    (HandOver(std::forward<TValues>(values), static_cast<TOutputs *>(this->ProcessObject::GetOutput(index++))), ...);
  }

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
    RequestWholeInputs(*this);
  }

  void
  EnlargeOutputRequestedRegion(itk::DataObject * output) override
  {
    Superclass::EnlargeOutputRequestedRegion(output);
    output->SetRequestedRegionToLargestPossibleRegion();
  }

  /** Only volumes have information before they are computed. */
  void
  GenerateOutputInformation() override
  {
    if constexpr (std::is_base_of_v<itk::ImageBase<3>, OutputType<0>>)
    {
      Superclass::GenerateOutputInformation();
    }
  }

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Stage: " << m_Stage << std::endl;
  }

private:
  std::string m_Stage;
};
} // namespace shapeton

#endif
