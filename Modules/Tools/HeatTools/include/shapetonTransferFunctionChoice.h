#ifndef shapetonTransferFunctionChoice_h
#define shapetonTransferFunctionChoice_h

#include "ShapetonHeatToolsExport.h"
#include "shapetonObjectColors.h"
#include "shapetonShapeQuantity.h"
#include "shapetonShapeTransferFunction.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** The lines, the time step and the objects chosen by the user: by the parameters `lines` and `timeStep`, or by `from`,
 * a file saved by the heat explorer. \ingroup ShapetonHeatTools */
struct TransferFunctionChoice
{
  std::optional<ShapeTransferFunction> lines;
  std::optional<std::uint64_t>         timeStep;
  /** Quantity of the lines, if stated in the file. */
  std::string quantity;
  /** Colored objects of the file. */
  std::vector<ObjectColor> objects;
};

/** Reads the choice; lines and time step of a file become part of the provenance. Throws ParameterError for lines that
 * cannot be read, for `from` combined with `lines` or `timeStep`, and for colored objects without the parameter
 * `objects` (their labels) or vice versa; InputError for a file not saved by the explorer. \ingroup ShapetonHeatTools
 */
ShapetonHeatTools_EXPORT TransferFunctionChoice
ReadTransferFunctionChoice(CommandLine & commandLine);

/** What the pictures show: the values with their lines, or classes if there are objects, whose labels are then read.
 * Warns that the volume property lacks the objects. Throws InputError if the labels do not fit.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT ColoredClasses
ColorChoice(CommandLine &                  commandLine,
            const TransferFunctionChoice & choice,
            const itk::Image<float, 3> *   values,
            const ShapeTransferFunction &  lines);

/** Throws InputError if the lines were picked for a quantity other than the one stored in `path`.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
RequireQuantity(const TransferFunctionChoice & choice, const ShapeQuantity & found, const std::string & path);
} // namespace shapeton

#endif
