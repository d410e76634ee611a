#ifndef ModuleLayers_h
#define ModuleLayers_h

#include "Fault.h"

#include <filesystem>
#include <string>

namespace rules
{
/** Checks that the modules below `root` form the layers that CMake/Modules.cmake lists:
 *  - the list matches the folders with an itk-module.cmake, and a module has the name of its folder;
 *  - the groups (folders of modules) are in the order Core, Mesh, IO, Filtering, Phantom, Graph, Colon, Bridge,
 *    Visualization, Tools, so that modules below Tools do not include the command line;
 *  - a module depends only on earlier modules of the list and on ITK modules;
 *  - a file includes only headers of its own module and of the declared dependencies: public headers use DEPENDS and
 *    COMPILE_DEPENDS, sources also PRIVATE_DEPENDS, tests also TEST_DEPENDS;
 *  - each dependency is used: a file of that part of the module includes one of its headers;
 *  - include paths stay in their folder, and header names are unique, because headers are installed into one folder.
 */
Faults
CheckModuleLayers(const std::filesystem::path & root);

/** Checks the C++ files of the modules below `root`:
 *  - they do not open the namespace itk;
 *  - strings below the group Tools do not name options (`--flag`): libraries name parameters, tools name options. */
Faults
CheckLibraryTexts(const std::filesystem::path & root);

/** Describes the module graph below `root`: one line per module with its dependencies, and the numbers of modules,
 * dependencies, public headers, and headers used outside of their module. */
std::string
DescribeModuleGraph(const std::filesystem::path & root);
} // namespace rules

#endif
