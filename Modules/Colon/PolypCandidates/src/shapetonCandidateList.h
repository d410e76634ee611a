#ifndef shapetonCandidateList_h
#define shapetonCandidateList_h

#include "shapetonPolypCandidates.h"

namespace shapeton
{
/** Marks vertices that are not usable wall: on a bridge, or within 3 mm, along edges, of a rim. */
std::vector<char>
FindNoWall(const SurfaceMesh & wall, const SurfaceConnectivity & connectivity);

PolypCandidate
CandidateOf(WallBulge bulge, const PolypFeatures & features, double score, const SurfaceMesh & wall);

/** Appends a remark; ignores "". */
void
AddRemark(const std::string & remark, PolypCandidate & candidate);

/** Sorts by descending score; stable. */
void
SortByScore(std::vector<PolypCandidate> & candidates);

/** SortByScore(), then numbers from 1. */
void
Rank(std::vector<PolypCandidate> & candidates);

/** Ranks candidates and removes duplicates: of two whose heads share more than a tenth of the vertices of the smaller
 * one, or whose centers are nearer than half of the larger diameter, the one with the lower score is dropped. */
void
SortAndNumber(std::vector<PolypCandidate> & candidates);

/** For each vertex of a head a point (LPS, mm) toward its center, a third of the least diameter deep, 1 to 4 mm. */
std::vector<Eigen::Vector3d>
PointsBelowSurface(const SurfaceMesh & wall, const PolypCandidate & candidate);
} // namespace shapeton

#endif
