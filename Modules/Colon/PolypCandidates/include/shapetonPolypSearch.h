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
/** What is known of a colon in one position; only wall and lumen are needed. \ingroup PolypCandidates */
struct PolypColon
{
  /** Of full resolution, without handles. */
  SurfaceMesh wall;
  /** One curve with the point array arcLength (mm); empty where there is none. */
  CurveSet centreline;
  /** The axis of a rectal catheter as RankCatheterLast() takes it; empty where there is none. */
  CurveSet                 catheter;
  PolypLumenImage::Pointer lumen;
  /** HU, cleansed; null of a mask. */
  itk::Image<float, 3>::Pointer ct;
  /** Null where there is none. */
  std::shared_ptr<const FlatColon> flat;
  /** With the cell array segment; empty where there is none. */
  SurfaceMesh segments;
  /** What is missing, and what that costs. */
  Remarks warnings;
  /** Identities of the files. */
  std::vector<std::pair<std::string, std::string>> facts;
};

/** Reads a folder that VirtualColonoscopy wrote: segmentation/wall-repaired.vtp and lumen.nrrd, and, as far as they are
 * there, centreline.vtp, catheter.vtp, cleansed.nrrd, ../flattening/flat.vtp, ../landmarks/segments.vtp. Throws
 * InputError that names the file. \ingroup PolypCandidates */
PolypCandidates_EXPORT PolypColon
ReadPolypColon(const std::string & folder);

/** Preset and sensitivity for SearchPolyps(). \ingroup PolypCandidates */
struct PolypSearchOptions
{
  PolypPreset preset{ PolypPreset::Default };
  /** 0 to 1: candidates with a score of the shape of at least 1 - sensitivity. */
  double sensitivity{ defaultPolypSensitivity };
  /** Told the stage and the share that is done, from 0 to 1. */
  Progress progress;
};

/** Candidates with all that the colon tells about them: attenuation, shape diffusion, place on the flat map, segment,
 * remark. Throws as its parts do. \ingroup PolypCandidates */
PolypCandidates_EXPORT std::vector<PolypCandidate>
                       SearchPolyps(const PolypColon & colon, const PolypSearchOptions & options = {});

/** From the middles of the candidates to a wall, mm, on average; 0 where there are none. Walls of two positions may lie
 * on each other here and there, so all candidates tell on which one they are. \ingroup PolypCandidates */
PolypCandidates_EXPORT double
MeanDistanceToWall(const SurfaceMesh & wall, const std::vector<PolypCandidate> & candidates);

/** Candidates as the other position sees them: by their own scores. \ingroup PolypCandidates */
PolypCandidates_EXPORT std::vector<OtherPolypCandidate>
                       AsOthers(const std::vector<PolypCandidate> & candidates);

/** Takes candidates to the other position by a map of ColonRegistration: a flat surface with the point arrays mapped
 * (LPS, mm), excluded and confidence. Throws InputError, with `what` in front, where an array is missing or candidates
 * lie more than 10 mm from the surface on average. \ingroup PolypCandidates */
PolypCandidates_EXPORT void
FindInOtherPosition(const SurfaceMesh &                      map,
                    const std::string &                      what,
                    const std::vector<OtherPolypCandidate> & others,
                    std::vector<PolypCandidate> &            candidates);

/** A registration of a lower confidence tells nothing of a single candidate. \ingroup PolypCandidates */
constexpr double LeastRegistrationConfidence = 0.5;

/** What the other position says of candidates that FindInOtherPosition() has taken there: a polyp stays where it is,
 * and most stool moves. The score of the shape becomes the probability that a candidate is a polyp, given this score,
 * how flat it is, and the likeness of what is seen at its place (logistic regression on phantoms, see the notes), with
 * the share of its tissue kept; it stays as it is as far as the registration may be wrong, where the place cannot be
 * seen, and at the valve. Candidates are sorted by their new scores, keep their numbers, and get a remark where nothing
 * like them is seen. \param confidence of the registration, 0 to 1. \ingroup PolypCandidates */
PolypCandidates_EXPORT void
WeighByOtherPosition(double confidence, std::vector<PolypCandidate> & candidates);

/** "C0" to "C4"-like categories are a reader's to give; this is what the sizes of the candidates alone would imply by
 * C-RADS (Zalis et al., Radiology 2005): C1 no candidate of 6 mm, C2 fewer than three of 6 to 9 mm, C3 one of 10 mm or
 * three of 6 to 9 mm; C4 takes a reader. In words, with the remark that it is implied. \ingroup PolypCandidates */
PolypCandidates_EXPORT std::string
                       CategoryImplied(const std::vector<PolypCandidate> & candidates);

/** A row for each candidate; empty cells are not known. \ingroup PolypCandidates */
PolypCandidates_EXPORT CsvTable
TableOfPolypCandidates(const std::vector<PolypCandidate> & candidates);

/** What such a table tells of its candidates, to its digits: not the vertices, the apex and the axis, nor the features
 * that the score is made of. Throws InputError for what is no such table. \ingroup PolypCandidates */
PolypCandidates_EXPORT std::vector<PolypCandidate>
                       ReadPolypCandidates(const std::string & path);

/** The candidates of a table for FindInOtherPosition(), with their scores by their own position alone: any table with
 * the columns x, y, z (LPS, mm), numbered by its rows where there is no column `candidate`. Throws InputError for what
 * is none. \ingroup PolypCandidates */
PolypCandidates_EXPORT std::vector<OtherPolypCandidate>
                       ReadOtherPolypCandidates(const std::string & path);

/** Points of 3D Slicer, labelled by number and diameter; none without candidates. \ingroup PolypCandidates */
PolypCandidates_EXPORT std::vector<Markup>
                       MarkupsOfPolypCandidates(const std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
