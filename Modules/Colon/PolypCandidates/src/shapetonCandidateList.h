#ifndef shapetonCandidateList_h
#define shapetonCandidateList_h

#include "shapetonPolypCandidates.h"

namespace shapeton
{
/** For each vertex whether it is no wall: on a bridge, or within 3 mm, along edges, of a rim. */
std::vector<char>
FindNoWall(const SurfaceMesh & wall, const SurfaceConnectivity & connectivity);

PolypCandidate
CandidateOf(WallBulge bulge, const PolypFeatures & features, double score, const SurfaceMesh & wall);

/** After what was noted before; nothing for "". */
void
AddRemark(const std::string & remark, PolypCandidate & candidate);

/** By falling score; those of equal score keep their order. */
void
SortByScore(std::vector<PolypCandidate> & candidates);

/** SortByScore(), numbered from 1. */
void
Rank(std::vector<PolypCandidate> & candidates);

/** Ranked; of two whose heads share more than a tenth of the smaller one's vertices, or whose middles are
 * nearer than half of the larger diameter, the one with the lower score goes. */
void
SortAndNumber(std::vector<PolypCandidate> & candidates);

/** LPS, mm: for each vertex of a head a place on the way to its middle, a third of the least diameter deep, 1 to 4 mm.
 */
std::vector<Eigen::Vector3d>
PointsBelowSurface(const SurfaceMesh & wall, const PolypCandidate & candidate);
} // namespace shapeton

#endif
