#ifndef LandmarkErrors_h
#define LandmarkErrors_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonLandmarks.h"

#include <array>
#include <vector>

/** Errors of landmarks relative to the landmarks of a phantom. */
struct LandmarkErrors
{
  /** Errors along the centerline (mm) of the true segment borders: the rectosigmoid, descending-sigmoid, splenic and
   * hepatic flexure. Infinite if the flexure was not found. */
  std::array<double, 4> flexures{};
  /** Confidence that each flexure is within 30 mm; 0 if not found. */
  std::array<double, 4> flexureConfidence{};
  bool                  areFlexuresWithin30{ false };
  /** Fraction of the surface area with the correct segment; includes collapsed sections. */
  double labeledShare{ 0.0 };
  /** Distances from points of the true taeniae to the found taenia, excluding collapsed sections (mm). Infinite if none
   * was found. Folds do not show the rotation of taeniae inside a collapsed section, so found taeniae are assigned to
   * true ones separately in each open section. */
  double taeniaMean{ 0.0 };
  double taenia95{ 0.0 };
  double taeniaGreatest{ 0.0 };
  /** Greatest mean distance of the three taeniae (mm). */
  double taeniaWorstMean{ 0.0 };
  /** Fraction of those points within 10 mm. */
  double taeniaWithin10{ 0.0 };
  /** Root mean square of those distances, each relative to the circumference of the wall without folds, as in Wei et
   * al., Medical Physics 39 (2012): normalized RMSE. */
  double taeniaOfTurn{ 0.0 };
  /** Fraction within 10 mm with a single assignment for the whole colon. */
  double taeniaIdentified10{ 0.0 };
};

LandmarkErrors
MeasureLandmarks(const shapeton::ColonLandmarks & landmarks,
                 const shapeton::CurveSet &       centerline,
                 const shapeton::ColonAnatomy &   anatomy);

/** A point on each true taenia in the middle of the transverse colon, where they are most visible to a reader: the
 * point nearest to the middle on the visible surface, but not on a fold in which the taeniae meet. */
std::vector<Eigen::Vector3d>
MarkersOfTruth(const shapeton::ColonAnatomy & anatomy, const shapeton::SurfaceMesh & surface);

/** Distance of a point from a polyline (mm); infinite if the polyline is empty. */
double
DistanceToLine(const Eigen::Vector3d & point, const std::vector<Eigen::Vector3d> & line);

#endif
