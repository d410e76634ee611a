#ifndef shapetonParameterValue_h
#define shapetonParameterValue_h

#include "shapetonModuleDescription.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Parts of a comma-separated list; empty for empty text. */
std::vector<std::string>
SplitAtCommas(const std::string & text);

/** Parses all of `text` as a finite number, independent of the locale. Throws ParameterError. */
double
ParseNumber(const ModuleDescription::Parameter & parameter, const std::string & text);

/** Throws ParameterError unless `value` matches the type, enumeration and constraints of the parameter. */
void
CheckValue(const ModuleDescription::Parameter & parameter, const std::string & value);

/** Canonical spelling of a value: "7" for "+7.0" and "7". */
std::string
CanonicalValue(const ModuleDescription::Parameter & parameter, const std::string & value);
} // namespace shapeton

#endif
