#include "shapetonReaderReport.h"

#include "shapetonColonSegments.h"
#include "shapetonJson.h"
#include "shapetonPdfFile.h"
#include "shapetonReaderReportPage.h"
#include "shapetonReportTable.h"
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

/** If a name is missing or both are equal, uses "first" and "second" instead, followed by the name, if any. */
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

CsvTable
LesionTable(const ReaderReportContent & content)
{
  using Lesion = ReaderLesion;
  const auto cell = [](double value) { return std::isfinite(value) ? CsvTable::Number(value) : ""; };
  const auto by = [](bool isByReader) { return isByReader ? "reader" : "program"; };
  CsvTable   table = TableOf<Lesion>(
    content.lesions,
    { { "id", [](const Lesion & one) { return one.id; } },
        { "kind", [](const Lesion & one) { return one.candidate ? "candidate" : "finding"; } },
        { "verdict", [](const Lesion & one) { return NameOf(one.verdict); } },
        { "position", [&](const Lesion & one) { return content.positions[one.position].name; } },
        { "x", [&](const Lesion & one) { return cell(one.place.x()); } },
        { "y", [&](const Lesion & one) { return cell(one.place.y()); } },
        { "z", [&](const Lesion & one) { return cell(one.place.z()); } },
        { "segment", [](const Lesion & one) { return NameOfSegment(one.segment); } },
        { "arcLength", [&](const Lesion & one) { return cell(one.arcLength); } },
        { "size", [&](const Lesion & one) { return cell(one.Size()); } },
        { "sizeBy", [&](const Lesion & one) { return std::isfinite(one.Size()) ? by(one.IsSizeByReader()) : ""; } },
        { "morphology", [](const Lesion & one) { return NameOf(one.Morphology()); } },
        { "morphologyBy",
          [&](const Lesion & one) { return NameOf(one.Morphology()).empty() ? "" : by(one.IsMorphologyByReader()); } },
        { "sameAs", [](const Lesion & one) { return one.sameAs; } },
        { "score", [&](const Lesion & one) { return one.candidate ? cell(one.candidate->score) : ""; } },
        { "note", [](const Lesion & one) { return one.statement.note; } } });
  for (const ReaderFinding & one : content.verdicts.extracolonic)
  {
    table.AddRow({ one.id,
                   "extracolonic finding",
                   "",
                   content.positions[one.position].name,
                   cell(one.place.x()),
                   cell(one.place.y()),
                   cell(one.place.z()),
                   "",
                   "",
                   cell(one.statement.size),
                   std::isfinite(one.statement.size) ? "reader" : "",
                   "",
                   "",
                   "",
                   "",
                   one.statement.note });
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
  LesionTable(content).Write(outputPath(folder + "/reader-report.csv"));
  return PrintPage(page, folder + "/reader-report.pdf", outputPath);
}
} // namespace shapeton
