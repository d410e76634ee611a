#ifndef shapetonColonStatistics_h
#define shapetonColonStatistics_h

#include "shapetonColonVolume.h"

namespace shapeton
{
/** The mode of soft tissue, HU; 40 where the volume shows none between -20 and 120. */
double
ModeOfTissue(const std::vector<float> & hu);

/** Standard deviation of noise in soft tissue: the lower quartile of that in blocks of about 5 mm with a mean within 60
 * HU of `tissue`. 0 where fewer than 20 blocks are found. */
double
NoiseInTissue(const ColonGrid & grid, const std::vector<float> & hu, double tissue);

/** Gaussian smoothing in place, sigma in mm, the border value going on beyond the border. */
void
SmoothVoxels(const ColonGrid & grid, std::vector<float> & hu, double sigma);

/** What the middle of a wall of 2 mm between two bowels still shows of their contrast, 0..1, after a prefilter of sigma
 * `smoothing` in mm. */
double
ShareInWall(const ColonGrid & grid, double smoothing);
} // namespace shapeton

#endif
