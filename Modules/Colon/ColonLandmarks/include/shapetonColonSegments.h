#ifndef shapetonColonSegments_h
#define shapetonColonSegments_h

#include "shapetonRemarks.h"
#include "shapetonColonFlexures.h"
#include "shapetonColonWallTube.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** Border between two consecutive segments of the colon. \ingroup ShapetonColonLandmarks */
struct SegmentBorder
{
  /** 1 to 4 as in ColonFlexure, 5 between ascending colon and cecum; also the number of the segment before the
   * border. */
  int number{ 0 };
  /** Position on the centerline, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  double          arcLength{ 0.0 };
  double          confidence{ 0.0 };
  /** Loop once around the tube, along edges. */
  SurfaceWalk loop;
};

/** The segments of a colon: the loops between them and the segment of each face of the wall. See FindColonSegments().
 * \ingroup ShapetonColonLandmarks */
struct ColonSegments
{
  /** In ascending order; missing borders are left out. */
  std::vector<SegmentBorder> borders;
  /** For each face: 1 rectum (with the anal canal), 2 sigmoid, 3 descending, 4 transverse, 5 ascending, 6 cecum; 0 if
   * unknown because a border is missing. */
  std::vector<int> segmentOfFace;
  /** Whether the cecum ends at the ileocecal valve rather than after its average length. */
  bool    isCecumAtValve{ false };
  Remarks warnings;
};

/** Number of segments, rectum to cecum. \ingroup ShapetonColonLandmarks */
constexpr int NumberOfColonSegments = 6;

/** "rectum", "sigmoid", ... in radiological terms; "unknown" for 0, empty for other numbers.
 * \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT std::string
                      NameOfSegment(int segment);

/** A closed walk once around the tube, near the plane through `point` with this normal (dissertation 4.2.2: the plane
 * is orthogonal to the centerline, Dijkstra's shortest path joins its points). One mm of edge costs 1 + (d / 5 mm)^2, d
 * the distance from the plane. Walks stay within 70 mm along the centerline of `arcLength`, or 140 mm if none is found.
 * Empty if none is found there either. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT SurfaceWalk
FindLoop(const ColonWallTube &   tube,
         const Eigen::Vector3d & point,
         const Eigen::Vector3d & normal,
         double                  arcLength,
         const Progress &        progress = {});

/** Finds the six segments between loops at the flexures. The cecum has no flexure: it begins at the ileocecal valve if
 * the centerline has one (see IleocecalValveOf()), otherwise 6 cm, straight, from the end of the centerline, its
 * length in anatomy (Gray's Anatomy, 41st ed.). \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT ColonSegments
FindColonSegments(const ColonWallTube & tube,
                  const CurveSet &      centerline,
                  const ColonFlexures & flexures,
                  const Progress &      progress = {});
} // namespace shapeton

#endif
