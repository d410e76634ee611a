#ifndef shapetonColonoscopyRun_h
#define shapetonColonoscopyRun_h

#include "ShapetonColonToolsExport.h"

#include <string>

namespace shapeton
{
class CommandLine;

/** The tool VirtualColonoscopy. Runs the stages inspection, segmentation, flattening, landmarks, folds and polyps, and
 * the registration if there are two positions, with the tools in `toolFolder`. Results are written to the folder named
 * by the parameter outputFolder; stages with up-to-date results are skipped. Then writes report.html and the files for
 * 3D Slicer. Landmarks precede folds because merged folds are split along the taeniae.
 *
 * If a stage fails, the run ends after reporting the existing results. It throws the exception that corresponds to the
 * exit status of the stage; the message names the stage and the results that were kept. Also throws ParameterError,
 * InputError and OutputError.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
RunColonoscopy(CommandLine & commandLine, const std::string & toolFolder);
} // namespace shapeton

#endif
