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
} // namespace rules

#endif
