#ifndef itkToolError_h
#define itkToolError_h

#include "CommandLineExport.h"

#include <stdexcept>
#include <string>

namespace itk
{
/** \class ToolError
 * \brief A failure that a tool reports in one line on stderr and by its exit status.
 *
 * The message says what is wrong, with which file or option, and what to do. It is one line.
 * Modules throw one of the three derived classes; any other exception ends a tool with exit status 1.
 *
 * \ingroup CommandLine
 */
class CommandLine_EXPORT ToolError : public std::runtime_error
{
public:
  ToolError(int exitStatus, const std::string & message);
  ~ToolError() override;

  int
  GetExitStatus() const
  {
    return m_ExitStatus;
  }

private:
  int m_ExitStatus;
};

/** \class UsageError
 * \brief An option is missing, unknown, out of range or contradicts another one. Exit status 2.
 * \ingroup CommandLine */
class CommandLine_EXPORT UsageError : public ToolError
{
public:
  explicit UsageError(const std::string & message);
  ~UsageError() override;
};

/** Throws UsageError with the message unless the condition holds.
 * \ingroup CommandLine */
CommandLine_EXPORT void
RequireUsage(bool condition, const std::string & message);

/** \class InputError
 * \brief The input is missing, unreadable, malformed or unsuitable. Exit status 3.
 * \ingroup CommandLine */
class CommandLine_EXPORT InputError : public ToolError
{
public:
  explicit InputError(const std::string & message);
  ~InputError() override;
};

/** \class OutputError
 * \brief A result cannot be written. Exit status 1.
 * \ingroup CommandLine */
class CommandLine_EXPORT OutputError : public ToolError
{
public:
  explicit OutputError(const std::string & message);
  ~OutputError() override;
};
} // namespace itk

#endif
