#ifndef shapetonColonSegments_h
#define shapetonColonSegments_h

#include "shapetonRemarks.h"
#include "shapetonColonFlexures.h"
#include "shapetonColonWallTube.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** Border between two adjacent segments of the colon. \ingroup ShapetonColonLandmarks */
struct SegmentBorder
{
  /** 1 to 4 as in ColonFlexure, 5 between ascending colon and cecum; equals the number of the preceding segment. */
  int number{ 0 };
  /** Position on the centerline, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  double          arcLength{ 0.0 };
  double          confidence{ 0.0 };
  /** Closed loop of edges, once around the tube. */
  SurfaceWalk loop;
};

/** The segments of a colon: the border loops and the label of each face of the wall. See FindColonSegments().
 * \ingroup ShapetonColonLandmarks */
struct ColonSegments
{
  /** In ascending order; missing borders are omitted. */
  std::vector<SegmentBorder> borders;
  /** For each face: 1 rectum (with the anal canal), 2 sigmoid, 3 descending, 4 transverse, 5 ascending, 6 cecum; 0 if
   * unknown because a border is missing. */
  std::vector<int> segmentOfFace;
  /** Whether the border of the cecum is at the ileocecal valve rather than estimated from the average length of a
   * cecum. */
  bool    isCecumAtValve{ false };
  Remarks warnings;
};

/** Number of segments, rectum to cecum. \ingroup ShapetonColonLandmarks */
constexpr int NumberOfColonSegments = 6;

/** "rectum", "sigmoid", ... in radiological terms; "unknown" for 0, empty for other numbers.
 * \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT std::string
                              NameOfSegment(int segment);

/** A closed edge loop once around the tube, near the plane through `point` with this normal (dissertation 4.2.2: plane
 * orthogonal to the centerline, Dijkstra's shortest path). The cost per mm of edge is 1 + (d / 5 mm)^2, where d is the
 * distance from the plane. The search covers the wall within 70 mm of `arcLength` along the centerline, then within 140
 * mm. Empty if neither contains a loop. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT SurfaceWalk
FindLoop(const ColonWallTube &   tube,
         const Eigen::Vector3d & point,
         const Eigen::Vector3d & normal,
         double                  arcLength,
         const Progress &        progress = {});

/** Finds the six segments between loops at the flexures. The cecum begins at the ileocecal valve if it is known (see
 * IleocecalValveOf()), otherwise at a straight distance of 6 cm from the end of the centerline (Gray's Anatomy, 41st
 * ed.). \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT ColonSegments
FindColonSegments(const ColonWallTube & tube,
                  const CurveSet &      centerline,
                  const ColonFlexures & flexures,
                  const Progress &      progress = {});
} // namespace shapeton

#endif
