#ifndef MessageRules_h
#define MessageRules_h

#include "Fault.h"

#include <filesystem>

namespace rules
{
/** Checks that messages do not give advice that the tool rejects. In strings of C++ sources below `root`, except tests:
 *  - an option named by a tool (`--p`, or `the parameter "p"`) is declared by its XML, or built in;
 *  - a parameter named by a module is declared by a tool that links the module;
 *  - a value after an option or parameter is valid in every tool that may print it and declares the option: an element
 *    of its enumeration, or a number in its range.
 * An option after the name of another tool and an opening parenthesis is an option of that tool. */
Faults
CheckMessages(const std::filesystem::path & root);

/** Comments, messages and pages are plain English: no comment of a source begins with a bare genitive ("Of the ..."),
 * no message says that something "is no" or "is none", nothing is told, wanders, hangs on or belongs beside, and
 * spelling is American, in identifiers, too. */
Faults
CheckWording(const std::filesystem::path & root);
} // namespace rules

#endif
