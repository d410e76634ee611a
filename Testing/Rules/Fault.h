#ifndef Fault_h
#define Fault_h

#include <string>
#include <vector>

namespace rules
{
/** One violation of a rule of the repository: where, and what is wrong. Line 0 means the whole file. */
struct Fault
{
  std::string file;
  int         line{ 0 };
  std::string message;
};

using Faults = std::vector<Fault>;

/** file:line: message, one fault in each line. */
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
