#ifndef shapetonReaderVerdicts_h
#define shapetonReaderVerdicts_h

#include "shapetonColonExamination.h"
#include "shapetonSlicerMarkups.h"

#include <limits>
#include <optional>

namespace shapeton
{
/** The reader's decision on a candidate. \ingroup ShapetonColonExamination */
enum class ReaderVerdict
{
  Unread,
  Polyp,
  NotAPolyp,
  Unsure
};

/** "unread", "polyp", "not a polyp", "unsure". \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::string
                                NameOf(ReaderVerdict verdict);

/** The categories that the reader entered; empty if none. \ingroup ShapetonColonExamination */
struct ReaderAssessment
{
  /** C-RADS category of the colon: "C0", "C1", "C2", "C2a", "C2b", "C3", "C4". */
  std::string colonic;
  /** C-RADS category of extracolonic findings: "E0" to "E4", or "E1/E2", which C-RADS 2023 merged. */
  std::string extracolonic;
  std::string note;
};

/** The reader's description of a lesion. \ingroup ShapetonColonExamination */
struct ReaderStatement
{
  /** Largest diameter (mm, above 0 to 200); NaN if the reader did not enter one. */
  double          size{ std::numeric_limits<double>::quiet_NaN() };
  PolypMorphology morphology{ PolypMorphology::Unknown };
  std::string     note;
};

/** The reader's verdict on a candidate of the program. \ingroup ShapetonColonExamination */
struct CandidateVerdict
{
  /** See NameOfCandidate(). */
  std::string     id;
  ReaderVerdict   verdict{ ReaderVerdict::Unread };
  ReaderStatement statement;
};

/** A polyp, or something outside the colon, that the reader found. \ingroup ShapetonColonExamination */
struct ReaderFinding
{
  std::string id;
  /** 0, or 1 for the second position of the patient. */
  std::size_t position{ 0 };
  /** LPS, mm. */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
  /** From 1 (rectum) to 6 (cecum); 0 if unknown. */
  int segment{ 0 };
  /** Distance from the anal verge along the centerline (mm); NaN if unknown. */
  double          arcLength{ std::numeric_limits<double>::quiet_NaN() };
  ReaderStatement statement;
};

/** A place that the reader marked, with a snapshot. \ingroup ShapetonColonExamination */
struct ReaderBookmark
{
  std::string     id;
  std::size_t     position{ 0 };
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() }; ///< LPS, mm
  std::string     label;
  std::string     png; ///< bytes of a PNG file
};

/** Contents of a verdicts.json. \ingroup ShapetonColonExamination */
struct ReaderVerdicts
{
  /** Whether the reader first read the examination without candidates; unknown in version 1. */
  std::optional<bool>           isSecondReader;
  ReaderAssessment              assessment;
  std::vector<CandidateVerdict> candidates;
  std::vector<ReaderFinding>    findings;     ///< in the colon
  std::vector<ReaderFinding>    extracolonic; ///< findings outside the colon
  std::vector<ReaderBookmark>   bookmarks;
};

/** Reads a verdicts.json, version 1 or 2, saved by the page of the examination. Keys added by version 2 may be missing.
 *
 * Throws InputError if the version is unknown, the file belongs to another examination, an id is repeated or does not
 * belong to a candidate, a word (verdict, category, morphology, segment) is unknown, a size is not above 0 and at most
 * 200 mm, a picture is not a PNG file, or a value has the wrong type. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT ReaderVerdicts
ReadReaderVerdicts(const std::string & path, const ColonExamination & exam);

/** Writes a verdicts.json, version 2, that the page of the examination opens. Throws OutputError.
 * \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT void
WriteReaderVerdicts(const ReaderVerdicts & verdicts, const ColonExamination & exam, const std::string & path);

/** One point for each candidate in the verdicts, then for each finding, then for each extracolonic one.
 * \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT Markup
MarkupOfVerdicts(const ReaderVerdicts & verdicts, const std::vector<std::vector<PolypCandidate>> & candidates);
} // namespace shapeton

#endif
