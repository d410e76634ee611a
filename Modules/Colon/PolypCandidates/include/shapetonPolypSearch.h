#ifndef shapetonPolypSearch_h
#define shapetonPolypSearch_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonPolypSearchOptions.h"
#include "shapetonPolypShapeDiffusion.h"

#include "shapetonCsvTable.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"
#include "shapetonSlicerMarkups.h"

#include <memory>

namespace shapeton
{
/** Data of a colon in one position; only the wall and the lumen are required. \ingroup ShapetonPolypCandidates */
struct PolypColon
{
  /** Wall at full resolution, without handles. */
  SurfaceMesh wall;
  /** One curve with the point array arcLength (mm); may be empty. */
  CurveSet centerline;
  /** Axis of a rectal catheter for RankCatheterLast(); may be empty. */
  CurveSet                 catheter;
  PolypLumenImage::Pointer lumen;
  /** Cleansed CT, HU; null for a mask. */
  itk::Image<float, 3>::Pointer ct;
  /** The CT itself, HU, on the same grid; null if not available. */
  itk::Image<float, 3>::Pointer original;
  /** Null if not available. */
  std::shared_ptr<const FlatColon> flat;
  /** Haustral folds on the flat map; null if not available. */
  itk::Image<unsigned short, 2>::Pointer folds;
  /** Surface with the cell array segment; may be empty. */
  SurfaceMesh segments;
  /** Warnings about missing data and their consequences. */
  Remarks warnings;
  /** Identities of the files. */
  std::vector<std::pair<std::string, std::string>> facts;
};

/** Settings of SearchPolyps(). \ingroup ShapetonPolypCandidates */
struct PolypSearchSettings : PolypSearchOptions
{
  /** Called with the stage and the completed fraction, 0 to 1. */
  Progress progress;
};

/** Finds candidates and adds all available data: attenuation, shape diffusion, position on the flat map, segment and
 * remark. Throws the exceptions of the individual steps. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypCandidate>
                               SearchPolyps(const PolypColon & colon, const PolypSearchSettings & options = {});

/** Mean distance (mm) from points, or a thousand of them, to a wall; 0 if there are none. The walls of two positions
 * may coincide locally, so only the mean identifies the wall. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
MeanDistanceToWall(const SurfaceMesh & wall, const VertexMatrix & points);

/** Converts candidates for FindInOtherPosition(), with scores from their own position only.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<OtherPolypCandidate>
                               AsOthers(const std::vector<PolypCandidate> & candidates);

/** Maps candidates to the other position using a map from ColonRegistration: a flat surface with the point arrays
 * mapped (LPS, mm), excluded and confidence. Throws InputError, prefixed with `what`, if an array is missing or the
 * mean distance from the candidates to the surface exceeds 10 mm. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
FindInOtherPosition(const SurfaceMesh &                      map,
                    const std::string &                      what,
                    const std::vector<OtherPolypCandidate> & others,
                    std::vector<PolypCandidate> &            candidates);

/** Minimum confidence of a registration that is used as evidence about single candidates.
 * \ingroup ShapetonPolypCandidates */
constexpr double LeastRegistrationConfidence = 0.5;

/** Updates candidates after FindInOtherPosition() using the evidence from the other position: polyps are stationary,
 * most stool is mobile. The shape score is replaced by the probability of a polyp given its shape score, flatness and
 * likeness (logistic regression on phantoms, see Documentation/validation/colon-polyps.md); the tissue factor is
 * unchanged. The new score is blended with the old one, weighted by the confidence of the registration. The score is
 * unchanged at the valve and where the other position is not visible. Candidates are sorted by the new scores, keep
 * their numbers, and receive a remark if nothing similar is visible in the other position. \param confidence of the
 * registration, 0 to 1.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
WeighByOtherPosition(double confidence, std::vector<PolypCandidate> & candidates);

/** Whether reports list a candidate as a possible polyp: it is neither recognized as something else nor a fragment of
 * another candidate. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT bool
IsListedAsPolyp(const PolypCandidate & candidate);

/** Description of a candidate that is not listed as a possible polyp: "tagged stool or residue", "part of candidate 3";
 * empty for a possible polyp. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                               RecognizedAs(const PolypCandidate & candidate);

/** A possible polyp, seen in one or both positions. \ingroup ShapetonPolypCandidates */
struct PolypLesion
{
  /** "A", "B", ..., "Z", "AA", ... */
  std::string letter;
  /** Numbers of its candidates in the first and the second position; 0 if there is none. */
  int first{ 0 };
  int second{ 0 };
  /** The larger of their stated sizes, mm; see StatedSize(). */
  double size{ 0.0 };
  /** The larger of their scores. */
  double score{ 0.0 };
  /** Whether only one of its two candidates is listed as a possible polyp. */
  bool isDisputed{ false };
};

/** Whether two candidates of different positions are the same lesion: one of them was matched to the other by
 * FindInOtherPosition().
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT bool
AreSameLesion(const PolypCandidate & first, const PolypCandidate & second);

/** Lesions with a candidate that is listed as a possible polyp in at least one position. Those in the first position
 * come first, in its order, followed by those in the second position only. Each candidate belongs to at most one
 * lesion.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypLesion>
LesionsOfPositions(const std::vector<PolypCandidate> & first, const std::vector<PolypCandidate> & second);

/** "If confirmed: 2 of 10 mm and more (1 likely), 0 of 6 to 9 mm (0 likely)": counts the lesions of two positions, or
 * the possible polyps of one position, by PolypLesion::size; likely are those with a score of at least .5. Disputed
 * lesions are not counted. The C-RADS category (Zalis et al., Radiology 2005) is the reader's decision.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
SizesIfConfirmed(const std::vector<PolypCandidate> & first, const std::vector<PolypCandidate> & second = {});

/** The candidates with values rounded as in the table, so that a page generated from them agrees with a page generated
 * from the table. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypCandidate>
                               CandidatesAsWritten(std::vector<PolypCandidate> candidates);

/** One row per candidate; unknown values are empty. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT CsvTable
TableOfPolypCandidates(const std::vector<PolypCandidate> & candidates);

/** Reads candidates from a table; vertices, apex, axis and score features are not set. Throws InputError for an invalid
 * file. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypCandidate>
                               ReadPolypCandidates(const std::string & path);

/** Reads candidates for FindInOtherPosition(), with the scores of their position, from a table with the columns x, y, z
 * (LPS, mm); if there is no column `candidate`, they are numbered by row. Throws InputError for an invalid file.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<OtherPolypCandidate>
                               ReadOtherPolypCandidates(const std::string & path);

/** Points for 3D Slicer, labeled by number and diameter; empty if there are no candidates.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<Markup>
                               MarkupsOfPolypCandidates(const std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
