#ifndef itkModuleHelp_h
#define itkModuleHelp_h

#include "itkModuleDescription.h"

#include <string>

namespace itk
{
/** The text of --help. */
std::string
HelpText(const ModuleDescription & module, const std::string & program);
} // namespace itk

#endif
