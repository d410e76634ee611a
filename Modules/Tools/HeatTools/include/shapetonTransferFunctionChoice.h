#ifndef shapetonTransferFunctionChoice_h
#define shapetonTransferFunctionChoice_h

#include "ShapetonHeatToolsExport.h"
#include "shapetonShapeQuantity.h"
#include "shapetonShapeTransferFunction.h"

#include <cstdint>
#include <optional>
#include <string>

namespace shapeton
{
class CommandLine;

/** The lines and the time step chosen by the user: by the parameters `lines` and `timeStep`, or by `from`, a file
 * saved by the heat explorer. \ingroup ShapetonHeatTools */
struct TransferFunctionChoice
{
  std::optional<ShapeTransferFunction> lines;
  std::optional<std::uint64_t>         timeStep;
  /** Quantity of the lines, if stated in the file. */
  std::string quantity;
};

/** Reads the choice; lines and time step of a file become part of the provenance. Throws ParameterError for lines that
 * cannot be read and for `from` with another parameter, InputError for a file not saved by the explorer.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT TransferFunctionChoice
ReadTransferFunctionChoice(CommandLine & commandLine);

/** Throws InputError if the lines were picked for a quantity other than the one stored in `path`.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
RequireQuantity(const TransferFunctionChoice & choice, const ShapeQuantity & found, const std::string & path);
} // namespace shapeton

#endif
