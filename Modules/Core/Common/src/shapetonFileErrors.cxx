#include "shapetonFileErrors.h"
#include "shapetonExceptions.h"

#include <cerrno>
#include <system_error>

namespace shapeton
{
namespace
{
std::string
ReasonOf(int error)
{
  return std::generic_category().message(error);
}

std::string
AdviceForReading(int error)
{
  switch (error)
  {
    case EISDIR:
      return "specify a file";
    case EIO:
      return "check the disk";
    default:
      return "check the name and its permissions";
  }
}

std::string
AdviceForWriting(int error)
{
  switch (error)
  {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space or choose another folder";
    case ENAMETOOLONG:
      return "choose a shorter name";
    case EISDIR:
      return "specify a file name";
    default:
      return "use an existing, writable folder";
  }
}
} // namespace

void
ThrowCannotRead(const std::string & path, int error)
{
  throw InputError("cannot read \"" + path + "\": " + ReasonOf(error) + "; " + AdviceForReading(error));
}

void
ThrowUnsuitable(const std::string & path, const std::string & reason)
{
  throw InputError(path + ": " + reason);
}

void
ThrowCannotWrite(const std::string & path, int error)
{
  ThrowCannotWrite(path, ReasonOf(error), AdviceForWriting(error));
}

void
ThrowCannotWrite(const std::string & path, int error, const std::string & otherwise)
{
  ThrowCannotWrite(path, error != 0 ? ReasonOf(error) : otherwise, AdviceForWriting(error));
}

void
ThrowCannotWrite(const std::string & path, const std::string & reason, const std::string & advice)
{
  throw OutputError("cannot write \"" + path + "\": " + reason + "; " + advice);
}
} // namespace shapeton
