#ifndef ToolXMLRules_h
#define ToolXMLRules_h

#include "Fault.h"

#include <string>

namespace rules
{
/** Checks the module description of a tool: 3D Slicer's ModuleDescriptionParser must accept it, Slicer's command-line
 * logic must pass arguments that the tool accepts, and it must follow the tool contract.
 *
 * \param xml the description
 * \param file its name in the faults
 * \param version the required content of `<version>`
 */
Faults
CheckToolXML(const std::string & xml, const std::string & file, const std::string & version);
} // namespace rules

#endif
