#ifndef shapetonPolypSearch_h
#define shapetonPolypSearch_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonPolypShapeDiffusion.h"

#include "shapetonCsvTable.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"
#include "shapetonSlicerMarkups.h"

#include <memory>

namespace shapeton
{
/** Data of a colon in one position; only wall and lumen are required. \ingroup ShapetonPolypCandidates */
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
  /** Null if not available. */
  std::shared_ptr<const FlatColon> flat;
  /** Surface with the cell array segment; may be empty. */
  SurfaceMesh segments;
  /** Missing data and the consequences. */
  Remarks warnings;
  /** Identities of the files. */
  std::vector<std::pair<std::string, std::string>> facts;
};

/** Reads a folder written by VirtualColonoscopy: segmentation/wall-repaired.vtp and lumen.nrrd, and, if present,
 * centerline.vtp, catheter.vtp, cleansed.nrrd, ../flattening/flat.vtp, ../landmarks/segments.vtp. Throws InputError
 * with the file name. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT PolypColon
ReadPolypColon(const std::string & folder);

/** Options of SearchPolyps(). \ingroup ShapetonPolypCandidates */
struct PolypSearchOptions
{
  PolypPreset preset{ PolypPreset::Default };
  /** 0 to 1: keeps candidates with a shape score of at least 1 - sensitivity. */
  double sensitivity{ defaultPolypSensitivity };
  /** Called with the stage and the completed fraction, 0 to 1. */
  Progress progress;
};

/** Finds candidates and adds all available data: attenuation, shape diffusion, place on the flat map, segment, remark.
 * Throws the exceptions of its parts. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypCandidate>
                       SearchPolyps(const PolypColon & colon, const PolypSearchOptions & options = {});

/** Mean distance of the candidates to a wall, mm; 0 without candidates. The walls of two positions may coincide in
 * places, so the wall is identified by all candidates together. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
MeanDistanceToWall(const SurfaceMesh & wall, const std::vector<PolypCandidate> & candidates);

/** Converts candidates for FindInOtherPosition(), with their own scores. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<OtherPolypCandidate>
                       AsOthers(const std::vector<PolypCandidate> & candidates);

/** Maps candidates to the other position by a map of ColonRegistration: a flat surface with the point arrays mapped
 * (LPS, mm), excluded and confidence. Throws InputError, prefixed with `what`, when an array is missing or candidates
 * are on average more than 10 mm from the surface. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
FindInOtherPosition(const SurfaceMesh &                      map,
                    const std::string &                      what,
                    const std::vector<OtherPolypCandidate> & others,
                    std::vector<PolypCandidate> &            candidates);

/** Registrations of lower confidence provide no evidence on single candidates. \ingroup ShapetonPolypCandidates */
constexpr double LeastRegistrationConfidence = 0.5;

/** Updates candidates after FindInOtherPosition() with the evidence of the other position: a polyp stays in place, and
 * most stool moves. The shape score becomes the probability of a polyp given this score, the flatness, and the likeness
 * at its place (logistic regression on phantoms, see the notes); the tissue factor is kept. The score is unchanged to
 * the extent that the registration may be wrong, where the place is not visible, and at the valve. Candidates are
 * sorted by their new scores, keep their numbers, and get a remark if nothing similar is visible. \param confidence of
 * the registration, 0 to 1. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
WeighByOtherPosition(double confidence, std::vector<PolypCandidate> & candidates);

/** Category implied by the sizes of the candidates alone; the category itself ("C0" to "C4") is the reader's decision.
 * C-RADS (Zalis et al., Radiology 2005): C1 no candidate of 6 mm, C2 fewer than three of 6 to 9 mm, C3 one of 10 mm or
 * three of 6 to 9 mm; C4 requires a reader. A text that states that it is implied. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::string
                       CategoryImplied(const std::vector<PolypCandidate> & candidates);

/** One row per candidate; unknown values are empty. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT CsvTable
TableOfPolypCandidates(const std::vector<PolypCandidate> & candidates);

/** Reads candidates from such a table, with its precision: without vertices, apex, axis, and the features of the score.
 * Throws InputError for any other file. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypCandidate>
                       ReadPolypCandidates(const std::string & path);

/** Reads candidates for FindInOtherPosition() with the scores of their own position from a table with the columns x, y,
 * z (LPS, mm); without a column `candidate` they are numbered by row. Throws InputError for any other file.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<OtherPolypCandidate>
                       ReadOtherPolypCandidates(const std::string & path);

/** Points for 3D Slicer, labeled by number and diameter; empty without candidates. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<Markup>
                       MarkupsOfPolypCandidates(const std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
