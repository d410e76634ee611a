#ifndef shapetonColonTaeniae_h
#define shapetonColonTaeniae_h

#include "shapetonRemarks.h"
#include "shapetonColonWallTube.h"
#include "shapetonProgress.h"

#include <array>

namespace shapeton
{
/** How taeniae are found. \ingroup ColonLandmarks */
enum class TaeniaRule
{
  /** Windowed fuzzy C-means and a joint programme for three paths; the one with less energy is kept. */
  Joint,
  /** The tightest track of the fuzzy C-means, the others at one and two thirds of the circumference (dissertation
   * 4.2.1). */
  Published
};

/** One of the three bands of muscle. \ingroup ColonLandmarks */
struct ColonTaenia
{
  /** From the rectum to the caecum: on the wall, LPS, mm. */
  std::vector<Eigen::Vector3d> points;
  /** mm; v in [0, circumference). */
  std::vector<Eigen::Vector2d> uv;
  /** mm along the centreline. */
  std::vector<double> arcLength;
  /** 0 to 1: how much fold ends near by tell of the place, and the two methods agree on it. */
  std::vector<double> confidence;
};

/** A marker that a person has set. \ingroup ColonLandmarks */
struct UsedMarker
{
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** 1 to 3. */
  int taenia{ 0 };
  /** Of the marker from the wall, and of the taenia from the marker's place on the wall, mm. */
  double distanceFromWall{ 0.0 };
  double distanceOfTaenia{ 0.0 };
};

/** Rule and marked points for FindColonTaeniae(). \ingroup ColonLandmarks */
struct ColonTaeniaOptions
{
  TaeniaRule rule{ TaeniaRule::Joint };
  /** Points on taeniae, LPS, mm; the taeniae pass through them. */
  std::vector<Eigen::Vector3d> markers;
  /** It may throw in order to abort. */
  Progress progress;
};

/** The three taeniae of a colon on its wall, and how well they are supported. See FindColonTaeniae().
 * \ingroup ColonLandmarks */
struct ColonTaeniae
{
  TaeniaRule rule{ TaeniaRule::Joint };
  /** Three, or none where the wall has too few folds to tell. In the order of rows of the flat picture, the best
   * supported first. */
  std::vector<ColonTaenia> taeniae;
  std::string              reason; ///< why there are none
  /** "joint" or "fuzzyCMeans" or "thirds": what was kept. */
  std::string kept;
  /** Per row of the programme; not a number where the method was not run. */
  double jointEnergy{ 0.0 };
  double fuzzyEnergy{ 0.0 };
  /** Between the two methods, mm on the wall: mean, and the share of the length where it is above 10 mm. */
  double                  meanDisagreement{ 0.0 };
  double                  disagreeingShare{ 0.0 };
  std::vector<UsedMarker> markers;
  Remarks                 warnings;
};

/** "joint", "published". \ingroup ColonLandmarks */
ColonLandmarks_EXPORT std::string
                      NameOf(TaeniaRule rule);

/** The three taeniae of a flat colon: the bands where haustral folds end (dissertation 4.2.1).
 *
 * Folds are those of FindHaustralFolds(). Evidence on a grid of rows (2.8 mm of the map) along and 72 angles around the
 * tube: the density of folds, less that of their ends, less how far the wall between folds stands out towards the axis
 * and how little it is hollow (haustra bulge outwards between taeniae; without the first two harmonics, which come from
 * bends).
 * - Fuzzy C-means (c = 3, m = 2; Bezdek 1981) of the angles of fold ends in windows of 150 mm, from window to window.
 * - Three paths at once by dynamic programming: state (angle, two gaps), gaps of 45 to 225 degrees; in each row all
 *   turn by a step at most, and each by one more. Each costs the same for all tracks: a mirrored wall has mirrored
 *   taeniae. Exact.
 * Both are measured by the energy of the programme. Taeniae pass through markers, which pull the paths and then a bump
 * of 60 mm moves the rest.
 *
 * Throws InputError where a marker lies more than 15 mm from the wall. \ingroup ColonLandmarks */
ColonLandmarks_EXPORT ColonTaeniae
FindColonTaeniae(const FlatColon & flat, const ColonWallTube & tube, const ColonTaeniaOptions & options = {});

/** Three curves with the cell array taenia (1 to 3) and the point arrays arcLength (mm), uv and confidence.
 * \ingroup ColonLandmarks */
ColonLandmarks_EXPORT CurveSet
TaeniaCurves(const ColonTaeniae & taeniae);
} // namespace shapeton

#endif
