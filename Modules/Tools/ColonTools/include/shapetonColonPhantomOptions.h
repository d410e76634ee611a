#ifndef shapetonColonPhantomOptions_h
#define shapetonColonPhantomOptions_h

#include "ColonToolsExport.h"

namespace shapeton
{
struct ColonPhantomParameters;
class CommandLine;

/** The parameters of ColonPhantom: those of the option `preset`, but for the options that are given. Of the options
 * that `standard` and `hard` do without, only those that are given enter the provenance, so that results of these
 * presets stay as they were. Throws ParameterError. \ingroup ColonTools */
ColonTools_EXPORT ColonPhantomParameters
ReadColonPhantomParameters(CommandLine & commandLine);
} // namespace shapeton

#endif
