#include "shapetonDicomMeasurements.h"

#include "shapetonDicomText.h"

#include <algorithm>
#include <string>

namespace shapeton
{
namespace
{
const DicomCode comment{ "121106", "DCM", "Comment" };

std::string
NameOf(const DicomResultHeader & header)
{
  return "Shapeton " + header.tool;
}

DicomContent
ContentOf(const DicomMeasurement & measurement, const DicomMeasurementGroup & group, const DicomSource & source)
{
  DicomContent number = NumberContent("CONTAINS", measurement.name, measurement.digits, measurement.unit);
  if (measurement.derivation)
  {
    number.children.push_back(
      CodeContent("HAS CONCEPT MOD", { "121401", "DCM", "Derivation" }, *measurement.derivation));
  }
  if (measurement.isLine)
  {
    number.children.push_back(PixelLineContent(
      "INFERRED FROM", { "121055", "DCM", "Path" }, group.center, std::stod(measurement.digits), source));
  }
  return number;
}

/** The algorithm of the numbers, TID 4019; or, if some numbers are the observer's, a comment for each of the others. */
std::vector<DicomContent>
AlgorithmOf(const std::vector<DicomMeasurement> & measurements, const DicomResultHeader & header)
{
  const auto isByObserver = [](const DicomMeasurement & measurement) { return measurement.isByObserver; };
  std::vector<DicomContent> contents;
  if (!measurements.empty() && std::none_of(measurements.begin(), measurements.end(), isByObserver))
  {
    contents.push_back(TextContent("HAS CONCEPT MOD", { "111001", "DCM", "Algorithm Name" }, NameOf(header)));
    contents.push_back(TextContent("HAS CONCEPT MOD", { "111003", "DCM", "Algorithm Version" }, header.version));
    return contents;
  }
  for (const DicomMeasurement & measurement : measurements)
  {
    if (!measurement.isByObserver)
    {
      contents.push_back(TextContent(
        "CONTAINS", comment, measurement.name.meaning + ": measured by " + NameOf(header) + ' ' + header.version));
    }
  }
  return contents;
}

DicomContent
ContentOf(const DicomEvaluation & evaluation)
{
  return evaluation.code ? CodeContent("CONTAINS", evaluation.name, *evaluation.code)
                         : TextContent("CONTAINS", evaluation.name, evaluation.text);
}

/** TID 1411, or TID 1501 for a group without a segment. */
DicomContent
ContentOf(const DicomMeasurementGroup & group, const DicomSource & source, const DicomResultHeader & header)
{
  std::vector<DicomContent> contents;
  const auto                add = [&](DicomContent content) { contents.push_back(std::move(content)); };
  add(TextContent("HAS OBS CONTEXT", { "112039", "DCM", "Tracking Identifier" }, group.trackingID));
  add(UIDContent("HAS OBS CONTEXT", { "112040", "DCM", "Tracking Unique Identifier" }, group.trackingUID));
  add(CodeContent("CONTAINS", { "121071", "DCM", "Finding" }, group.finding));
  if (group.segment > 0)
  {
    add(SegmentContent("CONTAINS", { "121191", "DCM", "Referenced Segment" }, group.segmentation, group.segment));
    add(UIDContent("CONTAINS", { "121232", "DCM", "Source series for segmentation" }, source.series.uid));
  }
  for (const DicomCode & site : group.sites)
  {
    add(CodeContent("HAS CONCEPT MOD", { "363698007", "SCT", "Finding Site" }, site));
  }
  const DicomCode center{ "111010", "DCM", "Center" };
  if (const itk::Point<double, 3> place(group.center.data());
      source.grid->GetLargestPossibleRegion().IsInside(source.grid->TransformPhysicalPointToIndex(place)))
  {
    add(PixelPointContent("CONTAINS", center, group.center, source));
  }
  add(SpacePointContent("CONTAINS", center, group.center));
  for (DicomContent & algorithm : AlgorithmOf(group.measurements, header))
  {
    add(std::move(algorithm));
  }
  for (const DicomMeasurement & measurement : group.measurements)
  {
    add(ContentOf(measurement, group, source));
  }
  for (const DicomEvaluation & evaluation : group.evaluations)
  {
    add(ContentOf(evaluation));
  }
  for (const std::string & text : group.comments)
  {
    add(TextContent("CONTAINS", comment, text));
  }
  return ContainerContent(
    "CONTAINS", { "125007", "DCM", "Measurement Group" }, std::move(contents), group.segment > 0 ? "1411" : "1501");
}

std::string
MeaningOfModality(const std::string & modality)
{
  return modality == "CT" ? "Computed Tomography" : modality == "MR" ? "Magnetic Resonance" : modality;
}

/** TID 1600. */
DicomContent
ImageLibrary(const DicomSource & source, const DicomMeasurementReport & report)
{
  std::vector<DicomContent> contents{
    CodeContent("HAS ACQ CONTEXT",
                { "121139", "DCM", "Modality" },
                { source.series.modality, "DCM", MeaningOfModality(source.series.modality) }),
    CodeContent("HAS ACQ CONTEXT", { "123014", "DCM", "Target Region" }, report.region),
    UIDContent("HAS ACQ CONTEXT", { "112227", "DCM", "Frame of Reference UID" }, source.series.frameOfReferenceUID)
  };
  for (const DicomSlice & slice : source.series.slices)
  {
    contents.push_back(SliceContent("CONTAINS", slice));
  }
  return ContainerContent(
    "CONTAINS",
    { "111028", "DCM", "Image Library" },
    { ContainerContent("CONTAINS", { "126200", "DCM", "Image Library Group" }, std::move(contents)) },
    "1600");
}

DicomContent
Evaluations(const DicomMeasurementReport & report)
{
  std::vector<DicomContent> contents;
  for (const DicomEvaluation & evaluation : report.evaluations)
  {
    contents.push_back(ContentOf(evaluation));
  }
  for (const std::string & text : report.comments)
  {
    contents.push_back(TextContent("CONTAINS", comment, text));
  }
  return ContainerContent("CONTAINS", { "C0034375", "UMLS", "Qualitative Evaluations" }, std::move(contents));
}
} // namespace

std::vector<DicomContent>
ContextOfReport(const DicomResultHeader & header, const std::string & person)
{
  const std::string  observer = NameOf(header) + ' ' + header.version;
  const DicomContent language = CodeContent(
    "HAS CONCEPT MOD", { "121049", "DCM", "Language of Content Item and Descendants" }, { "en", "RFC5646", "English" });
  if (!person.empty())
  {
    return { language,
             CodeContent("HAS OBS CONTEXT", { "121005", "DCM", "Observer Type" }, { "121006", "DCM", "Person" }),
             PersonContent("HAS OBS CONTEXT", { "121008", "DCM", "Person Observer Name" }, person) };
  }
  return { language,
           CodeContent("HAS OBS CONTEXT", { "121005", "DCM", "Observer Type" }, { "121007", "DCM", "Device" }),
           UIDContent("HAS OBS CONTEXT", { "121012", "DCM", "Device Observer UID" }, MakeDicomUID(observer)),
           TextContent("HAS OBS CONTEXT", { "121013", "DCM", "Device Observer Name" }, header.tool),
           TextContent("HAS OBS CONTEXT", { "121014", "DCM", "Device Observer Manufacturer" }, "Shapeton"),
           TextContent("HAS OBS CONTEXT", { "121015", "DCM", "Device Observer Model Name" }, observer) };
}

DicomInstance
WriteDicomMeasurements(const DicomSource &            source,
                       const DicomMeasurementReport & report,
                       const DicomResultHeader &      header,
                       const std::string &            path)
{
  std::vector<DicomContent>  groups;
  std::vector<DicomInstance> segmentations;
  for (const DicomMeasurementGroup & group : report.groups)
  {
    groups.push_back(ContentOf(group, source, header));
    const bool isKnown = std::any_of(segmentations.begin(), segmentations.end(), [&](const DicomInstance & one) {
      return one.sopInstanceUID == group.segmentation.sopInstanceUID;
    });
    if (group.segment > 0 && !isKnown)
    {
      segmentations.push_back(group.segmentation);
    }
  }
  std::vector<DicomContent> contents = ContextOfReport(header, report.observer);
  contents.push_back(CodeContent("HAS CONCEPT MOD", { "121058", "DCM", "Procedure reported" }, report.procedure));
  contents.push_back(ImageLibrary(source, report));
  contents.push_back(ContainerContent("CONTAINS", { "126010", "DCM", "Imaging Measurements" }, std::move(groups)));
  contents.push_back(Evaluations(report));
  const DicomContent root =
    ContainerContent({}, { "126000", "DCM", "Imaging Measurement Report" }, std::move(contents), "1500");
  return WriteDicomReport(
    source, DicomReportKind::Comprehensive3D, root, segmentations, header, path, report.completion);
}
} // namespace shapeton
