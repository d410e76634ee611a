#ifndef shapetonTransferFunctionChoice_h
#define shapetonTransferFunctionChoice_h

#include "HeatToolsExport.h"
#include "shapetonShapeQuantity.h"
#include "shapetonShapeTransferFunction.h"

#include <cstdint>
#include <optional>
#include <string>

namespace shapeton
{
class CommandLine;

/** The lines and the time step that a user chose: by the parameters `lines` and `timeStep`, or by `from`, a file that
 * the heat explorer saved. \ingroup HeatTools */
struct TransferFunctionChoice
{
  std::optional<ShapeTransferFunction> lines;
  std::optional<std::uint64_t>         timeStep;
  /** What the lines are of, where the file states it. */
  std::string quantity;
};

/** Of a file, lines and time step become part of the provenance. Throws ParameterError for lines that cannot be read
 * and for `from` beside another parameter, InputError for a file that the explorer did not save. \ingroup HeatTools */
HeatTools_EXPORT TransferFunctionChoice
ReadTransferFunctionChoice(CommandLine & commandLine);

/** Throws InputError where the lines were picked on the other quantity than `path` holds. \ingroup HeatTools */
HeatTools_EXPORT void
RequireQuantity(const TransferFunctionChoice & choice, const ShapeQuantity & found, const std::string & path);
} // namespace shapeton

#endif
