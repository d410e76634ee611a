#ifndef shapetonSavedTransferFunction_h
#define shapetonSavedTransferFunction_h

#include "HeatExplorerExport.h"
#include "shapetonShapeTransferFunction.h"

#include <cstdint>
#include <string>

namespace shapeton
{
/** A transfer function that the page of HeatExplorer saved. \ingroup HeatExplorer */
struct SavedTransferFunction
{
  /** "heat" or "density". */
  std::string           quantity;
  std::uint64_t         timeStep{ 0 };
  ShapeTransferFunction lines;
};

/** Reads transfer-function.json. Throws InputError, which names the file, what is wrong in it and what to do, for a
 * file that is missing, is no JSON or is not what the page saves: a key that is missing, unknown or of another kind,
 * and lines that ShapeTransferFunction refuses. \ingroup HeatExplorer */
HeatExplorer_EXPORT SavedTransferFunction
ReadTransferFunction(const std::string & path);
} // namespace shapeton

#endif
