#ifndef shapetonToolGraphs_h
#define shapetonToolGraphs_h

#include "ShapetonGraphToolsExport.h"
#include "shapetonGraphReader.h"
#include "shapetonRotationFile.h"

namespace shapeton
{
class CommandLine;

/** ReadGraph() for the input parameter of a tool; records its identity and reports the notes as warnings.
 * \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT Graph
ReadGraph(CommandLine & commandLine, const std::string & parameter);

/** ReadRotation() for the input parameter of a tool; records its identity. \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT CombinatorialMap
ReadRotation(CommandLine & commandLine, const std::string & parameter, const Graph & graph);
} // namespace shapeton

#endif
