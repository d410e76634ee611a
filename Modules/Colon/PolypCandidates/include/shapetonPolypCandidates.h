#ifndef shapetonPolypCandidates_h
#define shapetonPolypCandidates_h

#include "shapetonCurveSet.h"
#include "shapetonIleocaecalValve.h"
#include "shapetonPolypScore.h"
#include "shapetonProgress.h"
#include "shapetonWallBulges.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** See PolypCandidateOptions. \ingroup PolypCandidates */
constexpr double defaultPolypSensitivity = 0.75;

/** How candidates are found. \ingroup PolypCandidates */
enum class PolypPreset
{
  /** Bulges of the wall, told from folds by their shape. */
  Default,
  /** Where shapetons have been more often than elsewhere (dissertation 3.5.2): 65,000 shapetons, distance 0.005, p =
   * 15, 4,000 steps. */
  Published
};

/** "default", "published". \ingroup PolypCandidates */
PolypCandidates_EXPORT std::string
                       NameOf(PolypPreset preset);

/** The classes by which candidates are reported: by the largest diameter in whole millimetres, rounded.
 * \ingroup PolypCandidates */
enum class PolypSize
{
  AtMost5,  ///< mm
  From6To9, ///< mm
  From10,   ///< 10 to 29 mm
  From30    ///< mm
};

/** The category of a largest diameter in mm. \ingroup PolypCandidates */
PolypCandidates_EXPORT PolypSize
SizeOf(double diameter);
/** "<= 5 mm", "6-9 mm", ">= 10 mm", ">= 30 mm". \ingroup PolypCandidates */
PolypCandidates_EXPORT std::string
                       NameOf(PolypSize size);

/** What a candidate is made of, by the HU inside of it. \ingroup PolypCandidates */
enum class PolypTissue
{
  Unknown,
  Gas,    ///< below -150 HU: too small, or mixed with gas
  Fat,    ///< -150 to -30 HU
  Soft,   ///< -30 to 150 HU
  Tagged, ///< above 150 HU: holds contrast medium, as stool does
};

/** The kind of tissue of an attenuation in HU. \ingroup PolypCandidates */
PolypCandidates_EXPORT PolypTissue
TissueOf(double hounsfield);
/** "unknown", "gas", "fat", "soft tissue", "tagged". \ingroup PolypCandidates */
PolypCandidates_EXPORT std::string
                       NameOf(PolypTissue tissue);

/** Where a candidate lies in the other position of the patient. \ingroup PolypCandidates */
struct PolypInOtherPosition
{
  /** The place on the other wall that the registration takes the candidate to, LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** mm from there to the candidate of the other position that is most alike, or to the nearest where none is; infinite
   * without candidates. */
  double distance{ std::numeric_limits<double>::infinity() };
  /** The number of that candidate; 0 for none. */
  int candidate{ 0 };
  /** A candidate there is alike: likeness of at least 0.1. */
  bool isSeen{ false };
  /** The place is collapsed, bridged or not imaged in one of the positions: nothing can be said. */
  bool isExcluded{ false };
  /** Of the registration there, 0 to 1. */
  double confidence{ 0.0 };
  /** How much what is seen at that place is the candidate, 0 to 1: the greatest score of a candidate there, less the
   * farther off it lies (standard deviation 8 mm) and the more its width differs (a factor of e^0.5). */
  double likeness{ 0.0 };
  /** PolypCandidate::score before WeighByOtherPosition(); not a number where that was not done. */
  double ownScore{ std::numeric_limits<double>::quiet_NaN() };
};

/** A candidate of the other position, see FindInOtherPosition(). \ingroup PolypCandidates */
struct OtherPolypCandidate
{
  int number{ 0 };
  /** LPS, mm. */
  Eigen::Vector3d position{ Eigen::Vector3d::Zero() };
  /** mm; not a number where it is not known. */
  double diameter{ std::numeric_limits<double>::quiet_NaN() };
  /** By its own position alone, 0 to 1. */
  double score{ 1.0 };
};

/** A place of the wall that looks like a polyp. For research use; a candidate is no finding. \ingroup PolypCandidates
 */
struct PolypCandidate
{
  /** From 1, by falling score of its position alone. */
  int number{ 0 };
  /** 0 to 1: that of the shape, times the TissueLikelihood() of what the head is made of, where that is known; see
   * WeighByOtherPosition(). */
  double score{ 0.0 };
  /** Of the shape alone, 0 to 1. */
  double shapeScore{ 0.0 };
  /** The head: the middle of its surface, LPS, mm. */
  Eigen::Vector3d position{ Eigen::Vector3d::Zero() };
  /** Where it stands out farthest, LPS, mm. */
  Eigen::Vector3d apex{ Eigen::Vector3d::Zero() };
  /** From the wall into the lumen; a unit vector. */
  Eigen::Vector3d axis{ Eigen::Vector3d::UnitZ() };
  /** Vertices of the wall that the head is made of. */
  std::vector<int> vertices;
  /** The largest and the smallest width of the head across its axis, mm. A head that is lower than about half of its
   * width goes over into the wall before its widest place is reached: up to 0.9 mm are added for the rim. */
  double diameter{ 0.0 };
  double leastDiameter{ 0.0 };
  /** How far it stands above a ring 1 to 2 mm around it, mm; of a head on a stalk, the head alone. On a hollow wall the
   * ring is higher than the base: a head of 6 mm on a tube of radius 20 mm has 4.2 mm. */
  double        height{ 0.0 };
  PolypFeatures features;
  /** mm along the centreline from the anal verge; not a number where the wall does not tell. */
  double arcLength{ std::numeric_limits<double>::quiet_NaN() };
  /** 1 rectum to 6 caecum; 0 unknown. */
  int segment{ 0 };
  /** mm of the flat map; not numbers where there is none. */
  Eigen::Vector2d uv{ Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()) };
  /** Median HU inside; not a number without a CT. */
  double      attenuation{ std::numeric_limits<double>::quiet_NaN() };
  PolypTissue tissue{ PolypTissue::Unknown };
  /** Share of the head before which tagged fluid lies, 0 to 1; not a number without a CT. */
  double submergedShare{ std::numeric_limits<double>::quiet_NaN() };
  /** See RankValveLast(). */
  bool isAtValve{ false };
  /** What a reader should think of, for example "may be the ileocaecal valve"; "" for nothing. */
  std::string                         remark;
  std::optional<PolypInOtherPosition> other;
};

