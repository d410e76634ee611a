#ifndef shapetonReaderLesions_h
#define shapetonReaderLesions_h

#include "ShapetonColonToolsExport.h"
#include "shapetonReaderVerdicts.h"

namespace shapeton
{
/** A candidate of the program with the reader's verdict, or a finding of the reader. */
struct ShapetonColonTools_EXPORT ReaderLesion
{
  /** NameOfCandidate(), or the id of a finding. */
  std::string id;
  /** 0 for the first position of the patient, 1 for the second. */
  std::size_t position{ 0 };
  /** Polyp for a finding. */
  ReaderVerdict verdict{ ReaderVerdict::Unread };
  /** LPS, mm. */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
  /** 1 rectum to 6 cecum; 0 if unknown. */
  int segment{ 0 };
  /** Distance from the anal verge along the centerline (mm); NaN if unknown. */
  double          arcLength{ std::numeric_limits<double>::quiet_NaN() };
  ReaderStatement statement;
  /** The candidate; empty for a finding. */
  std::optional<PolypCandidate> candidate;
  /** The accepted candidate of the first position that shows the same polyp; empty if there is none. */
  std::string sameAs{};

  bool
  IsSizeByReader() const;
  /** Largest diameter (mm): the reader's, else that measured by the program; NaN if there is none. */
  double
  Size() const;
  bool
  IsMorphologyByReader() const;
  /** That of the reader if there is one, otherwise that of the program. */
  PolypMorphology
  Morphology() const;
};

/** All candidates in the order of their tables, unread unless the verdicts contain them, then the findings.
 *
 * A polyp that was accepted in both positions counts once: an accepted candidate of the second position that the
 * registration matched with an accepted one of the first is marked as the same, and a size or morphology that the
 * reader entered only for the second one is copied to the first. */
ShapetonColonTools_EXPORT std::vector<ReaderLesion>
LesionsOf(const ReaderVerdicts & verdicts, const std::vector<std::vector<PolypCandidate>> & candidates);

/** The lesions with a verdict, in order. */
ShapetonColonTools_EXPORT std::vector<ReaderLesion>
                          LesionsWith(const std::vector<ReaderLesion> & lesions, ReaderVerdict verdict);

/** "2 of 10 mm and more, 1 of 6 to 9 mm, 0 below 6 mm": the accepted polyps by SizeOf(); each counts once. */
ShapetonColonTools_EXPORT std::string
                          SizesOfAccepted(const std::vector<ReaderLesion> & lesions);

/** Why the reading is preliminary: "3 candidates are unread; no category was entered"; empty if it is complete. */
ShapetonColonTools_EXPORT std::string
WhyPreliminary(const ReaderAssessment & assessment, const std::vector<ReaderLesion> & lesions);
} // namespace shapeton

#endif
