#ifndef ParameterRules_h
#define ParameterRules_h

#include "XMLFaults.h"

namespace rules
{
/** Checks a single parameter of a tool. */
void
CheckParameter(const XMLElement & parameter, XMLFaults & faults);

/** Value of the constraint "minimum", "maximum" or "step" of a parameter. */
std::optional<double>
LimitOf(const XMLElement & parameter, const std::string & limit);
} // namespace rules

#endif
