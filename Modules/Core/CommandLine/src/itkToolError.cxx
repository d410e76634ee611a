#include "itkToolError.h"

namespace itk
{
ToolError::ToolError(int exitStatus, const std::string & message)
  : std::runtime_error(message), m_ExitStatus(exitStatus)
{}
ToolError::~ToolError() = default;

UsageError::UsageError(const std::string & message) : ToolError(2, message) {}
UsageError::~UsageError() = default;

InputError::InputError(const std::string & message) : ToolError(3, message) {}
InputError::~InputError() = default;

OutputError::OutputError(const std::string & message) : ToolError(1, message) {}
OutputError::~OutputError() = default;

void
RequireUsage(bool condition, const std::string & message)
{
  if (!condition)
  {
    throw UsageError(message);
  }
}
} // namespace itk
