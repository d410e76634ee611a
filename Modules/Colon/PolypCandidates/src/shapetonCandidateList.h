#ifndef shapetonCandidateList_h
#define shapetonCandidateList_h

#include "shapetonPolypCandidates.h"

namespace shapeton
{
/** Marks unusable vertices: on a bridge, or within 3 mm of a rim along edges. */
std::vector<char>
FindNoWall(const SurfaceMesh & wall, const SurfaceConnectivity & connectivity);

PolypCandidate
CandidateOf(WallBulge bulge, const PolypFeatures & features, double score, const SurfaceMesh & wall);

/** Appends a remark unless empty. */
void
AddRemark(const std::string & remark, PolypCandidate & candidate);

/** Sorts by descending score; stable. */
void
SortByScore(std::vector<PolypCandidate> & candidates);

/** SortByScore(), then numbers from 1. */
void
Rank(std::vector<PolypCandidate> & candidates);

/** Ranks candidates and removes duplicates. Of two heads that share more than a tenth of the vertices of the smaller
 * one, or whose centers are closer than half the larger diameter, the one with the lower score is removed. */
void
SortAndNumber(std::vector<PolypCandidate> & candidates);

/** Sample points (LPS, mm) below the vertices of a head, at a third of the smallest diameter (1 to 4 mm) toward the
 * center. */
std::vector<Eigen::Vector3d>
PointsBelowSurface(const SurfaceMesh & wall, const PolypCandidate & candidate);
} // namespace shapeton

#endif
