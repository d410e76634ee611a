#ifndef shapetonToolSurfaces_h
#define shapetonToolSurfaces_h

#include "ShapetonCommandLineExport.h"
#include "shapetonSlicerMarkups.h"
#include "shapetonSurfaceReader.h"

namespace shapeton
{
class CommandLine;

/** ReadSurface() for a tool that requires one component: `parameter` names the input in the tool's XML, which also
 * declares the options part, component and unit ("file" keeps the unit of the format). Adds the identity to the
 * provenance and notes to the warnings. \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT Surface
ReadSurface(CommandLine & commandLine, const std::string & parameter);

/** ReadSurface() for any number of components and without warnings: for a tool that prints its result as text.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT Surface
ReadSurfaceToInspect(CommandLine & commandLine, const std::string & parameter);

/** Calls ReadRepairedSurface() for a tool, warns of each kind of change, and records the warnings as `repairs` in the
 * provenance. The options of the tool override part, component and unit of `options`.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT Surface
ReadRepairedSurface(CommandLine & commandLine, const std::string & parameter, const SurfaceReadOptions & options = {});

/** ReadCurves() for the parameter of a tool; adds the identity of the file to the provenance.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT CurveSet
ReadCurves(CommandLine & commandLine, const std::string & parameter);

/** ReadMarkups() for the parameter of a tool; adds the identity of the file to the provenance.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT std::vector<Markup>
                           ReadMarkups(CommandLine & commandLine, const std::string & parameter);
} // namespace shapeton

#endif
