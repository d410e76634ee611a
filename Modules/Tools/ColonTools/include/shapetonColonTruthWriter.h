#ifndef shapetonColonTruthWriter_h
#define shapetonColonTruthWriter_h

#include "ShapetonColonToolsExport.h"

#include "shapetonCurveSet.h"

#include <string>

namespace shapeton
{
class ColonPhantomImageSource;
class CommandLine;

/** Writes the ground truth of an updated source to a folder, which is created if needed, as outputs of a tool:
 * lumen.nrrd (1 gas, 2 fluid), segments.nrrd (1 to 6) and structures.nrrd (ColonStructure) on the grid of the image,
 * wall.vtp, centerline.vtp, folds.vtp, taeniae.vtp, correspondence.vtp, polyps.csv, and structures.json and
 * structures.vtp: valve, cecal pole, terminal ileum. All in LPS, mm.
 * \param other correspondence.vtp of another position of this patient; if not null, points.csv is also written: pairs
 * of points, each with the point of the other position first (TableOfPointPairs()).
 *
 * Throws OutputError and the exceptions of TableOfPointPairs(). \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WriteColonTruth(CommandLine &             commandLine,
                ColonPhantomImageSource & source,
                const std::string &       folder,
                const CurveSet *          other = nullptr);
} // namespace shapeton

#endif
