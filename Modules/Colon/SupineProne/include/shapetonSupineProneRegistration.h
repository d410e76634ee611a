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
/** How RegisterColonPositions() makes its map of what corresponds. \ingroup SupineProne */
enum class SupineProneMap
{
  /** Warped, corrected by folds and taeniae as far as they agree, projected to a bijection. */
  Default,
  /** As in the dissertation (4.3, 5.4.2; Zeng, Marino, Gurijala, Gu, Kaufman 2010): folds are matched once, segment by
   * segment, about a conformal map between flexures and along the main taenia; the final map is quasi-conformal and is
   * forced through flexures, this taenia and the ends of all matched folds, right or wrong. Triangles may be turned
   * over. See FindQuasiConformalMap(). */
  Published
};

/** What RegisterColonPositions() is to use. \ingroup SupineProne */
struct SupineProneOptions
{
  SupineProneMap     map{ SupineProneMap::Default };
  FoldMatchingMethod matching{ FoldMatchingMethod::Hungarian };
  /** Folds and rows keep to their segment of the colon, between flexures that both positions have; of the default map.
   */
  bool isSegmentWise{ false };
  /** Refine by the curvature of the wall itself: of use where folds do not slide against the wall; of the default map.
   */
  bool refines{ false };
  /** Greatest absolute Beltrami coefficient of the map. */
  double greatestDilatation{ 0.8 };
  /** It may throw in order to abort. */
  Progress progress;
};

/** Two folds that are taken for one. \ingroup SupineProne */
struct FoldMatch
{
  /** Indices of ColonPosition::folds. */
  int    source{ 0 };
  int    target{ 0 };
  double cost{ 0.0 };
  /** Of the final map, mm: from where it takes the middle of the fold to the middle of the other one. */
  double residual{ 0.0 };
  /** How much the map follows it, 0 to 1; below 0.5 it contradicts its neighbours. */
  double weight{ 0.0 };
  /** 0 before the first flexure that both positions have, 1 behind it, ... */
  int segment{ 0 };
};

/** How far the registration can be trusted. \ingroup SupineProne */
struct RegistrationConfidence
{
  /** 0 to 1; below 0.5 the registration is flagged. */
  double whole{ 0.0 };
  bool   isFlagged{ true };
  /** In words, why it is flagged. */
  std::vector<std::string> reasons;
  /** Pairs of folds that the map follows, over the smaller number of folds. */
  double matchedShare{ 0.0 };
  /** Of pairs that it does not follow, among all pairs. */
  double contradictedShare{ 0.0 };
  /** Least mean cost of a row near the warp, about 0 and below where folds agree. */
  double energy{ 0.0 };
  /** The same, and that near the warp turned by one and by two thirds, which is how taeniae may be confused. */
  std::vector<double> energies;
  /** Lesser energy of the turned ones less that of the warp. */
  double margin{ 0.0 };
  /** Energy of the best of the three other ways to lay one picture on the other (mirrored, turned back, both) less that
   * of the right way, without landmarks. About 0 for two patients. */
  double senseMargin{ 0.0 };
  /** Root mean square of the residuals of the pairs that the map follows, mm. */
  double residual{ 0.0 };
  /** 0 to 1, of each node of the map. */
  Eigen::MatrixXd ofNodes;

  /** The probability that both positions are of one patient: log odds of matchedShare, energy, margin and senseMargin,
   * each at most 4, added up from even odds, but not more than those of senseMargin alone, as few folds can be alike in
   * two patients. Each is 0 midway between what was measured of one patient and of two, so that folds that only one
   * position shows do not outweigh a picture that fits in one way alone. */
  SupineProne_EXPORT double
  ProbabilityOfOnePatient() const;
};

/** What was measured on the way. \ingroup SupineProne */
struct RegistrationFigures
{
  int    flips{ 0 };
  int    flipsBeforeProjection{ 0 };
  double greatestDilatation{ 0.0 };
  /** \name The published map, see QuasiConformalMap: maps that were solved for, and by how much a landmark is missed at
   * most, mm */
  ///@{
  int    solves{ 0 };
  double greatestMiss{ 0.0 };
  ///@}
};

/** A one-to-one map between the walls of a colon in two positions, with the matched folds and its confidence. See
 * RegisterColonPositions(). \ingroup SupineProne */
struct SupineProneRegistration
{
  /** The flat walls that it refers to. */
  std::shared_ptr<const FlatColon>     sourceFlat;
  std::shared_ptr<const FlatColon>     targetFlat;
  std::shared_ptr<const ColonCylinder> source;
  std::shared_ptr<const ColonCylinder> target;
  /** From source to target. */
  CylinderMap map;
  /** The frame of flexures and taeniae that it began with, for comparison. */
  CylinderMap frame;
  /** The warping, before folds were matched. */
  CylinderMap            warp;
  std::vector<FoldMatch> matches;
  FoldMatching           matching;
  RegistrationConfidence confidence;
  RegistrationFigures    figures;
  /** Distances along source and target of the flexures that were used, mm. */
  std::vector<std::pair<double, double>> flexures;
  /** Of each node of the map: nothing is to be seen there in one of the positions. */
  Eigen::Matrix<char, Eigen::Dynamic, Eigen::Dynamic> isExcluded;
  Remarks                                             warnings;
};

/** One-to-one map between the walls of a colon in two positions.
 *
 * 1. Frame: the distance along the centreline straight between flexures; rotation from the three taeniae.
 * 2. Cylindrical dynamic time warping of pictures of folds and taeniae about several frames, free in rotation; the warp
 *    wins about which most folds find a partner that a smooth map can follow.
 * 3. Matching of folds about the warp (MatchFolds()), and twice again about the corrected warp.
 * 4. A thin plate through middles and ends of matched folds, robust against wrong pairs.
 * 5. Projection to a bijection: no triangle is turned over.
 *
 * 3 to 5 are another thing for SupineProneMap::Published.
 *
 * Where a stretch is excluded the map is carried on from both sides; it is marked. Equal input gives equal results for
 * any number of threads. Throws InputError where a position has no folds, or neither flexures nor taeniae, or
 * seems to run the wrong way or to be a mirror image. Source: dissertation 4.3; warping after Nain et al. 2002; the
 * measured figures are in the README. \ingroup SupineProne */
SupineProne_EXPORT SupineProneRegistration
RegisterColonPositions(const ColonPosition &      source,
                       const ColonPosition &      target,
                       const SupineProneOptions & options = {});

/** Where a place of the map goes, mm of the flat map. \ingroup SupineProne */
SupineProne_EXPORT Eigen::Vector2d
                   MapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & sourceUv);

/** The other way; not numbers where the map is no bijection there. \ingroup SupineProne */
SupineProne_EXPORT Eigen::Vector2d
                   InverseMapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & targetUv);

/** Confidence at a place of the source, 0 to 1. \ingroup SupineProne */
SupineProne_EXPORT double
ConfidenceAt(const SupineProneRegistration & registration, const CylinderPlace & place);

/** Whether a place of the source, or the one it goes to, is excluded. \ingroup SupineProne */
SupineProne_EXPORT bool
IsExcludedAt(const SupineProneRegistration & registration, const CylinderPlace & place);
} // namespace shapeton

#endif
