#ifndef shapetonResultObject_h
#define shapetonResultObject_h

#include "shapetonITKCompatibility.h"

#include "itkDataObject.h"
#include "itkObjectFactory.h"

#include <memory>

namespace shapeton
{
/** \class ResultObject
 * \brief A pipeline data object for results that are neither images nor meshes, such as a centerline.
 *
 * Like itk::SimpleDataObjectDecorator, but for types that cannot be compared or copied. The value is shared and stays
 * alive independently of the pipeline.
 *
 * \ingroup ShapetonColonFilters */
template <typename TResult>
class ResultObject : public itk::DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ResultObject);

  using Self = ResultObject;
  using Superclass = itk::DataObject;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using ResultType = TResult;
  using ResultPointer = std::shared_ptr<const TResult>;

  shapetonNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ResultObject);

  void
  Set(ResultPointer result)
  {
    m_Result = std::move(result);
    this->Modified();
  }
  void
  Set(TResult result)
  {
    this->Set(std::make_shared<const TResult>(std::move(result)));
  }

  bool
  HasResult() const
  {
    return m_Result != nullptr;
  }
  /** \exception itk::ExceptionObject if the source filter has not been updated. */
  const TResult &
  Get() const
  {
    return *this->Share();
  }
  ResultPointer
  Share() const
  {
    if (!m_Result)
    {
      itkExceptionMacro("the result is not available; call Update() of its filter first");
    }
    return m_Result;
  }

  void
  Initialize() override
  {
    Superclass::Initialize();
    m_Result.reset();
  }
  void
  Graft(const itk::DataObject * data) override
  {
    const auto * const other = dynamic_cast<const Self *>(data);
    if (data && !other)
    {
      itkExceptionMacro("cannot graft a " << data->GetNameOfClass() << " of another type");
    }
    m_Result = other ? other->m_Result : m_Result;
  }

protected:
  ResultObject() = default;
  ~ResultObject() override = default;

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "HasResult: " << this->HasResult() << std::endl;
  }

private:
  ResultPointer m_Result;
};
} // namespace shapeton

#endif
