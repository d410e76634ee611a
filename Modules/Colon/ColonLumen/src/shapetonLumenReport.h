#ifndef shapetonLumenReport_h
#define shapetonLumenReport_h

#include "shapetonLumenVoxels.h"

namespace shapeton
{
ColonLumen::LabelImageType::Pointer
EmptyLabels(const ColonImage * image);

void
WriteLabels(const ColonImage * image, const LumenVoxels & voxels, ColonLumen & lumen);

/** Connected parts of the lumen from 0.05 ml on; smaller ones are taken out of the labels by WriteLabels(). */
void
DescribePieces(const LumenVoxels & voxels, ColonLumen & lumen);

void
DescribeLevels(const ColonEvidence & evidence, const LumenVoxels & voxels, ColonLumen & lumen);

/** What is as bright as the colon's fluid but not colon, from 10 ml on, where it holds a ball of 7 mm radius. */
void
DescribeOtherBright(const LumenVoxels & voxels, ColonLumen & lumen);

/** Thresholds, noise, and gas from 1 ml on that is not colon. */
void
DescribeRest(const ColonEvidence & evidence, ColonLumen & lumen);

/** Says why the lumen is not usable, if so. */
void
JudgeLumen(const ColonEvidence & evidence, ColonLumen & lumen);
} // namespace shapeton

#endif
