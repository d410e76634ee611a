#ifndef shapetonPolypCandidates_h
#define shapetonPolypCandidates_h

#include "shapetonCurveSet.h"
#include "shapetonIleocecalValve.h"
#include "shapetonPolypScore.h"
#include "shapetonPolypSensitivityOptions.h"
#include "shapetonProgress.h"
#include "shapetonWallBulges.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Default of the option sensitivity. \ingroup ShapetonPolypCandidates */
constexpr double defaultPolypSensitivity = PolypSensitivityOptions().sensitivity;

/** Method that finds candidates. \ingroup ShapetonPolypCandidates */
enum class PolypPreset
{
  /** Bulges of the wall that differ from folds in shape. */
  Default,
  /** Parts of the wall least visited by shapetons (dissertation 3.5.2): 65,000 shapetons, distance 0.005, p = 15, 4,000
   * steps. */
  Published
};

/** "default", "published". \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                               NameOf(PolypPreset preset);

/** \name Size of a polyp
 * The size in tables, pages, counts and DICOM objects is the largest diameter, rounded to 0.1 mm, and the class follows
 * from this number: limits are 6, 10 and 30 mm.
 * \ingroup ShapetonPolypCandidates */
///@{
enum class PolypSize
{
  Below6,
  From6To9, ///< below 10 mm
  From10,   ///< below 30 mm
  From30
};

/** A diameter in mm, rounded to 0.1 mm. */
ShapetonPolypCandidates_EXPORT double
StatedSize(double diameter);
/** The class of StatedSize(). */
ShapetonPolypCandidates_EXPORT PolypSize
SizeOf(double diameter);
/** StatedSize() as "9.6 mm"; empty for NaN. */
ShapetonPolypCandidates_EXPORT std::string
                               SizeInWords(double diameter);
///@}

/** "< 6 mm", "6-9 mm", ">= 10 mm", ">= 30 mm". \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                               NameOf(PolypSize size);

/** Tissue of a candidate, determined from the HU inside it. \ingroup ShapetonPolypCandidates */
enum class PolypTissue
{
  Unknown, ///< no CT, or soft tissue or fat so thin that partial volume decides
  Gas,     ///< below -150 HU: gas, or partial volume of a small candidate
  Fat,     ///< -150 to -30 HU
  Soft,    ///< -30 to 150 HU
  Tagged,  ///< above 150 HU: contains contrast medium, like tagged stool
  WithGas  ///< fat or soft tissue by its median, but at least a twentieth is below -200 HU: pockets of gas, as in stool
};

/** The kind of tissue that has this attenuation in HU; never WithGas. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT PolypTissue
TissueOf(double hounsfield);
/** "unknown", "gas", "fat", "soft tissue", "tagged", "with gas inside". \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                               NameOf(PolypTissue tissue);

/** Form of a polyp. \ingroup ShapetonPolypCandidates */
enum class PolypMorphology
{
  Unknown,
  Sessile,
  Pedunculated,
  Flat
};

/** "sessile", "pedunculated", "flat"; empty if unknown. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                               NameOf(PolypMorphology morphology);

/** Structure, other than a polyp, that a candidate was recognized as. Reports list such candidates separately.
 * \ingroup ShapetonPolypCandidates */
enum class PolypLookalike
{
  None,
  Valve,
  AnalCanal,
  Catheter,
  Balloon,
  Gas,
  Residue, ///< of electronic cleansing: fluid that was not removed
  Tagged
};

/** "ileocecal valve", "anal canal", "rectal catheter", "balloon of the rectal catheter", "gas", "residue of electronic
 * cleansing", "tagged stool or residue"; empty for None. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                               NameOf(PolypLookalike lookalike);

/** Evidence for a candidate from the other position of the patient. \ingroup ShapetonPolypCandidates */
struct PolypInOtherPosition
{
  /** Corresponding point on the other wall according to the registration, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** Distance (mm) from that point to the most similar candidate of the other position, or to the nearest if none is
   * similar; infinity if there are no candidates. */
  double distance{ std::numeric_limits<double>::infinity() };
  /** Number of that candidate; 0 if there is none. */
  int candidate{ 0 };
  /** Whether a similar candidate (likeness of at least 0.1) was found. */
  bool isSeen{ false };
  /** Whether the wall at the point is collapsed, bridged or not imaged in one of the positions, or the confidence of
   * the map is below .3 there, so that no conclusion is possible. */
  bool isExcluded{ false };
  /** Local confidence of the registration, 0 to 1. */
  double confidence{ 0.0 };
  /** Similarity (0 to 1) of the best-matching candidate in the other position: the score of that candidate, weighted by
   * Gaussians of the distance (standard deviation 8 mm) and of the log ratio of the widths (0.5). */
  double likeness{ 0.0 };
  /** PolypCandidate::score before WeighByOtherPosition(); NaN if it was not called. */
  double ownScore{ std::numeric_limits<double>::quiet_NaN() };
};

