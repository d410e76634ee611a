#ifndef shapetonTestErrors_h
#define shapetonTestErrors_h

#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace basetest
{
/** Type and message of the exception thrown by `work`, such as "InputError: message". */
inline std::string
MessageOf(const std::function<void()> & work)
{
  try
  {
    work();
  }
  catch (const shapeton::Exception & error)
  {
    return std::string(error.GetNameOfClass()) + ": " + error.what();
  }
  return "no error";
}

/** Message of the TException thrown by `work`; empty if there is none. */
template <typename TException = shapeton::InputError>
std::string
ErrorOf(const std::function<void()> & work)
{
  try
  {
    work();
  }
  catch (const TException & error)
  {
    return error.what();
  }
  return {};
}

/** Whether `work` throws a TException whose message contains `part`. */
template <typename TException = shapeton::InputError>
testing::AssertionResult
Refuses(const std::function<void()> & work, const std::string & part)
{
  const std::string message = ErrorOf<TException>(work);
  return message.find(part) != std::string::npos && !message.empty()
           ? testing::AssertionSuccess()
           : testing::AssertionFailure() << '"' << message << '"';
}
} // namespace basetest

#endif
