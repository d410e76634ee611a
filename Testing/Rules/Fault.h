#ifndef Fault_h
#define Fault_h

#include <string>
#include <vector>

namespace rules
{
/** Violation of a repository rule. Line 0 means the whole file. */
struct Fault
{
  std::string file;
  int         line{ 0 };
  std::string message;
};

using Faults = std::vector<Fault>;

/** Formats faults as "file:line: message", one per line. */
inline std::string
ToText(const Faults & faults)
{
  std::string text;
  for (const Fault & fault : faults)
  {
    text += fault.file + (fault.line ? ":" + std::to_string(fault.line) : "") + ": " + fault.message + '\n';
  }
  return text;
}
} // namespace rules

#endif
