#ifndef shapetonColonPhantomOptions_h
#define shapetonColonPhantomOptions_h

#include "ColonToolsExport.h"

#include "itkPoint.h"

namespace shapeton
{
struct ColonPhantomParameters;
class CommandLine;

/** The parameters of ColonPhantom: those of the option `preset`, but for the options that are given. Of the options
 * that `standard` and `hard` do without, only those that are given enter the provenance, so that results of these
 * presets stay as they were. Throws ParameterError. \ingroup ColonTools */
ColonTools_EXPORT ColonPhantomParameters
ReadColonPhantomParameters(CommandLine & commandLine);

/** The option `center` of ColonPhantom: where the center of the volume lies in the patient (LPS, mm). It enters the
 * provenance only when it is given. Throws ParameterError unless it has three numbers within 1000 mm.
 * \ingroup ColonTools */
ColonTools_EXPORT itk::Point<double, 3>
                  ReadPhantomCenter(CommandLine & commandLine);
} // namespace shapeton

#endif
