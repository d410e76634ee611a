#ifndef shapetonSupineProneRegistration_h
#define shapetonSupineProneRegistration_h

#include "shapetonRemarks.h"
#include "shapetonColonPosition.h"
#include "shapetonCylinderMap.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"
#include "shapetonSupineProneOptions.h"

namespace shapeton
{
/** Settings of RegisterColonPositions(). `refine`, `segmentWise` and `matching` apply to the default
 * map only, `distanceWeight` and `border` to the published one.
 * \ingroup ShapetonSupineProne */
struct SupineProneSettings : SupineProneOptions
{
  /** May throw to abort. */
  Progress progress;
};

/** A feature that is matched: a fold, or one of its ends. \ingroup ShapetonSupineProne */
struct FoldLandmark
{
  /** Index into ColonPosition::folds. */
  int fold{ 0 };
  /** 0 or 1; -1: the whole fold, located at its center. */
  int end{ -1 };

  const Eigen::Vector2d &
  Uv(const std::vector<HaustralFold> & folds) const
  {
    return end < 0 ? folds[fold].centerUv : folds[fold].endUv[end];
  }
  const Eigen::Vector3d &
  Point(const std::vector<HaustralFold> & folds) const
  {
    return end < 0 ? folds[fold].center : folds[fold].ends[end];
  }
};

/** A matched pair of folds, or of ends of folds. \ingroup ShapetonSupineProne */
struct FoldMatch
{
  FoldLandmark source;
  FoldLandmark target;
  double       cost{ 0.0 };
  /** Distance (mm) between the source landmark under the final map and the target landmark. */
  double residual{ 0.0 };
  /** Final weight of the pair in the map, 0 to 1; below 0.5 the pair contradicts its neighbors. */
  double weight{ 0.0 };
  /** Segment number: 0 before the first flexure found in both positions, 1 after it, ... */
  int segment{ 0 };
};

/** The local confidence is the probability that a mapped point is within this distance (mm) of the true one. It is less
 * than half the distance between folds. \ingroup ShapetonSupineProne */
constexpr double ConfidentDistance = 10.0;

/** Confidence of the registration. \ingroup ShapetonSupineProne */
struct RegistrationConfidence
{
  /** 0 to 1; below 0.5 the registration is flagged. */
  double whole{ 0.0 };
  bool   isFlagged{ true };
  /** Reasons for the flag. */
  std::vector<std::string> reasons;
  /** Number of consistent pairs relative to the number of folds in the position that has fewer folds. */
  double matchedShare{ 0.0 };
  /** Fraction of inconsistent pairs. */
  double contradictedShare{ 0.0 };
  /** Minimum mean cost of a row near the warp; about 0 or below if folds agree. */
  double energy{ 0.0 };
  /** `energy`, then the energies near the warp rotated by one third and by two thirds of a turn; they reveal confused
   * taeniae. */
  std::vector<double> energies;
  /** Minimum energy of the rotated warps minus the energy of the warp. */
  double margin{ 0.0 };
  /** Energy of the best of the three other orientations of the picture (mirrored, reversed, both) minus the energy of
   * the correct one; landmarks are not used. About 0 for two patients. */
  double senseMargin{ 0.0 };
  /** Root mean square residual of the consistent pairs, mm. */
  double residual{ 0.0 };
  /** Local confidence of each node of the map: the probability that its image is within ConfidentDistance of the true
   * one if both positions are of one patient; 0 where the wall is not visible. It is the product of two probabilities:
   * that the row is not mapped onto a neighboring fold along the colon or around it, from a hidden Markov model of the
   * displacement along the colon, and that the error is otherwise small, from the residuals of nearby folds and the
   * radius. */
  Eigen::MatrixXd ofNodes;

  /** Probability that both positions are of the same patient. The log-odds are the sum of terms of matchedShare,
   * energy, margin and senseMargin. Each term is at most 4, and the sum is limited to the term of senseMargin, since a
   * few folds may be similar in two patients. Each term is 0 halfway between the values measured for one patient and
   * those for two, so that folds visible in only one position do not outweigh a picture that fits in only one
   * orientation. */
  ShapetonSupineProne_EXPORT double
  ProbabilityOfOnePatient() const;
};

/** Which taeniae of both positions are the same band. \ingroup ShapetonSupineProne */
struct CommonTaeniae
{
  /** For each curve of ColonPosition::taeniae of the source, the index of that of the target; -1 if unknown. */
  std::array<int, 3> target{ { -1, -1, -1 } };
  /** Expected fraction of the colon visible in both positions along which these pairs are the same band, 0 to 1. The
   * pairs are unknown below 0.5. */
  double probability{ 0.0 };

  bool
  AreKnown() const
  {
    return target[0] >= 0;
  }
};

/** Measurements during registration. \ingroup ShapetonSupineProne */
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
  /** Initial map from flexures and taeniae, for comparison. */
  CylinderMap frame;
  /** The map from warping, before fold matching. */
  CylinderMap            warp;
  std::vector<FoldMatch> matches;
  /** Its pairs are indices into the landmarks. */
  FoldMatching matching;
  /** What can be matched: all folds, or for the published map the ends near the main taenia. */
  std::vector<FoldLandmark> sourceLandmarks;
  std::vector<FoldLandmark> targetLandmarks;
  RegistrationConfidence    confidence;
  CommonTaeniae             taeniae;
  RegistrationFigures       figures;
  /** Distances of the flexures used along source and target, mm. */
  std::vector<std::pair<double, double>> flexures;
  /** Whether the wall at each node is not visible in one of the positions. */
  Eigen::Matrix<char, Eigen::Dynamic, Eigen::Dynamic> isExcluded;
  Remarks                                             warnings;
};

/** Computes a one-to-one map between the walls of a colon in two positions.
 *
 * 1. Compute the frame: distance along the centerline, piecewise linear between flexures; rotation by the three
 *    taeniae.
 * 2. Apply cylindrical dynamic time warping, free in rotation, to pictures of folds and taeniae about several frames.
 *    Choose the warp with the most fold pairs that are consistent with a smooth map.
 * 3. Match folds under the warp (MatchFolds()), and twice under the corrected warp.
 * 4. Correct the warp by a thin plate, robust to wrong pairs, through the centers and ends of matched folds.
 * 5. Project the map to a bijection without flipped triangles.
 *
 * SupineProneMap::Published replaces steps 3 to 5.
 *
 * In excluded stretches, the map is interpolated from both sides and flagged. The result does not depend on the number
 * of threads. Throws InputError if a position has no folds, has neither flexures nor taeniae, or appears reversed or
 * mirrored. Source: dissertation 4.3; warping after Nain et al. 2002. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT SupineProneRegistration
RegisterColonPositions(const ColonPosition &       source,
                       const ColonPosition &       target,
                       const SupineProneSettings & options = {});

/** Maps a position on the flat map, mm. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT Eigen::Vector2d
                           MapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & sourceUv);

/** Inverse of MapUv(); NaN where undefined. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT Eigen::Vector2d
                           InverseMapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & targetUv);

/** Confidence at a source position, 0 to 1. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT double
ConfidenceAt(const SupineProneRegistration & registration, const CylinderPlace & place);

/** Whether a source position or its image is excluded. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT bool
IsExcludedAt(const SupineProneRegistration & registration, const CylinderPlace & place);
} // namespace shapeton

#endif
