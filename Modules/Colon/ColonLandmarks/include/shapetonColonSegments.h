#ifndef shapetonColonSegments_h
#define shapetonColonSegments_h

#include "shapetonRemarks.h"
#include "shapetonColonFlexures.h"
#include "shapetonColonWallTube.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** Where one segment of the colon ends and the next begins. \ingroup ColonLandmarks */
struct SegmentBorder
{
  /** 1 to 4 as ColonFlexure, 5 between ascending colon and caecum. The segment before it has this number. */
  int number{ 0 };
  /** On the centreline, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  double          arcLength{ 0.0 };
  double          confidence{ 0.0 };
  /** Once around the tube, along edges. */
  SurfaceWalk loop;
};

/** The segments of a colon: the loops between them and the segment of each face of the wall. See FindColonSegments().
 * \ingroup ColonLandmarks */
struct ColonSegments
{
  /** In ascending order; those that were not found are left out. */
  std::vector<SegmentBorder> borders;
  /** For each face: 1 rectum (with the anal canal), 2 sigmoid, 3 descending, 4 transverse, 5 ascending, 6 caecum; 0
   * where a border is missing, so that it cannot be said. */
  std::vector<int> segmentOfFace;
  /** Whether the caecum ends at the ileocaecal valve, not after its average length. */
  bool    isCaecumAtValve{ false };
  Remarks warnings;
};

/** Rectum to caecum. \ingroup ColonLandmarks */
constexpr int NumberOfColonSegments = 6;

/** "rectum", "sigmoid", ... as radiologists name them; "unknown" for 0, empty for other numbers.
 * \ingroup ColonLandmarks */
ColonLandmarks_EXPORT std::string
                      NameOfSegment(int segment);

/** A closed walk once around the tube, near a plane through `point` with this normal (dissertation 4.2.2: the plane is
 * orthogonal to the centreline, Dijkstra's shortest path joins its points). A mm of edge costs 1 + (d / 5 mm)^2, d the
 * distance from the plane; walks stay within 70 mm along the centreline of `arcLength`, or 140 mm where there is none.
 * Empty where there is none there either. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT SurfaceWalk
FindLoop(const ColonWallTube &   tube,
         const Eigen::Vector3d & point,
         const Eigen::Vector3d & normal,
         double                  arcLength,
         const Progress &        progress = {});

/** The six segments between loops at the flexures that were found. The caecum has no flexure: it begins at the
 * ileocaecal valve, where the centreline knows of one (see IleocaecalValveOf()), else where the centreline is 6 cm from
 * its end, straight, its length in anatomy (Gray's Anatomy, 41st ed.). \ingroup ColonLandmarks */
ColonLandmarks_EXPORT ColonSegments
FindColonSegments(const ColonWallTube & tube,
                  const CurveSet &      centreline,
                  const ColonFlexures & flexures,
                  const Progress &      progress = {});
} // namespace shapeton

#endif
