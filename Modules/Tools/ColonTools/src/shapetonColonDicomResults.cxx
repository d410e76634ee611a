#include "shapetonColonDicomResults.h"

#include "shapetonColonReportsAsDicom.h"
#include "shapetonContentIdentity.h"
#include "shapetonDicomPictures.h"
#include "shapetonExceptions.h"
#include "shapetonPicture.h"
#include "shapetonReadImage.h"
#include "shapetonSurfaceReader.h"
#include "shapetonVolume.h"

#include "itkPNGImageIO.h"

#include <optional>

namespace shapeton
{
namespace
{
DicomSource
ReadSourceOf(const ColonExamination & exam, const std::string & path)
{
  const DicomSource source = ReadDicomSource(path, { exam.seriesUID });
  if (IdentityOf(path) != exam.digest)
  {
    throw InputError("\"" + path + "\" differs from the folder that the examination \"" + exam.folder +
                     "\" was computed from, although the series is the same; use that folder, or run "
                     "VirtualColonoscopy on this one");
  }
  if (!HaveSameGrid(exam.lumen, source.grid))
  {
    throw InputError("the examination \"" + exam.folder +
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
  const std::vector<std::string> folders = PositionFoldersOf(reader.exam);
  ColonReading                   reading;
  reading.verdicts = ReadReaderVerdicts(reader.verdicts, folders);
  reading.lesions = LesionsOf(reading.verdicts, CandidatesOfPositions(folders));
  reading.observer = reader.observer;
  return reading;
}

/** Headers of the objects of an examination. They name the run, not the program that wrote them. */
class Headers
{
public:
  Headers(const ColonExamination & exam, DicomResultDates dates)
    : m_Version(exam.quality.value("/provenance/version"_json_pointer, std::string("unknown"))), m_Dates(dates)
  {}

  /** Series numbers are consecutive. */
  DicomResultHeader
  Make(int number, const std::string & what) const
  {
    constexpr int firstSeries = 9000;
    return { "VirtualColonoscopy", m_Version, firstSeries + number, "Research: " + what, "COLON", m_Dates };
  }

private:
  std::string      m_Version;
  DicomResultDates m_Dates;
};

/** Writes both segmentations. */
void
WriteSegments(const DicomSource &       series,
              const std::string &       folder,
              const Headers &           headers,
              const ColonDicomOptions & options,
              const OutputPath &        outputPath,
              ColonSegmentsAsDicom &    segments)
{
  constexpr int anatomy = 6; // added after the other series
  options.progress("seg.dcm", 0.4);
  segments.WriteFindings(
    series, headers.Make(0, "lumen and candidates"), outputPath(folder + "/seg.dcm"), options.segmentation);
  options.progress("seg-anatomy.dcm", 0.6);
  if (segments.HasAnatomy())
  {
    segments.WriteAnatomy(series,
                          headers.Make(anatomy, "anatomy of the colon"),
                          outputPath(folder + "/seg-anatomy.dcm"),
                          options.segmentation);
  }
}

/** Writes the wall, and the flat colon if it exists. */
void
WritePictures(ColonExamination &  exam,
              const DicomSource & series,
              const std::string & folder,
              const Headers &     headers,
              const OutputPath &  outputPath)
{
  if (exam.Has("flattening/flat.png", "no picture of the flat colon"))
  {
    WriteDicomPicture(
      series,
      ReadImage<Picture>(exam.PathOf("flattening/flat.png"), itk::PNGImageIO::New(), "run VirtualColonoscopy again"),
      headers.Make(3, "flat colon"),
      outputPath(folder + "/sc.dcm"));
  }
  if (exam.Has("segmentation/wall-simplified.vtp", "no surface of the wall"))
  {
    const DicomCode wall{ "WALL", "99SHAPETON", "Wall of the colon" };
    WriteDicomSurface(series,
                      ReadSurface(exam.PathOf("segmentation/wall-simplified.vtp")).mesh,
                      wall,
                      headers.Make(4, "wall of the colon"),
                      outputPath(folder + "/stl.dcm"));
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
  ColonExamination                  examination = ReadColonExamination(exam);
  const DicomSource                 series = ReadSourceOf(examination, source);
  const Headers                     headers(examination, options.dates);
  ColonSegmentsAsDicom              segments(examination);
  WriteSegments(series, folder, headers, options, outputPath, segments);
  options.progress("sr.dcm", 0.9);
  WriteDicomMeasurements(series,
                         MeasurementsOfColon(examination, segments),
                         headers.Make(1, "colon measurements"),
                         outputPath(folder + "/sr.dcm"));
  if (options.forOhif)
  {
    constexpr int seriesForOhif = 7;
    WriteDicomMeasurements(series,
                           CandidatesForOhif(examination, segments),
                           headers.Make(seriesForOhif, "candidates to be read in OHIF"),
                           outputPath(folder + "/sr-ohif.dcm"));
  }
  if (reading)
  {
    constexpr int seriesOfReading = 5; // the first number without another object
    WriteDicomMeasurements(series,
                           MeasurementsOfReader(*reading, options.reader.position, segments),
                           headers.Make(seriesOfReading, "reading of the colon"),
                           outputPath(folder + "/sr-reader.dcm"));
  }
  options.progress("cad.dcm", 0.92);
  const DicomResultHeader cad = headers.Make(2, "colon CAD");
  WriteDicomReport(series,
                   DicomReportKind::ColonCAD,
                   CadReportOfColon(examination, segments, series, cad),
                   {},
                   cad,
                   outputPath(folder + "/cad.dcm"));
  options.progress("sc.dcm, stl.dcm", 0.94);
  WritePictures(examination, series, folder, headers, outputPath);
  options.progress("Done", 1.0);
  return examination.missing;
}
} // namespace shapeton
