#ifndef shapetonArguments_h
#define shapetonArguments_h

#include "shapetonModuleDescription.h"

#include <map>
#include <string>
#include <vector>

namespace shapeton
{
/** The parsed command line. */
struct Arguments
{
  std::map<std::string, std::vector<std::string>> given; ///< validated values by parameter name
  std::string                                     returnFile;
  bool                                            quiet{ false };
  bool                                            echo{ false };
};

/** The first of --help, -h, --version and --xml before a "--"; empty if there is none. */
std::string
FindQuestion(const std::vector<std::string> & arguments);

/** Throws ParameterError for arguments that the module description does not allow. */
Arguments
ParseArguments(const ModuleDescription & module, const std::vector<std::string> & arguments);
} // namespace shapeton

#endif
