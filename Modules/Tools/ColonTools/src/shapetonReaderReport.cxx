#include "shapetonReaderReport.h"

#include "shapetonColonSegments.h"
#include "shapetonJson.h"
#include "shapetonPdfFile.h"
#include "shapetonReaderReportPage.h"
#include "shapetonSha256.h"

#include <cmath>

namespace shapeton
{
namespace
{
std::vector<ReadPosition>
ReadPositions(const ColonExamination & exam, bool isAnonymous)
{
  std::vector<ReadPosition> positions;
  for (const ExaminationFolder & folder : exam.GetPositions())
  {
    const Json quality = folder.ReadQuality();
    positions.push_back({ folder, PositionOfQuality(quality), isAnonymous ? "" : SeriesOfQuality(quality) });
  }
  return positions;
}

/** Names that the runs do not state, or state twice, are replaced by "first" and "second". */
std::vector<ReadPosition>
WithDistinctNames(std::vector<ReadPosition> positions)
{
  const bool isDistinct = !positions.front().name.empty() && !positions.back().name.empty() &&
                          (positions.size() == 1 || positions.front().name != positions.back().name);
  for (std::size_t k = 0; k < positions.size() && !isDistinct; ++k)
  {
    const std::string order = k == 0 ? "first" : "second";
    positions[k].name = positions[k].name.empty() ? order : order + " (" + positions[k].name + ")";
  }
  return positions;
}

ReaderReportContent
ContentOf(const ReaderReportInput & input)
{
  const ColonExamination exam(input.exam, input.second);
  ReaderReportContent    content;
  content.positions = WithDistinctNames(ReadPositions(exam, input.isAnonymous));
  content.verdicts = ReadReaderVerdicts(input.verdicts, exam);
  content.lesions = LesionsOf(content.verdicts, exam.ReadCandidates());
  content.sources = { { "Examination, SHA-256", exam.Digest() },
                      { "Verdicts, SHA-256", Sha256OfFile(input.verdicts) } };
  return content;
}

std::vector<std::string>
RowOf(const ReaderLesion & one, const std::vector<ReadPosition> & positions)
{
  const auto        cell = [](double value) { return std::isfinite(value) ? CsvTable::Number(value) : ""; };
  const auto        by = [](bool isByReader) { return isByReader ? "reader" : "program"; };
  const std::string morphology = NameOf(one.Morphology());
  return { one.id,
           one.candidate ? "candidate" : "finding",
           NameOf(one.verdict),
           positions[one.position].name,
           cell(one.place.x()),
           cell(one.place.y()),
           cell(one.place.z()),
           NameOfSegment(one.segment),
           cell(one.arcLength),
           cell(one.Size()),
           std::isfinite(one.Size()) ? by(one.IsSizeByReader()) : "",
           morphology,
           morphology.empty() ? "" : by(one.IsMorphologyByReader()),
           one.sameAs,
           one.candidate ? cell(one.candidate->score) : "",
           one.statement.note };
}

CsvTable
TableOf(const ReaderReportContent & content)
{
  CsvTable table({ "id",
                   "kind",
                   "verdict",
                   "position",
                   "x",
                   "y",
                   "z",
                   "segment",
                   "arcLength",
                   "size",
                   "sizeBy",
                   "morphology",
                   "morphologyBy",
                   "sameAs",
                   "score",
                   "note" });
  for (const ReaderLesion & one : content.lesions)
  {
    table.AddRow(RowOf(one, content.positions));
  }
  return table;
}

} // namespace

Remarks
WriteReaderReport(const ReaderReportInput & input, const std::string & folder, const OutputPath & outputPath)
{
  const ReaderReportContent content = ContentOf(input);
  const std::string         page = outputPath(folder + "/reader-report.html");
  WriteReaderReportPage(content, page);
  TableOf(content).Write(outputPath(folder + "/reader-report.csv"));
  return PrintPage(page, folder + "/reader-report.pdf", outputPath);
}
} // namespace shapeton
