#ifndef shapetonReaderReportPage_h
#define shapetonReaderReportPage_h

#include "shapetonReaderLesions.h"

#include <utility>

namespace shapeton
{
/** A position of the patient, as its run describes it. */
struct ReadPosition
{
  ExaminationFolder folder;
  /** "supine", "prone", ... */
  std::string name;
  /** UID of the series; empty if it is unknown or omitted. */
  std::string series;
};

/** Content of the reader's report. */
struct ReaderReportContent
{
  std::vector<ReadPosition> positions;
  ReaderVerdicts            verdicts;
  std::vector<ReaderLesion> lesions;
  /** Identities of the examination and of the verdicts. */
  std::vector<std::pair<std::string, std::string>> sources;
};

/** Writes the page: the result first, then pictures. Throws InputError for a faulty file of the run; OutputError. */
void
WriteReaderReportPage(const ReaderReportContent & content, const std::string & path);
} // namespace shapeton

#endif