/** A candidate from the other position, see FindInOtherPosition(). \ingroup ShapetonPolypCandidates */
struct OtherPolypCandidate
{
  int number{ 0 };
  /** Position, LPS, mm. */
  Eigen::Vector3d position{ Eigen::Vector3d::Zero() };
  /** Diameter, mm; NaN if unknown. */
  double diameter{ std::numeric_limits<double>::quiet_NaN() };
  /** Score from that position only, 0 to 1. */
  double score{ 1.0 };
};

/** A part of the wall that resembles a polyp. For research use; a candidate is not a finding.
 * \ingroup ShapetonPolypCandidates
 */
struct PolypCandidate
{
  /** Rank by descending score in this position, from 1. */
  int number{ 0 };
  /** Shape score (0 to 1) times the TissueLikelihood() of the head, if known; see WeighByOtherPosition(). */
  double score{ 0.0 };
  /** Score of the shape only, 0 to 1. */
  double shapeScore{ 0.0 };
  /** Center of the surface of the head, LPS, mm. */
  Eigen::Vector3d position{ Eigen::Vector3d::Zero() };
  /** Most prominent point, LPS, mm. */
  Eigen::Vector3d apex{ Eigen::Vector3d::Zero() };
  /** Unit vector from the wall into the lumen. */
  Eigen::Vector3d axis{ Eigen::Vector3d::UnitZ() };
  /** Vertices of the head on the wall. */
  std::vector<int> vertices;
  /** Largest and smallest width (mm) of the head perpendicular to its axis. Up to 0.9 mm is added for heads lower than
   * about half their width, since these merge into the wall before they reach their maximum width. */
  double diameter{ 0.0 };
  double leastDiameter{ 0.0 };
  /** Height (mm) above a ring 1 to 2 mm around the head, excluding the stalk. On a concave wall the ring is higher than
   * the base: the height is 4.2 mm for a head 6 mm high on a tube with a radius of 20 mm. */
  double        height{ 0.0 };
  PolypFeatures features;
  /** mm along the centerline from the anal verge; NaN if the wall lacks arcLength. */
  double arcLength{ std::numeric_limits<double>::quiet_NaN() };
  /** Segment, from 1 (rectum) to 6 (cecum); 0 if unknown. */
  int segment{ 0 };
  /** Position on the flat map, mm; NaN if there is no map. */
  Eigen::Vector2d uv{ Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()) };
  /** Median HU inside; NaN if there is no CT. */
  double      attenuation{ std::numeric_limits<double>::quiet_NaN() };
  PolypTissue tissue{ PolypTissue::Unknown };
  /** Mean, and 5 % and 95 % quantiles, of the HU values used for `attenuation`; NaN if there is no CT. */
  double meanAttenuation{ std::numeric_limits<double>::quiet_NaN() };
  double lowAttenuation{ std::numeric_limits<double>::quiet_NaN() };
  double highAttenuation{ std::numeric_limits<double>::quiet_NaN() };
  /** Mean HU of the same part in the CT before cleansing; NaN if unknown. */
  double uncleansedAttenuation{ std::numeric_limits<double>::quiet_NaN() };
  /** Fraction of the head covered by tagged fluid, 0 to 1; NaN if there is no CT. */
  double submergedShare{ std::numeric_limits<double>::quiet_NaN() };
  /** Fraction (0 to 1) of the surface of the head that is coated with contrast medium: at least 250 HU within 1 mm
   * above or 1.5 mm below it, and more than 3 mm from fluid. NaN if there is no CT. */
  double filmShare{ std::numeric_limits<double>::quiet_NaN() };
  /** See MeasureMorphology(). */
  PolypMorphology morphology{ PolypMorphology::Unknown };
  bool            isOnFold{ false };
  /** Largest diameter (mm) of the head in cuts through its center along the planes of the patient, and the plane of
   * that cut: "axial", "coronal" or "sagittal"; NaN and empty if not measured. */
  double      planeDiameter{ std::numeric_limits<double>::quiet_NaN() };
  std::string plane;
  /** Number of the candidate of which this is a fragment, see JoinFragments(); its own number otherwise, 0 if unknown.
   */
  int            mainCandidate{ 0 };
  PolypLookalike lookalike{ PolypLookalike::None };
  /** Remark for the reader, for example "may be the ileocecal valve", or empty. */
  std::string                         remark;
  std::optional<PolypInOtherPosition> other;
};

