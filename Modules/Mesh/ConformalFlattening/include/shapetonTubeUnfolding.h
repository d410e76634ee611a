#ifndef shapetonTubeUnfolding_h
#define shapetonTubeUnfolding_h

#include "shapetonConformalTube.h"

#include <functional>

namespace shapeton
{
/** What closes the hole where a blind pouch was cut off. \ingroup ConformalFlattening */
struct PouchCap
{
  /** The length of its rim, mm. */
  double neck{ 0.0 };
  /** Of the wall that was cut off, mm^2. */
  double area{ 0.0 };
  /** The mean of the vertices of its rim; LPS, mm. */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
};

/** A tube with a flat map of which no face is flipped. \ingroup ConformalFlattening */
struct UnfoldedTube
{
  /** The surface that `map` shows: the one given, where it has no folds or no pouches. Else pouches are replaced by
   * caps: the cell array `cap` has the number of the cap from 1 on, 0 on the wall, whose faces are those given, in
   * their order. The point array `wallPointId` has the vertex of the surface given, -1 inside caps. */
  SurfaceMesh surface;
  TubeEnds    ends;
  /** Of the edges of `surface` in the metric. */
  Eigen::VectorXd edgeLengths;
  TubeMap         map;
  /** Number i is element i - 1. */
  std::vector<PouchCap> caps;
  /** How often u and v were computed. */
  int solves{ 0 };
};

/** The lengths of the edges of a surface in the metric of a map, in their order; with progress.
 *
 * \ingroup ConformalFlattening */
using TubeMetric =
  std::function<Eigen::VectorXd(const SurfaceMesh &, const SurfaceConnectivity &, const Progress & progress)>;

/** FlattenTube(), and again until no face of the flat surface is flipped (FlippedFaces(), which does not round). A map
 * without folds is that of FlattenTube(), byte by byte. Else
 * - blind pouches that fall below 1e-6 of the mean area scale are cut off where it falls below 1e-3, and their holes
 *   are closed by caps: nothing is to be seen of their bottoms, whose places drown in rounding;
 * - weights of edges at flipped faces, from the third map on also one ring around, are brought between bounds that
 * close in on 1 with each map (BoundedWeights());
 * - what is flipped after 8 maps is cut off, with the pouch around it where the scale is below 1e-3;
 * - at last all weights are brought between bounds, which makes an embedding but for rounding.
 *
 * Handles must fold: where the tube has some nothing is cut off, faces within 3 rings of them are let be, and the first
 * map is given where that leaves others flipped.
 *
 * The published conjugate is folded wherever it likes: it is mapped once.
 *
 * \pre As for FlattenTube(); no edge but those of the ends has both vertices on one end: TrimEars().
 * \ingroup ConformalFlattening */
ConformalFlattening_EXPORT UnfoldedTube
FlattenWithoutFolds(SurfaceMesh         mesh,
                    const TubeEnds &    ends,
                    const TubeMetric &  metric,
                    const TubeOptions & options = {});

/** The faces of caps; empty for a surface without any. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT std::vector<char>
                           FacesOfCaps(const SurfaceMesh & surface);
} // namespace shapeton

#endif
