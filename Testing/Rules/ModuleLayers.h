#ifndef ModuleLayers_h
#define ModuleLayers_h

#include "Fault.h"

#include <filesystem>
#include <string>

namespace rules
{
/** Checks that the modules below `root` form the layers that CMake/Modules.cmake lists:
 *  - the list and the folders with an itk-module.cmake are the same, and a module bears the name of its folder;
 *  - the groups (folders of modules) of the list stand in the order Core, Mesh, IO, Filtering, Phantom, Graph, Colon,
 *    Bridge, Visualization, Tools; so nothing below the tools includes the command line;
 *  - a module depends on earlier modules of the list and on ITK's alone;
 *  - a file includes headers of its own module and of modules that its itk-module.cmake lets it reach: public headers
 *    through DEPENDS and COMPILE_DEPENDS, sources also through PRIVATE_DEPENDS, tests also through TEST_DEPENDS;
 *  - each dependency is used: a file of that part of the module includes one of its headers;
 *  - no include path leaves its folder, and no header name occurs twice, because headers are installed into one folder.
 */
Faults
CheckModuleLayers(const std::filesystem::path & root);

/** Checks the C++ files of the modules below `root`:
 *  - no declaration enters the namespace itk;
 *  - no text below the group Tools names an option (`--flag`): libraries name parameters, tools their options. */
Faults
CheckLibraryTexts(const std::filesystem::path & root);

/** The graph of the modules below `root` in words: a line for each module with what it depends on, and the numbers of
 * modules, arrows, public headers and those that a file outside their module includes. */
std::string
DescribeModuleGraph(const std::filesystem::path & root);
} // namespace rules

#endif