/** Sensitivity and least sizes for FindPolypCandidates(). \ingroup PolypCandidates */
struct PolypCandidateOptions
{
  /** 0 to 1: candidates with a score of the shape of at least 1 - sensitivity. */
  double sensitivity{ defaultPolypSensitivity };
  /** Of the diffusion of normals on a wall from voxels of 0.8 mm, mm^2. Other walls get the time that makes the blur of
   * voxels and diffusion together the same, see MatchedSmoothingTime(). */
  double smoothingTime{ 1.0 };
  /** What the lesser principal curvature of a head is at least, everywhere, 1/mm. */
  double leastCurvature{ 0.01 };
  /** Of a candidate, mm, from 0. Smaller heads cannot be told from crumbs that the segmentation of a CT leaves. */
  double leastDiameter{ 3.5 };
  /** It may throw in order to abort. */
  Progress progress;
};

/** A time of diffusion in mm^2 that suits a wall: `time` where it stems from voxels of 0.8 mm, less by half a mm^2 for
 * each mm^2 that the faces of its voxels are larger, at least 0.3 mm^2. Voxels are told from the mean area of the faces
 * of the wall, a third of that of a voxel in marching cubes. \ingroup PolypCandidates */
PolypCandidates_EXPORT double
MatchedSmoothingTime(const SurfaceMesh & wall, double time);

/** Candidates on a wall, by falling score.
 *
 * 1. Principal curvatures by diffused normals (SurfaceShape).
 * 2. Bulges: connected parts where both are positive. A fold's crest is curved across alone, so a polyp on
 *    a fold is a part of its own.
 * 3. Score by PolypScore() from shape index, roundness, hollowness of the foot and curvedness.
 * 4. Of bulges that overlap the one with the higher score.
 *
 * \param wall of full resolution, faces counterclockwise from outside of the lumen; point array arcLength and cell
 * array bridged are used where they are there. Bridges, and what lies within 3 mm of a rim, are left out.
 * Throws ParameterError for a sensitivity out of [0, 1], InputError as MakeSurfaceLaplacian(). The same bytes for any
 * number of threads. \ingroup PolypCandidates */
PolypCandidates_EXPORT std::vector<PolypCandidate>
                       FindPolypCandidates(const SurfaceMesh & wall, const PolypCandidateOptions & options = {});

/** Where no valve is known: notes the candidate that may be the ileocaecal valve: the largest of at least 15 mm that
 * lies 30 to 100 mm before the end of the centreline. \ingroup PolypCandidates */
PolypCandidates_EXPORT void
NoteIleocaecalValve(double lengthOfCentreline, std::vector<PolypCandidate> & candidates);

/** Gives candidates at the valve the remark "the ileocaecal valve" and ranks them last of those that are listed at the
 * default sensitivity: their scores become 1 - defaultPolypSensitivity at most. Domes and caps (shape index above
 * 13/16) keep that whatever the confidence of the valve, so that a large polyp that is taken for the valve is not lost;
 * the scores of ridges, which the lips of a valve are, are multiplied by the probability that it is not the valve. At
 * the valve: within half of its length and 3 mm of its middle, 12 mm at least. \ingroup PolypCandidates */
PolypCandidates_EXPORT void
RankValveLast(const IleocaecalValve & valve, std::vector<PolypCandidate> & candidates);

/** Notes candidates within 60 mm of the anal verge, along the centreline: the tip of a rectal catheter, its balloon and
 * haemorrhoids lie there, and have the shape of polyps. \ingroup PolypCandidates */
PolypCandidates_EXPORT void
NoteRectalCatheter(std::vector<PolypCandidate> & candidates);

/** Puts candidates that are what is left of a rectal catheter behind all others, with a score of 0 and the remark "the
 * rectal catheter" or "the balloon of the rectal catheter": those with their middle within 3 mm of its surface, or
 * inside. \param catheter its axis, a point each mm, with the point array radius in mm and, where there may be a
 * balloon, balloonRadius, 0 where none is around the axis. Throws InputError where radius is missing.
 * \ingroup PolypCandidates */
PolypCandidates_EXPORT void
RankCatheterLast(const CurveSet & catheter, std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
