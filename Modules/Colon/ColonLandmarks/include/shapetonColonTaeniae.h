#ifndef shapetonColonTaeniae_h
#define shapetonColonTaeniae_h

#include "shapetonRemarks.h"
#include "shapetonColonWallTube.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** Method that finds the taeniae coli. \ingroup ShapetonColonLandmarks */
enum class TaeniaRule
{
  /** Windowed fuzzy C-means and joint dynamic programming for three paths; the lower-energy result is kept. */
  Joint,
  /** The most compact track found by fuzzy C-means, and two tracks one third and two thirds of the circumference away
   * from it (dissertation 4.2.1). */
  Published
};

/** One of the three bands of longitudinal muscle. \ingroup ShapetonColonLandmarks */
struct ColonTaenia
{
  /** Points on the wall from the rectum to the cecum, LPS, mm. */
  std::vector<Eigen::Vector3d> points;
  /** Points on the map, mm; v in [0, circumference). */
  std::vector<Eigen::Vector2d> uv;
  /** mm along the centerline. */
  std::vector<double> arcLength;
  /** 0 to 1, from nearby fold ends and the agreement of the two methods. */
  std::vector<double> confidence;
};

/** A manually set marker. \ingroup ShapetonColonLandmarks */
struct UsedMarker
{
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** Number of the taenia, 1 to 3. */
  int taenia{ 0 };
  /** Distances (mm) from the marker to the wall, and from its projection on the wall to the taenia. */
  double distanceFromWall{ 0.0 };
  double distanceOfTaenia{ 0.0 };
};

/** Options of FindColonTaeniae(). \ingroup ShapetonColonLandmarks */
struct ColonTaeniaOptions
{
  TaeniaRule rule{ TaeniaRule::Joint };
  /** Points on taeniae coli, LPS, mm; the result passes through them. */
  std::vector<Eigen::Vector3d> markers;
  /** May throw to abort. */
  Progress progress;
};

/** The three taeniae coli on the wall of a colon, with confidences. See FindColonTaeniae().
 * \ingroup ShapetonColonLandmarks */
struct ColonTaeniae
{
  TaeniaRule rule{ TaeniaRule::Joint };
  /** Three taeniae; empty if too few folds are found. In the row order of the flat image, starting with the one best
   * supported by the evidence. */
  std::vector<ColonTaenia> taeniae;
  std::string              reason; ///< why none were found
  /** Method whose result is kept: "joint", "fuzzyCMeans" or "thirds". */
  std::string kept;
  /** Energy per row; NaN for a method that was not run. */
  double jointEnergy{ 0.0 };
  double fuzzyEnergy{ 0.0 };
  /** Disagreement between the two methods on the wall: mean (mm), and fraction of the length where it exceeds 10 mm. */
  double                  meanDisagreement{ 0.0 };
  double                  disagreeingShare{ 0.0 };
  std::vector<UsedMarker> markers;
  Remarks                 warnings;
};

/** "joint", "published". \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT std::string
                              NameOf(TaeniaRule rule);

/** Finds the three taeniae coli of a flat colon, the bands at which haustral folds end (dissertation 4.2.1).
 *
 * Folds are found by FindHaustralFolds(). The evidence is computed on a grid of rows (2.8 mm of the map) along the tube
 * and 72 angles: the density of folds, minus the density of fold ends, minus a term for wall that is between folds,
 * close to the axis and not concave. Haustra bulge outward between taeniae. The first two harmonics, caused by bends,
 * are removed.
 * - Fuzzy C-means (c = 3, m = 2; Bezdek 1981) of the angles of fold ends in windows of 150 mm, tracked between windows.
 * - Joint and exact dynamic programming of three paths: state (angle, two gaps), gaps of 45 to 225 degrees. In each
 *   row, all paths turn by at most one step together, and each by at most one more. The costs are the same for all
 *   paths, so a mirrored wall results in mirrored taeniae.
 *
 * The results of the two methods are compared by the energy of the dynamic programming. Markers attract the paths; a
 * Gaussian displacement with a standard deviation of 30 mm then moves each taenia exactly through its markers.
 *
 * Throws InputError if a marker is more than 15 mm from the wall. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT ColonTaeniae
FindColonTaeniae(const FlatColon & flat, const ColonWallTube & tube, const ColonTaeniaOptions & options = {});

/** Three curves with the cell array taenia (1 to 3) and the point arrays arcLength (mm), uv and confidence.
 * \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT CurveSet
TaeniaCurves(const ColonTaeniae & taeniae);
} // namespace shapeton

#endif
