#ifndef shapetonFilterInput_h
#define shapetonFilterInput_h

#include "shapetonExceptions.h"
#include "shapetonITKCompatibility.h"

#include "itkProcessObject.h"

/** Set and Get methods of an optional input. Get throws InputError if SetInput(name, object) set an object of another
 * type. */
#define shapetonInputMacro(name, type)                                                                                 \
  itkSetInputMacro(name, type);                                                                                        \
  const type * Get##name() const                                                                                       \
  {                                                                                                                    \
    return ::shapeton::InputOfType<type>(this->itk::ProcessObject::GetInput(#name), #name);                            \
  }                                                                                                                    \
  ITK_MACROEND_NOOP_STATEMENT

namespace shapeton
{
/** An input of a filter as its type; null if it is not set. Throws InputError if it is of another type.
 * \ingroup ShapetonCommon */
template <typename TData>
const TData *
InputOfType(const itk::DataObject * input, const char * name)
{
  const auto * const typed = dynamic_cast<const TData *>(input);
  if (input && !typed)
  {
    throw InputError("the input \"" + std::string(name) + "\" is of another type than the filter expects; cast it, " +
                     "for instance with itk::CastImageFilter");
  }
  return typed;
}

/** Requests the whole of each input of a filter. \ingroup ShapetonCommon */
inline void
RequestWholeInputs(itk::ProcessObject & filter)
{
  for (const auto & input : filter.GetInputs())
  {
    if (input)
    {
      input->SetRequestedRegionToLargestPossibleRegion();
    }
  }
}
} // namespace shapeton

#endif
