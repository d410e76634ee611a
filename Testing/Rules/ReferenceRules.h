#ifndef ReferenceRules_h
#define ReferenceRules_h

#include "Fault.h"

#include <filesystem>

namespace rules
{
/** Checks that each formula of the dissertation is marked at most once in Doxygen comments of the modules, by
 * `\equation{n.m}` at the code that computes it, and that (2.4), (3.10), (5.5), (6.7) and (8.5) are marked. */
Faults
CheckEquations(const std::filesystem::path & root);

/** Checks that comments of public headers do not consist of the class name and group only. */
Faults
CheckComments(const std::filesystem::path & root);

/** Checks that the group of a comment is that of its module, or one that a comment of the module defines. Doxygen
 * ignores unknown groups without a warning. */
Faults
CheckGroups(const std::filesystem::path & root);
} // namespace rules

#endif
