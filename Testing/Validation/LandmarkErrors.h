#ifndef LandmarkErrors_h
#define LandmarkErrors_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonLandmarks.h"

#include <array>
#include <vector>

/** How far landmarks are from those of a phantom. */
struct LandmarkErrors
{
  /** Along the centreline, mm, from where one true segment ends and the next begins: the rectosigmoid,
   * descending-sigmoid, splenic and hepatic flexure. Infinite where it was not found. */
  std::array<double, 4> flexures{};
  /** What was stated of each: the probability that it lies within 30 mm; 0 where it was not found. */
  std::array<double, 4> flexureConfidence{};
  bool                  areFlexuresWithin30{ false };
  /** Share of the surface, by area, that has its true segment; collapsed stretches count. */
  double labelledShare{ 0.0 };
  /** From the points of the true taeniae to the taenia that was found, collapsed stretches left out, mm. Infinite where
   * there are none. No fold tells how far a taenia turns inside a collapsed stretch, so found taeniae are assigned to
   * true ones anew in each open stretch. */
  double taeniaMean{ 0.0 };
  double taenia95{ 0.0 };
  double taeniaGreatest{ 0.0 };
  /** Of the three taeniae the one with the greatest mean distance, mm. */
  double taeniaWorstMean{ 0.0 };
  /** Share of those points within 10 mm. */
  double taeniaWithin10{ 0.0 };
  /** The same share with one assignment for the whole colon. */
  double taeniaIdentified10{ 0.0 };
};

LandmarkErrors
MeasureLandmarks(const shapeton::ColonLandmarks & landmarks,
                 const shapeton::CurveSet &       centreline,
                 const shapeton::ColonAnatomy &   anatomy);

/** A point on each true taenia in the middle of the transverse colon, where a person sees them best: the nearest one to
 * the middle that lies on the surface, as some of the wall is hidden from it, and not on a fold in which the taeniae
 * meet. */
std::vector<Eigen::Vector3d>
MarkersOfTruth(const shapeton::ColonAnatomy & anatomy, const shapeton::SurfaceMesh & surface);

/** Of a point from a line of straight pieces, mm. Infinite where it has none. */
double
DistanceToLine(const Eigen::Vector3d & point, const std::vector<Eigen::Vector3d> & line);

#endif
