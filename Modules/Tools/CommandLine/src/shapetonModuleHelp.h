#ifndef shapetonModuleHelp_h
#define shapetonModuleHelp_h

#include "shapetonModuleDescription.h"

#include <string>

namespace shapeton
{
/** The text of --help. */
std::string
HelpText(const ModuleDescription & module, const std::string & program);
} // namespace shapeton

#endif
