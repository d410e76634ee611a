#include "shapetonColonDicomResults.h"

#include "shapetonColonFhir.h"
#include "shapetonColonReportsAsDicom.h"
#include "shapetonColonTerms.h"
#include "shapetonContentIdentity.h"
#include "shapetonDicomPictures.h"
#include "shapetonExceptions.h"
#include "shapetonPicture.h"
#include "shapetonReadImage.h"
#include "shapetonImageGrid.h"

#include "itkPNGImageIO.h"

#include <algorithm>
#include <map>
#include <optional>

namespace shapeton
{
namespace
{
DicomSource
ReadSourceOf(const DicomExamination & exam, const std::string & path)
{
  const DicomSource source = ReadDicomSource(path, { exam.seriesUID });
  if (IdentityOf(path) != exam.digest)
  {
    throw InputError("\"" + path + "\" differs from the folder that the examination \"" + exam.folder.GetFolder() +
                     "\" was computed from, although the series is the same; use that folder, or run "
                     "VirtualColonoscopy on this one");
  }
  if (!HaveSameGrid(exam.lumen, source.grid))
  {
    throw InputError("the examination \"" + exam.folder.GetFolder() +
                     "\" was computed from a repaired series, whose voxels do not match the original slices");
  }
  return source;
}

std::optional<ColonReading>
ReadReading(const ColonDicomReader & reader)
{
  if (reader.verdicts.empty())
  {
    return {};
  }
  RequireDicomPersonName("observer", reader.observer);
  const ColonExamination exam(reader.exam);
  ColonReading           reading;
  reading.verdicts = ReadReaderVerdicts(reader.verdicts, exam);
  reading.lesions = LesionsOf(reading.verdicts, exam.ReadCandidates());
  reading.observer = reader.observer;
  return reading;
}

/** The DICOM files of an examination. Their headers state the version of the run, not of the program that writes them.
 */
class ResultFiles
{
public:
  ResultFiles(const DicomExamination & exam,
              const DicomSource &      series,
              std::string              folder,
              DicomResultDates         dates,
              const OutputPath &       outputPath)
    : m_Series(series)
    , m_Folder(std::move(folder))
    , m_OutputPath(outputPath)
    , m_Dates(dates)
    , m_Version(exam.quality.value("/provenance/version"_json_pointer, std::string("unknown")))
    , m_Title(TitleOf(PositionOfQuality(exam.quality)))
  {}

  const DicomSource &
  Series() const
  {
    return m_Series;
  }

  std::string
  PathOf(const std::string & name) const
  {
    return m_OutputPath(m_Folder + '/' + name);
  }

  /** Calls `write` with header and path. Series numbers are consecutive. */
  template <typename Writer>
  void
  Write(int                 number,
        const std::string & name,
        const std::string & what,
        const std::string & modality,
        const Writer &      write)
  {
    constexpr int           firstSeries = 9000;
    const DicomResultHeader header{ m_Tool, m_Version, firstSeries + number, m_Title + what, "COLON", m_Dates };
    m_Written.push_back({ write(header, this->PathOf(name)), modality, header.seriesDescription });
  }

  /** A bundle of the written instances. */
  Json
  Bundle(DicomMeasurementReport report, std::optional<DicomMeasurementReport> reader) const
  {
    auto & groups = report.groups;
    groups.erase(
      std::remove_if(groups.begin(),
                     groups.end(),
                     [](const DicomMeasurementGroup & group) { return !(group.finding == colonterms::lesion); }),
      groups.end());
    report.comments.insert(report.comments.begin() + 1, // after the research note
                           std::to_string(groups.size()) + " candidates of a program, not findings of a reader");
    return FhirBundleOf({ PatientIDOf(m_Series), m_Series.series, m_Written, m_Tool, m_Version, report, reader });
  }

private:
  /** Start of series descriptions; distinguishes the series of two positions in viewers. */
  static std::string
  TitleOf(const std::string & position)
  {
    static const std::map<std::string, std::string> words{
      { "supine", "supine" }, { "prone", "prone" }, { "leftDecubitus", "left side" }, { "rightDecubitus", "right side" }
    };
    const auto word = words.find(position);
    return word == words.end() ? "Research: " : "Research, " + word->second + ": ";
  }

  static constexpr const char * m_Tool = "VirtualColonoscopy";

