#ifndef shapetonLumenReport_h
#define shapetonLumenReport_h

#include "shapetonLumenVoxels.h"

namespace shapeton
{
void
WriteLabels(const ColonImage * image, const LumenVoxels & voxels, ColonLumen & lumen);

/** Connected parts of the lumen of at least 0.05 ml; WriteLabels() removes smaller parts from the labels. */
void
DescribePieces(const LumenVoxels & voxels, ColonLumen & lumen);

void
DescribeLevels(const ColonEvidence & evidence, const LumenVoxels & voxels, ColonLumen & lumen);

/** Lists other matter as bright as the fluid of the colon, with a volume of at least 10 ml and an inscribed radius of
 * at least 7 mm. */
void
DescribeOtherBright(const LumenVoxels & voxels, ColonLumen & lumen);

/** Reports thresholds, noise, and gas of at least 1 ml outside the colon. */
void
DescribeRest(const ColonEvidence & evidence, ColonLumen & lumen);

/** Sets the failure if the lumen is not usable. */
void
JudgeLumen(const ColonEvidence & evidence, ColonLumen & lumen);
} // namespace shapeton

#endif
