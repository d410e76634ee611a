#ifndef shapetonExplorerData_h
#define shapetonExplorerData_h

#include "shapetonExplorerInfo.h"
#include "shapetonHeatExplorer.h"
#include "shapetonPageBlocks.h"

#include <string>

namespace shapeton
{
/** Histogram bins of the voxels of a volume with values in [0, 1]. */
void
PutBins(PageBlocks & blocks, const std::string & name, const itk::Image<float, 3> * values);

/** Gray values of the slices. */
void
PutGray(PageBlocks & blocks, const itk::Image<float, 3> * gray, const IntensityWindow & window);

/** The smallest object of each voxel. */
void
PutLabels(PageBlocks & blocks, const HeatObjectList::LabelImage * labels);

void
PutCounts(PageBlocks & blocks, const std::string & name, const HeatHistogram & histogram);

/** The page, which reads its data from a folder next to it. */
void
WriteExplorerPage(const std::string & path, const std::string & dataFolder);
} // namespace shapeton

#endif