  const DicomSource &       m_Series;
  std::string               m_Folder;
  const OutputPath &        m_OutputPath;
  DicomResultDates          m_Dates;
  std::string               m_Version;
  std::string               m_Title;
  std::vector<WrittenDicom> m_Written;
};

DicomSegmentationFormat
FormatOf(const ColonDicomObjectOptions & options)
{
  using Format = DicomSegmentationFormat;
  return options.labelMap ? (options.deflate ? Format::DeflatedLabelMap : Format::LabelMap)
                          : (options.deflate ? Format::DeflatedBinary : Format::Binary);
}

/** Writes both segmentations. */
void
WriteSegments(ResultFiles & files, const ColonDicomOptions & options, ColonSegmentsAsDicom & segments)
{
  using Part = ColonSegmentsAsDicom::Part;
  constexpr int anatomy = 6; // added after the other series
  const auto    write = [&](int number, const char * name, const char * what, Part part) {
    files.Write(number, name, what, "SEG", [&](const auto & header, const std::string & path) {
      return segments.Write(part, files.Series(), header, path, FormatOf(options));
    });
  };
  options.progress(examination::dicomSegmentation.name, 0.4);
  write(0, examination::dicomSegmentation.name, "lumen and candidates", Part::Findings);
  options.progress(examination::dicomAnatomy.name, 0.6);
  if (segments.HasAnatomy())
  {
    write(anatomy, examination::dicomAnatomy.name, "anatomy of the colon", Part::Anatomy);
  }
}

void
WriteMeasurements(ResultFiles &                  files,
                  int                            number,
                  const std::string &            name,
                  const std::string &            what,
                  const DicomMeasurementReport & report)
{
  files.Write(number, name, what, "SR", [&](const auto & header, const std::string & path) {
    return WriteDicomMeasurements(files.Series(), report, header, path);
  });
}

/** The report of the program, and that of the reader if there is a reading. */
struct Reports
{
  DicomMeasurementReport                program;
  std::optional<DicomMeasurementReport> reader;
};

Reports
WriteReports(ResultFiles &                       files,
             const DicomExamination &            exam,
             const ColonDicomOptions &           options,
             const std::optional<ColonReading> & reading,
             const ColonSegmentsAsDicom &        segments)
{
  Reports reports{ MeasurementsOfColon(exam, segments), {} };
  WriteMeasurements(files, 1, examination::dicomMeasurements.name, "colon measurements", reports.program);
  if (options.ohif)
  {
    constexpr int     seriesForOhif = 7;
    const std::string what = "candidates to be read in OHIF";
    WriteMeasurements(files, seriesForOhif, examination::dicomForOhif.name, what, CandidatesForOhif(exam, segments));
  }
  if (reading)
  {
    constexpr int seriesOfReading = 5; // the first number without another object
    reports.reader = MeasurementsOfReader(*reading, options.reader.position, segments);
    WriteMeasurements(files, seriesOfReading, examination::dicomReading.name, "reading of the colon", *reports.reader);
  }
  return reports;
}

/** Writes the candidates for workstations. */
void
WriteCad(ResultFiles & files, const DicomExamination & exam, const ColonSegmentsAsDicom & segments)
{
  files.Write(2, examination::dicomCad.name, "colon CAD", "SR", [&](const auto & header, const std::string & path) {
    const DicomContent report = CadReportOfColon(exam, segments, files.Series(), header);
    return WriteDicomReport(files.Series(), DicomReportKind::ColonCAD, report, {}, header, path);
  });
}

/** Writes the wall, and the flat colon if it exists. */
void
WritePictures(ResultFiles & files, DicomExamination & exam)
{
  if (exam.Has(examination::flatPicture, "no picture of the flat colon"))
  {
    files.Write(
      3, examination::dicomPicture.name, "flat colon", "OT", [&](const auto & header, const std::string & path) {
        return WriteDicomPicture(files.Series(),
                                 ReadImage<Picture>(exam.folder.PathOf(examination::flatPicture),
                                                    itk::PNGImageIO::New(),
                                                    "run VirtualColonoscopy again"),
                                 header,
                                 path);
      });
  }
  if (exam.Has(examination::simplifiedWall, "no surface of the wall"))
  {
    files.Write(
      4, examination::dicomWall.name, "wall of the colon", "M3D", [&](const auto & header, const std::string & path) {
        const DicomCode wall{ "WALL", "99SHAPETON", "Wall of the colon" };
        return WriteDicomSurface(
          files.Series(), exam.folder.ReadSurfaceOf(examination::simplifiedWall), wall, header, path);
      });
  }
}
} // namespace

Remarks
WriteColonDicomResults(const std::string &       exam,
                       const std::string &       source,
                       const std::string &       folder,
                       const ColonDicomOptions & options,
                       const OutputPath &        outputPath)
{
  options.progress("Reading", 0.0);
  const std::optional<ColonReading> reading = ReadReading(options.reader);
  DicomExamination                  examination = ReadDicomExamination(exam);
  const DicomSource                 series = ReadSourceOf(examination, source);
  ResultFiles                       files(examination, series, folder, options.dates, outputPath);
  ColonSegmentsAsDicom              segments(examination);
  WriteSegments(files, options, segments);
  options.progress(examination::dicomMeasurements.name, 0.9);
  const Reports reports = WriteReports(files, examination, options, reading, segments);
  options.progress(examination::dicomCad.name, 0.92);
  WriteCad(files, examination, segments);
  options.progress("sc.dcm, stl.dcm", 0.94);
  WritePictures(files, examination);
  if (options.fhir)
  {
    WriteJson(files.Bundle(reports.program, reports.reader), files.PathOf(examination::fhirBundle.name));
  }
  options.progress("Done", 1.0);
  return examination.missing;
}
} // namespace shapeton
