#ifndef shapetonToolSurfaces_h
#define shapetonToolSurfaces_h

#include "ToolInputExport.h"
#include "shapetonSlicerMarkups.h"
#include "shapetonSurfaceReader.h"

namespace shapeton
{
class CommandLine;

/** ReadSurface() for a tool: `parameter` names the input in the tool's XML, which also declares the options part,
 * component and unit ("file" keeps that of the format). Adds the identity to the provenance and, unless `warns` is
 * false (a tool whose result is text prints nothing else), notes to the warnings. \ingroup ToolInput */
ToolInput_EXPORT Surface
ReadSurface(CommandLine & commandLine, const std::string & parameter, bool warns = true);

/** ReadRepairedSurface() for a tool: as ReadSurface() for a tool, with a warning for each kind of change and these
 * words in the provenance as `repairs`. With `isAnyExtentPlausible` another extent is a warning. \ingroup ToolInput */
ToolInput_EXPORT Surface
ReadRepairedSurface(CommandLine & commandLine, const std::string & parameter, bool isAnyExtentPlausible = false);

/** ReadCurves() for a tool, of the parameter with this name; adds the identity of the file to the provenance.
 * \ingroup ToolInput */
ToolInput_EXPORT CurveSet
ReadCurves(CommandLine & commandLine, const std::string & parameter);

/** ReadMarkups() for a tool, of the parameter with this name; adds the identity of the file to the provenance.
 * \ingroup ToolInput */
ToolInput_EXPORT std::vector<Markup>
                 ReadMarkups(CommandLine & commandLine, const std::string & parameter);
} // namespace shapeton

#endif
