#ifndef shapetonHeatObjectSelection_h
#define shapetonHeatObjectSelection_h

#include "ShapetonHeatToolsExport.h"

#include "shapetonHeatObjects.h"

#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** The objects that a tool writes. \ingroup ShapetonHeatTools */
struct HeatObjectSelection
{
  std::vector<int> chosen; ///< in the labels
  std::vector<int> listed; ///< in the table: with one point, all objects there, the smallest first
  bool             isOfSome{ false };
  std::string      title;
};

/** Throws ParameterError unless the options select, climb, objects and explorer fit together.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
CheckHeatObjectSelection(const CommandLine & commandLine);

/** Whether points or numbers are given. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT bool
IsSelectionGiven(const CommandLine & commandLine);

/** The objects of the options select, climb and objects, of a list with offers; without them, all. Throws
 * ParameterError, and InputError if no object contains a point. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT HeatObjectSelection
SelectHeatObjects(const CommandLine & commandLine, const HeatObjectList & list);
} // namespace shapeton

#endif
