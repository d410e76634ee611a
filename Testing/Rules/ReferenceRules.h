#ifndef ReferenceRules_h
#define ReferenceRules_h

#include "Fault.h"

#include <filesystem>

namespace rules
{
/** Each formula of the dissertation is marked at most once in the comments of the modules that Doxygen reads, by
 * `\equation{n.m}` at the code that computes it; (2.4), (3.10), (5.5), (6.7) and (8.5) are marked. */
Faults
CheckEquations(const std::filesystem::path & root);

/** No comment of a public header consists of the name of its class and group alone. */
Faults
CheckComments(const std::filesystem::path & root);

/** The group that a comment names is that of its module, or one that a comment of the module defines: Doxygen passes
 * over others without a warning. */
Faults
CheckGroups(const std::filesystem::path & root);
} // namespace rules

#endif
