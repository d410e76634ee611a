#ifndef shapetonPolypCandidates_h
#define shapetonPolypCandidates_h

#include "shapetonCurveSet.h"
#include "shapetonIleocecalValve.h"
#include "shapetonPolypScore.h"
#include "shapetonProgress.h"
#include "shapetonWallBulges.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Default of PolypCandidateOptions::sensitivity. \ingroup ShapetonPolypCandidates */
constexpr double defaultPolypSensitivity = 0.75;

/** Method that finds candidates. \ingroup ShapetonPolypCandidates */
enum class PolypPreset
{
  /** Bulges of the wall, distinguished from folds by their shape. */
  Default,
  /** Parts of the wall visited most often by shapetons (dissertation 3.5.2): 65,000 shapetons, distance 0.005, p = 15,
   * 4,000 steps. */
  Published
};

/** "default", "published". \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                       NameOf(PolypPreset preset);

/** Size classes for reports: the largest diameter, rounded to whole millimeters.
 * \ingroup ShapetonPolypCandidates */
enum class PolypSize
{
  AtMost5,  ///< mm
  From6To9, ///< mm
  From10,   ///< 10 to 29 mm
  From30    ///< mm
};

/** The category of a largest diameter in mm. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT PolypSize
SizeOf(double diameter);
/** "<= 5 mm", "6-9 mm", ">= 10 mm", ">= 30 mm". \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                       NameOf(PolypSize size);

/** Tissue of a candidate, from the HU inside it. \ingroup ShapetonPolypCandidates */
enum class PolypTissue
{
  Unknown,
  Gas,    ///< below -150 HU: too small, or partial volume with gas
  Fat,    ///< -150 to -30 HU
  Soft,   ///< -30 to 150 HU
  Tagged, ///< above 150 HU: contains contrast medium, as stool does
};

/** The kind of tissue with this attenuation in HU. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT PolypTissue
TissueOf(double hounsfield);
/** "unknown", "gas", "fat", "soft tissue", "tagged". \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                       NameOf(PolypTissue tissue);

/** A candidate in the other position of the patient. \ingroup ShapetonPolypCandidates */
struct PolypInOtherPosition
{
  /** Corresponding point on the other wall by the registration, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** mm from there to the most similar candidate of the other position, or to the nearest if none is similar; infinite
   * without candidates. */
  double distance{ std::numeric_limits<double>::infinity() };
  /** Number of that candidate; 0 for none. */
  int candidate{ 0 };
  /** Whether a similar candidate is there: likeness of at least 0.1. */
  bool isSeen{ false };
  /** Whether the place is collapsed, bridged or not imaged in one of the positions, so nothing can be concluded. */
  bool isExcluded{ false };
  /** Local confidence of the registration, 0 to 1. */
  double confidence{ 0.0 };
  /** Similarity of the other position to the candidate at that place, 0 to 1: the greatest score of a candidate there,
   * reduced with its distance (standard deviation 8 mm) and with the ratio of the widths (a factor of e^0.5). */
  double likeness{ 0.0 };
  /** PolypCandidate::score before WeighByOtherPosition(); NaN if it was not called. */
  double ownScore{ std::numeric_limits<double>::quiet_NaN() };
};

/** A candidate of the other position, see FindInOtherPosition(). \ingroup ShapetonPolypCandidates */
struct OtherPolypCandidate
{
  int number{ 0 };
  /** Position, LPS, mm. */
  Eigen::Vector3d position{ Eigen::Vector3d::Zero() };
  /** Diameter, mm; NaN if unknown. */
  double diameter{ std::numeric_limits<double>::quiet_NaN() };
  /** Score from its own position only, 0 to 1. */
  double score{ 1.0 };
};

/** A place of the wall that resembles a polyp. For research use; a candidate is not a finding. \ingroup ShapetonPolypCandidates
 */
