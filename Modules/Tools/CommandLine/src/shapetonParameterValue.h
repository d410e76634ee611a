#ifndef shapetonParameterValue_h
#define shapetonParameterValue_h

#include "shapetonModuleDescription.h"

#include <string>
#include <vector>

namespace shapeton
{
/** The parts of a comma-separated list; none for the empty text. */
std::vector<std::string>
SplitAtCommas(const std::string & text);

/** The finite number that the whole of `text` denotes, independent of the locale. Throws ParameterError. */
double
ParseNumber(const ModuleDescription::Parameter & parameter, const std::string & text);

/** Throws ParameterError unless `value` has the type of the parameter and keeps its enumeration and constraints. */
void
CheckValue(const ModuleDescription::Parameter & parameter, const std::string & value);

/** The value in the one spelling that all equal values share: "+7.0" and "7" are "7". */
std::string
CanonicalValue(const ModuleDescription::Parameter & parameter, const std::string & value);
} // namespace shapeton

#endif
