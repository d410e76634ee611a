#ifndef shapetonColonoscopyRun_h
#define shapetonColonoscopyRun_h

#include "ShapetonColonToolsExport.h"

#include <string>

namespace shapeton
{
class CommandLine;

/** The tool VirtualColonoscopy. Runs the stages inspection, segmentation, flattening, landmarks, folds and polyps, and
 * for two positions also the registration, with the tools in `toolFolder`. Results are written to the folder named by
 * the parameter outputFolder; stages with up-to-date results are skipped. Then writes report.html and the files for 3D
 * Slicer. Landmarks precede folds because merged folds are split along the taeniae.
 *
 * A failed stage ends the run after a report on the existing results: the exception for its exit status is thrown,
 * with the stage and the kept results in the message. Also throws ParameterError, InputError and OutputError.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
RunColonoscopy(CommandLine & commandLine, const std::string & toolFolder);
} // namespace shapeton

#endif