/** Options of FindPolypCandidates(). \ingroup ShapetonPolypCandidates */
struct PolypCandidateOptions : PolypSensitivityOptions
{
  /** Time (mm^2) for diffusing the normals of a wall made from 0.8 mm voxels. For other walls, it is adapted so that
   * the total blur due to voxels and diffusion is the same, see MatchedSmoothingTime(). */
  double smoothingTime{ 1.0 };
  /** Lower bound of the smaller principal curvature on a head, 1/mm. */
  double leastCurvature{ 0.01 };
  /** Minimum diameter, mm; at least 0. Smaller heads cannot be distinguished from segmentation residue. */
  double leastDiameter{ 3.5 };
  /** May throw to abort. */
  Progress progress;
};

/** Adapts a diffusion time (mm^2) chosen for 0.8 mm voxels to a wall: the time is reduced by half the difference in
 * voxel face area (mm^2), to at least 0.3 mm^2. The voxel face area is estimated as three times the mean face area of
 * the wall, the ratio that results from marching cubes. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
MatchedSmoothingTime(const SurfaceMesh & wall, double time);

/** Finds candidates on a wall, in order of descending score.
 *
 * 1. Principal curvatures from diffused normals (SurfaceShape).
 * 2. Bulges: connected parts where both are positive. The crest of a fold is curved in one direction only, so a polyp
 *    on a fold is a separate part. Plaques (FindWallPlaques()) at least 8 mm wide are added to find flat polyps.
 * 3. PolypScore() from shape index, roundness, hollowness of the foot and curvedness.
 * 4. Non-maximum suppression of overlapping bulges.
 *
 * \param wall at full resolution, with faces counterclockwise as seen from outside the lumen; the point array arcLength
 * and the cell array bridged are optional. Bridges and parts within 3 mm of a rim are excluded. Throws ParameterError
 * for a sensitivity outside [0, 1], and the InputError of MakeSurfaceLaplacian(). The result does not depend on the
 * number of threads.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypCandidate>
FindPolypCandidates(const SurfaceMesh & wall, const PolypCandidateOptions & options = {});

/** Remark of candidates that may be the valve. \ingroup ShapetonPolypCandidates */
constexpr const char * MayBeTheValve = "may be the ileocecal valve";

/** Adds the remark MayBeTheValve with its probability to candidates at a place that is the valve with a
 * probability of at least .05, see ValveSearch::candidates and RankValveLast(), unless they are at the decided valve.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
NoteIleocecalValve(const std::vector<IleocecalValve> & alternatives, std::vector<PolypCandidate> & candidates);

/** Adds the remark "the ileocecal valve" to candidates at the valve and ranks them last among those listed at the
 * default sensitivity, with scores of at most 1 - defaultPolypSensitivity. The scores of domes and caps (shape index
 * above 13/16) do not depend on the valve confidence, so that large polyps mistaken for the valve are preserved. The
 * scores of ridges, such as the lips of a valve, are multiplied by the probability that they are not the valve. A
 * candidate is at the valve if its distance from the valve center is at most half the valve length + 3 mm, or 12 mm if
 * that is greater.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
RankValveLast(const IleocecalValve & valve, std::vector<PolypCandidate> & candidates);

/** Recognizes candidates in the anal canal, see EndOfAnalCanal(); other candidates within 60 mm of the anal verge along
 * the centerline get a remark, since these may be a catheter tip, a balloon or hemorrhoids. Scores are unchanged.
 * \param centerline with arcLength and radius. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
NoteAnalCanal(const CurveSet & centerline, std::vector<PolypCandidate> & candidates);

/** Adds a remark to candidates whose diameter is smaller than the resolution supports, see NotAssessableBelow().
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
NoteSmallerThan(double notAssessableBelow, std::vector<PolypCandidate> & candidates);

/** Ranks candidates centered inside or within 3 mm of a rectal catheter last, with a score of 0 and the remark "the
 * rectal catheter" or "the balloon of the rectal catheter". \param catheter its axis, one point per mm, with the point
 * array radius (mm) and optionally balloonRadius (mm, 0 outside the balloon). Throws InputError if radius is missing.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
RankCatheterLast(const CurveSet & catheter, std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
