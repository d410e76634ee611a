#ifndef ModuleLayers_h
#define ModuleLayers_h

#include "Fault.h"

#include <filesystem>

namespace house
{
/** Checks that the modules below `root` form the layers that CMake/Modules.cmake lists:
 *  - the list and the folders with an itk-module.cmake are the same, and a module bears the name of its folder;
 *  - a module depends on earlier modules of the list and on ITK's alone;
 *  - a file includes headers of its own module and of modules that its itk-module.cmake lets it reach: public headers
 *    through DEPENDS and COMPILE_DEPENDS, sources also through PRIVATE_DEPENDS, tests also through TEST_DEPENDS;
 *  - no include path leaves its folder, and no header name occurs twice, because headers are installed into one folder.
 */
Faults
CheckModuleLayers(const std::filesystem::path & root);
} // namespace house

#endif
