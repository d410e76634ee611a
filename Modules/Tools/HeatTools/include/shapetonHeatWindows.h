#ifndef shapetonHeatWindows_h
#define shapetonHeatWindows_h

#include "ShapetonHeatToolsExport.h"

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatResultFiles.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Sets the parameters of the filter that are not given, unless the preset is the published one; returns the choices,
 * the first of which the filter uses. It reports the progress of the run from 0 to `end`. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT std::vector<HeatParameterChoice>
                         ChooseWindows(CommandLine &                                              commandLine,
                                       const std::string &                                        modality,
                                       double                                                     end,
                                       CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** Makes --windowFolder if it is given. Throws ParameterError unless the preset is objects, or with --snapshotSteps.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
MakeWindowFolder(CommandLine & commandLine);

/** Writes the heat of each window into --windowFolder, if it is given. The filter contains the heat of the first
 * window, and diffuses it in the others; all windows take the shares from `start` to `end` of the run. Throws as the
 * filter, and OutputError. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
WriteHeatWindows(CommandLine &                                              commandLine,
                 const HeatResultFiles &                                    files,
                 const std::vector<HeatParameterChoice> &                   windows,
                 double                                                     start,
                 double                                                     end,
                 CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>> * filter);
} // namespace shapeton

#endif
