#ifndef shapetonColonTruthWriter_h
#define shapetonColonTruthWriter_h

#include "ColonToolsExport.h"

#include "shapetonCurveSet.h"

#include <string>

namespace shapeton
{
class ColonPhantomImageSource;
class CommandLine;

/** Writes the truth of an updated source as outputs of a tool to a folder, which is made where it does not exist:
 * lumen.nrrd (1 gas, 2 fluid) and segments.nrrd (1 to 6) on the grid of the image, wall.vtp, centreline.vtp, folds.vtp,
 * taeniae.vtp, correspondence.vtp and polyps.csv. All in LPS, mm.
 * \param other correspondence.vtp of another position of this patient; then points.csv, too: pairs of points, first
 * that of the other position (TableOfPointPairs()). May be null.
 *
 * Throws OutputError, InputError as TableOfPointPairs() does. \ingroup ColonTools */
ColonTools_EXPORT void
WriteColonTruth(CommandLine &             commandLine,
                ColonPhantomImageSource & source,
                const std::string &       folder,
                const CurveSet *          other = nullptr);
} // namespace shapeton

#endif
