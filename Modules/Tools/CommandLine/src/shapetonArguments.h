#ifndef shapetonArguments_h
#define shapetonArguments_h

#include "shapetonModuleDescription.h"

#include <map>
#include <string>
#include <vector>

namespace shapeton
{
/** What the user has said on the command line. */
struct Arguments
{
  std::map<std::string, std::vector<std::string>> given; ///< checked values by the name of the parameter
  std::string                                     returnFile;
  bool                                            quiet{ false };
};

/** The first of --help, -h, --version and --xml before a "--"; empty when there is none. */
std::string
FindQuestion(const std::vector<std::string> & arguments);

/** Throws ParameterError for what the module description does not allow. */
Arguments
ParseArguments(const ModuleDescription & module, const std::vector<std::string> & arguments);
} // namespace shapeton

#endif
