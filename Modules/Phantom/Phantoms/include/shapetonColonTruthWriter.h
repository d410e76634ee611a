#ifndef shapetonColonTruthWriter_h
#define shapetonColonTruthWriter_h

#include "ShapetonPhantomsExport.h"

#include "shapetonCurveSet.h"
#include "shapetonOutputPath.h"
#include "shapetonProvenance.h"

#include <string>

namespace shapeton
{
class ColonPhantomImageSource;

/** Writes the ground truth of an updated source to an existing folder. On the grid of the image: lumen.nrrd (1 gas, 2
 * fluid), segments.nrrd (1 to 6) and structures.nrrd (ColonStructure). Also wall.vtp, centerline.vtp, folds.vtp,
 * taeniae.vtp, correspondence.vtp and polyps.csv; structures.json and structures.vtp with the valve, the cecal pole and
 * the terminal ileum. All in LPS, mm.
 * \param outputPath maps final names in the folder to the names to write to.
 * \param other correspondence.vtp of another position of this patient; if not null, points.csv is also written: pairs
 * of points, each with the point of the other position first (TableOfPointPairs()).
 *
 * Throws OutputError and the exceptions of TableOfPointPairs(). \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT void
WriteColonTruth(ColonPhantomImageSource & source,
                const Provenance &        provenance,
                const std::string &       folder,
                const OutputPath &        outputPath,
                const CurveSet *          other = nullptr);
} // namespace shapeton

#endif
