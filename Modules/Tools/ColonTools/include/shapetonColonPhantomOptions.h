#ifndef shapetonColonPhantomOptions_h
#define shapetonColonPhantomOptions_h

#include "ShapetonColonToolsExport.h"

#include "itkPoint.h"

namespace shapeton
{
struct ColonPhantomParameters;
class CommandLine;

/** Parameters of ColonPhantom: the values of the option `preset`, overridden by the given options. Options that
 * `standard` and `hard` do not use are added to the provenance only if given, so results of these presets remain
 * byte-identical. Throws ParameterError. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT ColonPhantomParameters
ReadColonPhantomParameters(CommandLine & commandLine);

/** The option `center` of ColonPhantom: the center of the volume in the patient (LPS, mm). It is added to the
 * provenance only if given. Throws ParameterError unless it has three numbers within 1000 mm.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT itk::Point<double, 3>
                          ReadPhantomCenter(CommandLine & commandLine);
} // namespace shapeton

#endif
