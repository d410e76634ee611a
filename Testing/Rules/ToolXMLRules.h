#ifndef ToolXMLRules_h
#define ToolXMLRules_h

#include "Fault.h"

#include <string>

namespace rules
{
/** Checks the module description of a tool: whether 3D Slicer's ModuleDescriptionParser takes it and its command-line
 * logic passes arguments that the tool accepts, and the rules of the tool contract.
 *
 * \param xml the description
 * \param file its name in the faults
 * \param version what `<version>` has to say
 */
Faults
CheckToolXML(const std::string & xml, const std::string & file, const std::string & version);
} // namespace rules

#endif
