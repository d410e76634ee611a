#ifndef ParameterSetRules_h
#define ParameterSetRules_h

#include "XMLFaults.h"

namespace rules
{
using Parameters = std::vector<const XMLElement *>;

/** What the parameters of a tool must be together: names, positions, references, and options that tools of a kind have
 * in common. */
void
CheckParameterSet(const XMLElement & root, const Parameters & parameters, XMLFaults & faults);
} // namespace rules

#endif
