#ifndef ParameterRules_h
#define ParameterRules_h

#include "XMLFaults.h"

namespace rules
{
/** What one parameter of a tool must be by itself. */
void
CheckParameter(const XMLElement & parameter, XMLFaults & faults);

/** Of the constraints of a parameter: "minimum", "maximum" or "step". */
std::optional<double>
LimitOf(const XMLElement & parameter, const std::string & limit);
} // namespace rules

#endif
