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
 * the first of which the filter uses. Reports the progress of the run from 0 to `end`. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT std::vector<HeatParameterChoice>
                         ChooseWindows(CommandLine &                                              commandLine,
                                       const std::string &                                        modality,
                                       double                                                     end,
                                       CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** Creates the folder --windowFolder, if given. Then throws ParameterError if the preset is not objects, or if
 * --snapshotSteps is given.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
MakeWindowFolder(CommandLine & commandLine);

/** Writes the heat of each window into --windowFolder, if it is given. The filter must contain the heat of the first
 * window; it is run again for the others. The progress of the run is reported from `start` to `end`. Throws the
 * exceptions of the filter, and OutputError. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
WriteHeatWindows(CommandLine &                                              commandLine,
                 const HeatResultFiles &                                    files,
                 const std::vector<HeatParameterChoice> &                   windows,
                 double                                                     start,
                 double                                                     end,
                 CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>> * filter);
} // namespace shapeton

#endif
