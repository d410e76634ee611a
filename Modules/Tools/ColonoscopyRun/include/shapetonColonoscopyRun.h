#ifndef shapetonColonoscopyRun_h
#define shapetonColonoscopyRun_h

#include "ColonoscopyRunExport.h"

#include <string>

namespace shapeton
{
class CommandLine;

/** The tool VirtualColonoscopy: runs the stages inspection, segmentation, flattening, landmarks, folds and polyps, of
 * two positions also the registration, in the folder that the parameter outputFolder names, by the tools in
 * `toolFolder`, as far as their results are not there yet; then writes report.html and the files for 3D Slicer.
 * Landmarks come before folds, because folds that have grown together are split along the taeniae.
 *
 * A stage that fails ends the run after the report on what there is: throws the exception of its exit status, which
 * names the stage and what was kept. Throws ParameterError, InputError and OutputError of its own, too.
 * \ingroup ColonoscopyRun */
ColonoscopyRun_EXPORT void
RunColonoscopy(CommandLine & commandLine, const std::string & toolFolder);
} // namespace shapeton

#endif
