#ifndef ParameterSetRules_h
#define ParameterSetRules_h

#include "XMLFaults.h"

namespace rules
{
using Parameters = std::vector<const XMLElement *>;

/** Checks the parameters of a tool together: names, positions, references, and options that tools of a kind share. */
void
CheckParameterSet(const XMLElement & root, const Parameters & parameters, XMLFaults & faults);
} // namespace rules

#endif
