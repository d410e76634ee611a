#include "shapetonExceptions.h"

#include <algorithm>
#include <cctype>

namespace shapeton
{
namespace
{
bool
IsOfName(unsigned char character)
{
  return std::isalnum(character) != 0 || character == '_';
}
} // namespace

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
SHAPETON_EXCEPTION(DeviceError)

std::string
SpellParameters(const std::string &                                                         text,
                const std::function<std::string(const std::string & name, bool hasValue)> & spell)
{
  const std::string begin = "the parameter \"";
  const std::string value = " = ";
  std::string       result;
  std::size_t       rest = 0;
  for (std::size_t place = text.find(begin); place != std::string::npos; place = text.find(begin, place + 1))
  {
    const std::size_t name = place + begin.size();
    const std::size_t end = std::find_if_not(text.begin() + name, text.end(), IsOfName) - text.begin();
    if (end > name && end < text.size() && text[end] == '"')
    {
      const bool hasValue = text.compare(end + 1, value.size(), value) == 0;
      result += text.substr(rest, place - rest) + spell(text.substr(name, end - name), hasValue);
      rest = end + 1 + (hasValue ? value.size() : 0);
    }
  }
  return result + text.substr(rest);
}

std::string
WithoutItkPrefix(const std::string & description)
{
  const std::string prefix = "ITK ERROR: ";
  const auto        start = description.rfind(prefix);
  if (start == std::string::npos)
  {
    return description;
  }
  const std::string text = description.substr(start + prefix.size());
  const auto        object = text.find("(0x");
  const auto        end = text.find("): ");
  const bool        hasObject = object != std::string::npos && end != std::string::npos && object < end;
  return hasObject && text.find(' ') > end ? text.substr(end + 3) : text;
}
} // namespace shapeton