struct PolypCandidate
{
  /** Rank from 1, by descending score in its own position. */
  int number{ 0 };
  /** 0 to 1: the shape score times the TissueLikelihood() of the head, if known; see WeighByOtherPosition(). */
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
  /** Largest and smallest width of the head across its axis, mm. A head lower than about half its width merges into the
   * wall before its widest place: up to 0.9 mm are added for the rim. */
  double diameter{ 0.0 };
  double leastDiameter{ 0.0 };
  /** Height above a ring 1 to 2 mm around it, mm; for a head on a stalk, only the head. On a concave wall the ring is
   * higher than the base: a head of 6 mm on a tube of radius 20 mm has 4.2 mm. */
  double        height{ 0.0 };
  PolypFeatures features;
  /** mm along the centerline from the anal verge; NaN if the wall has no arcLength. */
  double arcLength{ std::numeric_limits<double>::quiet_NaN() };
  /** Segment, 1 rectum to 6 cecum; 0 unknown. */
  int segment{ 0 };
  /** mm of the flat map; NaN without one. */
  Eigen::Vector2d uv{ Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()) };
  /** Median HU inside; NaN without a CT. */
  double      attenuation{ std::numeric_limits<double>::quiet_NaN() };
  PolypTissue tissue{ PolypTissue::Unknown };
  /** Share of the head covered by tagged fluid, 0 to 1; NaN without a CT. */
  double submergedShare{ std::numeric_limits<double>::quiet_NaN() };
  /** See RankValveLast(). */
  bool isAtValve{ false };
  /** Hint for the reader, for example "may be the ileocecal valve"; "" if none. */
  std::string                         remark;
  std::optional<PolypInOtherPosition> other;
};

/** Options of FindPolypCandidates(). \ingroup ShapetonPolypCandidates */
struct PolypCandidateOptions
{
  /** 0 to 1: keeps candidates with a shape score of at least 1 - sensitivity. */
  double sensitivity{ defaultPolypSensitivity };
  /** Time of the normal diffusion on a wall from voxels of 0.8 mm, mm^2. For other walls it is adapted so that the
   * total blur of voxels and diffusion is the same, see MatchedSmoothingTime(). */
  double smoothingTime{ 1.0 };
  /** Minimum of the smaller principal curvature everywhere on a head, 1/mm. */
  double leastCurvature{ 0.01 };
  /** Minimum diameter, mm, from 0. Smaller heads cannot be distinguished from segmentation residue. */
  double leastDiameter{ 3.5 };
  /** May throw to abort. */
  Progress progress;
};

/** Adapts a diffusion time in mm^2 to a wall: `time` for voxels of 0.8 mm, reduced by half a mm^2 for each mm^2 by
 * which the faces of its voxels are larger, at least 0.3 mm^2. The voxel size is estimated from the mean face area of
 * the wall: marching cubes gives a third of a voxel face. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
MatchedSmoothingTime(const SurfaceMesh & wall, double time);

/** Finds candidates on a wall, by descending score.
 *
 * 1. Principal curvatures from diffused normals (SurfaceShape).
 * 2. Bulges: connected parts where both are positive. The crest of a fold is curved only across, so a polyp on
 *    a fold is a separate part.
 * 3. Score by PolypScore() from shape index, roundness, hollowness of the foot and curvedness.
 * 4. Of overlapping bulges, the one with the highest score is kept.
 *
 * \param wall at full resolution, faces counterclockwise from outside the lumen; point array arcLength and cell array
 * bridged are optional. Bridges and parts within 3 mm of a rim are left out.
 * Throws ParameterError for a sensitivity out of [0, 1], and the InputError of MakeSurfaceLaplacian(). The result is
 * identical for any number of threads. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypCandidate>
                       FindPolypCandidates(const SurfaceMesh & wall, const PolypCandidateOptions & options = {});

/** Marks the candidate that may be the ileocecal valve if no valve is known: the largest of at least 15 mm, 30 to 100
 * mm before the end of the centerline. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
NoteIleocecalValve(double lengthOfCenterline, std::vector<PolypCandidate> & candidates);

/** Gives candidates at the valve the remark "the ileocecal valve" and ranks them last among those listed at the
 * default sensitivity, with scores of at most 1 - defaultPolypSensitivity. Domes and caps (shape index above 13/16)
 * keep this score for any valve confidence, so a large polyp mistaken for the valve is not lost. The scores of ridges,
 * such as the lips of a valve, are multiplied by the probability that they are not the valve. At the valve means within
 * half its length and 3 mm of its center, at least 12 mm. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
RankValveLast(const IleocecalValve & valve, std::vector<PolypCandidate> & candidates);

/** Marks candidates within 60 mm of the anal verge, along the centerline: the tip of a rectal catheter, its balloon and
 * hemorrhoids are found there, and have the shape of polyps. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
NoteRectalCatheter(std::vector<PolypCandidate> & candidates);

/** Ranks the remains of a rectal catheter last, with a score of 0 and the remark "the rectal catheter" or "the balloon
 * of the rectal catheter": candidates with their center inside or within 3 mm of its surface. \param catheter its axis,
 * one point per mm, with the point array radius in mm and, for a possible balloon, balloonRadius, 0 outside the
 * balloon. Throws InputError when radius is missing. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
RankCatheterLast(const CurveSet & catheter, std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
