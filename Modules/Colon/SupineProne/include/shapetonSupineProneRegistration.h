#ifndef shapetonSupineProneRegistration_h
#define shapetonSupineProneRegistration_h

#include "shapetonRemarks.h"
#include "shapetonColonPosition.h"
#include "shapetonCylinderMap.h"
#include "shapetonFoldMatching.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** Method by which RegisterColonPositions() builds its map from correspondences. \ingroup ShapetonSupineProne */
enum class SupineProneMap
{
  /** Warped, corrected by consistent folds and taeniae, projected to a bijection. */
  Default,
  /** As in the dissertation (4.3, 5.4.2; Zeng, Marino, Gurijala, Gu, Kaufman 2010): folds are matched once, segment by
   * segment, about a conformal map between flexures and along the main taenia. The final map is quasi-conformal and is
   * forced through flexures, this taenia and the ends of all matched folds, right or wrong. Triangles may be flipped.
   * See FindQuasiConformalMap(). */
  Published
};

/** Options of RegisterColonPositions(). \ingroup ShapetonSupineProne */
struct SupineProneOptions
{
  SupineProneMap     map{ SupineProneMap::Default };
  FoldMatchingMethod matching{ FoldMatchingMethod::Hungarian };
  /** Default map only: folds and rows stay in their segment of the colon, between flexures found in both positions. */
  bool isSegmentWise{ false };
  /** Default map only: refine by the curvature of the wall itself. Useful if folds do not slide on the wall. */
  bool refines{ false };
  /** Greatest absolute Beltrami coefficient of the map. */
  double greatestDilatation{ 0.8 };
  /** May throw to abort. */
  Progress progress;
};

/** A matched pair of folds. \ingroup ShapetonSupineProne */
struct FoldMatch
{
  /** Indices into ColonPosition::folds. */
  int    source{ 0 };
  int    target{ 0 };
  double cost{ 0.0 };
  /** Distance (mm) between the center of the source fold under the final map and the center of the target fold. */
  double residual{ 0.0 };
  /** How much the map follows the pair, 0 to 1; below 0.5 the pair contradicts its neighbors. */
  double weight{ 0.0 };
  /** 0 before the first flexure found in both positions, 1 after it, ... */
  int segment{ 0 };
};

/** Confidence of the registration. \ingroup ShapetonSupineProne */
struct RegistrationConfidence
{
  /** 0 to 1; below 0.5 the registration is flagged. */
  double whole{ 0.0 };
  bool   isFlagged{ true };
  /** Reasons for the flag, in words. */
  std::vector<std::string> reasons;
  /** Number of pairs that the map follows, relative to the smaller number of folds. */
  double matchedShare{ 0.0 };
  /** Share of the pairs that the map does not follow. */
  double contradictedShare{ 0.0 };
  /** Least mean cost of a row near the warp; about 0 or below where folds agree. */
  double energy{ 0.0 };
  /** `energy`, then the energies near the warp rotated by one and by two thirds of a turn; detects confused taeniae. */
  std::vector<double> energies;
  /** Smaller energy of the rotated warps minus that of the warp. */
  double margin{ 0.0 };
  /** Energy of the best of the three other orientations of the picture (mirrored, reversed, both) minus that of the
   * right one, without landmarks. About 0 for two patients. */
  double senseMargin{ 0.0 };
  /** Root mean square of the residuals of the pairs that the map follows, mm. */
  double residual{ 0.0 };
  /** Confidence of each node of the map, 0 to 1. */
  Eigen::MatrixXd ofNodes;

  /** Probability that both positions are of one patient: log odds of matchedShare, energy, margin and senseMargin, each
   * at most 4, added to even odds, but at most those of senseMargin alone, since a few folds can be similar in two
   * patients. Each is 0 midway between values measured on one patient and on two, so folds visible in only one position
   * do not outweigh a picture that fits in only one orientation. */
  ShapetonSupineProne_EXPORT double
  ProbabilityOfOnePatient() const;
};

/** Figures measured during registration. \ingroup ShapetonSupineProne */
struct RegistrationFigures
{
  int    flips{ 0 };
  int    flipsBeforeProjection{ 0 };
  double greatestDilatation{ 0.0 };
  /** \name Published map, see QuasiConformalMap: number of solves, and largest landmark violation, mm */
  ///@{
  int    solves{ 0 };
  double greatestMiss{ 0.0 };
  ///@}
};

/** A one-to-one map between the walls of a colon in two positions, with the matched folds and its confidence. See
 * RegisterColonPositions(). \ingroup ShapetonSupineProne */
struct SupineProneRegistration
{
  /** The registered flat walls. */
  std::shared_ptr<const FlatColon>     sourceFlat;
  std::shared_ptr<const FlatColon>     targetFlat;
  std::shared_ptr<const ColonCylinder> source;
  std::shared_ptr<const ColonCylinder> target;
  /** From source to target. */
  CylinderMap map;
  /** Initial frame of flexures and taeniae, for comparison. */
  CylinderMap frame;
  /** The warping, before fold matching. */
  CylinderMap            warp;
  std::vector<FoldMatch> matches;
  FoldMatching           matching;
  RegistrationConfidence confidence;
  RegistrationFigures    figures;
  /** Distances along source and target of the flexures used, mm. */
  std::vector<std::pair<double, double>> flexures;
  /** Whether the wall at each node of the map is not visible in one of the positions. */
  Eigen::Matrix<char, Eigen::Dynamic, Eigen::Dynamic> isExcluded;
  Remarks                                             warnings;
};

/** Computes a one-to-one map between the walls of a colon in two positions.
 *
 * 1. Frame: distance along the centerline, piecewise linear between flexures; rotation from the three taeniae.
 * 2. Cylindrical dynamic time warping of pictures of folds and taeniae about several frames, free in rotation. The warp
 *    with the most folds that find a partner under a smooth map wins.
 * 3. Matching of folds about the warp (MatchFolds()), and twice again about the corrected warp.
 * 4. A thin plate through centers and ends of matched folds, robust against wrong pairs.
 * 5. Projection to a bijection: no triangle is flipped.
 *
 * SupineProneMap::Published replaces steps 3 to 5.
 *
 * In excluded stretches the map is interpolated from both sides and marked. Equal input gives equal results for any
 * number of threads. Throws InputError when a position has no folds, or neither flexures nor taeniae, or appears
 * reversed or mirrored. Source: dissertation 4.3; warping after Nain et al. 2002; see the README for the measured
 * figures. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT SupineProneRegistration
RegisterColonPositions(const ColonPosition &      source,
                       const ColonPosition &      target,
                       const SupineProneOptions & options = {});

/** Maps a place of the flat map, mm. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT Eigen::Vector2d
                   MapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & sourceUv);

/** Inverse of MapUv(); NaN where the map is not a bijection. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT Eigen::Vector2d
                   InverseMapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & targetUv);

/** Confidence at a place of the source, 0 to 1. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT double
ConfidenceAt(const SupineProneRegistration & registration, const CylinderPlace & place);

/** Whether a place of the source, or its image, is excluded. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT bool
IsExcludedAt(const SupineProneRegistration & registration, const CylinderPlace & place);
} // namespace shapeton

#endif
