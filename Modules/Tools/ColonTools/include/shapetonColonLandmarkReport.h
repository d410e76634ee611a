#ifndef shapetonColonLandmarkReport_h
#define shapetonColonLandmarkReport_h

#include "ShapetonColonToolsExport.h"
#include "shapetonColonLandmarkPictures.h"
#include "shapetonColonSplitting.h"

namespace shapeton
{
class CommandLine;

/** The report of the tool ColonLandmarks in an existing folder: index.html and its pictures as PNG files; nothing if
 * the name of the folder is empty. `pieces` may be null. Throws OutputError. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WriteColonLandmarkReport(CommandLine &          commandLine,
                         const std::string &    folder,
                         const FlatColon &      flat,
                         const ColonLandmarks & landmarks,
                         const ColonPieces *    pieces);
} // namespace shapeton

#endif
