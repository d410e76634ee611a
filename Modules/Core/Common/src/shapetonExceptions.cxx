#include "shapetonExceptions.h"

namespace shapeton
{
Exception::Exception(const std::string & description, const char * file, unsigned int line, const char * function)
  : itk::ExceptionObject(file, line, description, function)
{}
Exception::~Exception() = default;

const char *
Exception::what() const noexcept
{
  return this->GetDescription();
}

const char *
Exception::GetNameOfClass() const
{
  return "Exception";
}

#define SHAPETON_EXCEPTION(name)                                                                                       \
  name::name(const std::string & description, const char * file, unsigned int line, const char * function)             \
    : Exception(description, file, line, function)                                                                     \
  {}                                                                                                                   \
  name::~name() = default;                                                                                             \
  const char * name::GetNameOfClass() const { return #name; }

SHAPETON_EXCEPTION(ParameterError)
SHAPETON_EXCEPTION(InputError)
SHAPETON_EXCEPTION(OutputError)
} // namespace shapeton
