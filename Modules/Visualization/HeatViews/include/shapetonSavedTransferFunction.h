#ifndef shapetonSavedTransferFunction_h
#define shapetonSavedTransferFunction_h

#include "ShapetonHeatViewsExport.h"
#include "shapetonJsonForward.h"
#include "shapetonObjectColors.h"
#include "shapetonShapeTransferFunction.h"

#include <cstdint>
#include <string>

namespace shapeton
{
/** A transfer function saved from the HeatExplorer page. \ingroup ShapetonHeatViews */
struct SavedTransferFunction
{
  /** "heat" or "density". */
  std::string           quantity;
  std::uint64_t         timeStep{ 0 };
  ShapeTransferFunction lines;
  /** Colored objects, at most 200; if there are none, there is at least one line. */
  std::vector<ObjectColor> objects{};
};

/** Reads transfer-function.json. Throws InputError, with the file, the error and a remedy, if the file is missing, not
 * JSON or not in the format that the page saves: a missing, unknown or mistyped key, lines that
 * ShapeTransferFunction rejects, or objects whose labels are wrong. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT SavedTransferFunction
ReadTransferFunction(const std::string & path);

/** The lines of a list in the format of that file. `name` is used in messages. Throws InputError.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT ShapeTransferFunction
TransferFunctionOf(const Json & lines, const std::string & name);

/** Writes a file for ReadTransferFunction(). Throws OutputError. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT void
WriteTransferFunction(const SavedTransferFunction & transferFunction, const std::string & path);
} // namespace shapeton

#endif
