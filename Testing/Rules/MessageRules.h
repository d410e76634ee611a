#ifndef MessageRules_h
#define MessageRules_h

#include "Fault.h"

#include <filesystem>

namespace rules
{
/** Messages give no advice that the tool refuses. In the texts of C++ sources below `root`, outside of tests:
 *  - an option that a tool names (`--p`, or `the parameter "p"`) is declared by its XML, or built in;
 *  - a parameter that a module names is declared by a tool that is linked with the module;
 *  - a value that follows an option or parameter is accepted wherever a tool that may say so declares it: an element of
 *    its enumeration, a number in its range.
 * An option after the name of another tool and an opening parenthesis is that of the other tool. */
Faults
CheckMessages(const std::filesystem::path & root);

/** Comments, messages and pages are plain English: no comment of a source begins with a bare genitive ("Of the ..."), no
 * message says that something "is no" or "is none", and nothing is told, wanders, hangs on or belongs beside. */
Faults
CheckWording(const std::filesystem::path & root);
} // namespace rules

#endif
