#include "shapetonDicomMeasurements.h"
#include "shapetonDicomReportReader.h"
#include "shapetonDicomResultsTesting.h"
#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonTestReports.h"

#include <ctime>
#include <functional>
#include <iomanip>
#include <sstream>

namespace
{
using namespace shapeton;

const DicomCode center{ "111010", "DCM", "Center" };

DicomMeasurementReport
ReportWithTwoGroups()
{
  DicomMeasurementReport report;
  report.procedure = { "25045-6", "LN", "CT unspecified body region" };
  report.region = { "71854001", "SCT", "Colon" };
  report.comments = { "a remark" };
  DicomMeasurementGroup group;
  group.trackingID = "candidate 1";
  group.trackingUID = "2.25.9";
  group.finding = { "52988006", "SCT", "Lesion" };
  group.segment = 3;
  group.segmentation = { UID_SegmentationStorage, "2.25.7", "2.25.8" };
  group.center = { 1.5, -2.25, 3.0 };
  group.measurements = { { { "81827009", "SCT", "Diameter" }, "7.5", { "mm", "UCUM", "mm" }, {} } };
  report.groups.push_back(group);
  group.trackingID = "no segment";
  group.segment = 0;
  group.center = { 1000.0, 0.0, 0.0 }; // outside the series
  report.groups.push_back(group);
  return report;
}

DicomContent
RootWith(std::vector<DicomContent> contents)
{
  return ContainerContent({}, { "126000", "DCM", "Imaging Measurement Report" }, std::move(contents), "1500");
}

class DicomReport : public ResultsOfASeries
{
protected:
  DcmFileFormat
  Measured(const DicomMeasurementReport & report = ReportWithTwoGroups())
  {
    WriteDicomMeasurements(source, report, HeaderOfTest(), path);
    return Loaded(path);
  }

  void
  WriteCad(std::vector<DicomContent> contents)
  {
    WriteDicomReport(source, DicomReportKind::ColonCAD, RootWith(std::move(contents)), {}, HeaderOfTest(), path);
  }

  std::string path = folder + "/sr.dcm";
};
} // namespace

TEST_F(DicomReport, PointsComeBack)
{
  this->Measured();
  const auto points = ReadDicomReportPoints(path, source);
  ASSERT_EQ(points.size(), 2u); // once each, although the first is also written in pixels
  EXPECT_EQ(points[0].name, "candidate 1");
  ASSERT_EQ(points[0].places.size(), 1u);
  EXPECT_EQ(points[0].places[0][0], 1.5);
  EXPECT_EQ(points[0].places[0][1], -2.25);
  EXPECT_EQ(points[0].places[0][2], 3.0);
  EXPECT_EQ(points[1].name, "no segment");
  EXPECT_EQ(points[1].places[0][0], 1000.0);
}

TEST_F(DicomReport, CentersAreInPixelsOfASliceBeforeTheyAreInSpace)
{
  DicomMeasurementReport report = ReportWithTwoGroups();
  const auto             place = source.grid->TransformIndexToPhysicalPoint<double>({ 2, 4, 3 });
  report.groups[0].center = { place[0], place[1], place[2] };
  DcmFileFormat file = this->Measured(report);
  EXPECT_EQ(ValueOf(file, DCM_GraphicData), "2.5\\4.5"); // the first center: pixels count from the corner
  const std::string text = ReadFileBytes(path);
  const std::size_t pixel = text.find("SCOORD\x40");
  const std::size_t image = text.find(source.series.slices[3].sopInstanceUID, pixel);
  const std::size_t space = text.find("SCOORD3D\x40");
  EXPECT_LT(pixel, image);
  EXPECT_LT(image, space);
  EXPECT_EQ(text.find("SCOORD\x40", space), std::string::npos) << "the point outside the series has no pixel";
}

TEST_F(DicomReport, PlacesInPixelsComeBackWithinTheirSlice)
{
  // A point in the plane of slice 3, at column 2.25 and row 4.5.
  itk::ContinuousIndex<double, 3> index;
  index[0] = 2.25;
  index[1] = 4.5;
  index[2] = 3.0;
  const auto                  place = source.grid->TransformContinuousIndexToPhysicalPoint<double>(index);
  const std::array<double, 3> point{ place[0], place[1], place[2] };
  this->WriteCad({ PixelPointContent("CONTAINS", center, point, source) });
  DcmFileFormat file = Loaded(path);
  EXPECT_EQ(ValueOf(file, DCM_GraphicData), "2.75\\5");
  const auto points = ReadDicomReportPoints(path, source);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].name, "Center");
  EXPECT_LT(points[0].places[0].EuclideanDistanceTo(place), 1e-5);
}

TEST_F(DicomReport, IsPartialUnverifiedAndForResearch)
{
  DcmFileFormat file = this->Measured();
  EXPECT_EQ(ValueOf(file, DCM_CompletionFlag), "PARTIAL");
  EXPECT_EQ(ValueOf(file, DCM_VerificationFlag), "UNVERIFIED");
  EXPECT_EQ(ValueOf(file, DCM_PreliminaryFlag), "PRELIMINARY");
  EXPECT_EQ(ValueOf(file, DCM_PatientID), "P1");
  EXPECT_EQ(ValueOf(file, DCM_ContentDate), "20010204");
  EXPECT_EQ(ValueOf(file, DCM_NumericValue), "7.5");
  WriteDicomMeasurements(source, ReportWithTwoGroups(), HeaderOfTest(), folder + "/again.dcm");
  EXPECT_EQ(ReadFileBytes(path), ReadFileBytes(folder + "/again.dcm"));
}

TEST_F(DicomReport, OfAPersonNamesNoProgramForItsMeasurements)
{
  DicomMeasurementReport report = ReportWithTwoGroups();
  report.observer = "M\xC3\xBCller";
  report.completion = DicomCompletion::Complete;
  report.evaluations = { { { "112222", "DCM", "Colon Overall Assessment" }, {}, "C3" } };
  for (DicomMeasurementGroup & group : report.groups)
  {
    group.measurements[0].isByObserver = true;
    group.evaluations = { { { "SHAPE", "99SHAPETON", "Shape" }, DicomCode{ "6041008", "SCT", "Flat" }, {} } };
  }
  DcmFileFormat file = this->Measured(report);
  EXPECT_EQ(ValueOf(file, DCM_CompletionFlag), "COMPLETE");
  EXPECT_EQ(ValueOf(file, DCM_VerificationFlag), "UNVERIFIED");
  EXPECT_EQ(ValueOf(file, DCM_SpecificCharacterSet), "ISO_IR 192");
  EXPECT_EQ(ValueOf(file, DCM_PersonName), "M\xC3\xBCller^");
  const std::string bytes = ReadFileBytes(path);
  EXPECT_FALSE(Contains(bytes, "Algorithm Name"));
  EXPECT_FALSE(Contains(bytes, "Device Observer"));
  EXPECT_TRUE(Contains(bytes, "Colon Overall Assessment"));
  EXPECT_TRUE(Contains(bytes, "6041008"));
  EXPECT_EQ(ReadDicomReportPoints(path, source).size(), 2u);
}

TEST_F(DicomReport, NamesItsAlgorithmOncePerGroupOrForTheNumbersOfTheProgram)
{
  DicomMeasurementReport report = ReportWithTwoGroups();
  for (DicomMeasurementGroup & group : report.groups)
  {
    group.measurements.push_back(group.measurements[0]);
  }
  this->Measured(report);
  EXPECT_EQ(basetest::CountOf(ReadFileBytes(path), "Algorithm Name"), 2U);
  report.groups[0].measurements[1].isByObserver = true;
  this->Measured(report);
  EXPECT_EQ(basetest::CountOf(ReadFileBytes(path), "Algorithm Name"), 1U);
  EXPECT_EQ(basetest::CountOf(ReadFileBytes(path), "Diameter: measured by Shapeton Test 1.0"), 1U);
}

TEST_F(DicomReport, IdentifiesPrivateCodesOnly)
{
  DicomMeasurementReport report = ReportWithTwoGroups();
  this->Measured(report);
  EXPECT_FALSE(Loaded(path).getDataset()->tagExists(DCM_CodingSchemeIdentificationSequence));
  report.groups[0].finding = { "X", "99SHAPETON", "Something" };
  report.groups[1].finding = report.groups[0].finding;
  DcmFileFormat        file = this->Measured(report);
  DcmSequenceOfItems * schemes = nullptr;
  ASSERT_TRUE(file.getDataset()->findAndGetSequence(DCM_CodingSchemeIdentificationSequence, schemes).good());
  EXPECT_EQ(schemes->card(), 1u);
  EXPECT_EQ(ValueOf(file, DCM_CodingSchemeResponsibleOrganization), "Shapeton");
}

TEST_F(DicomReport, HasTheCurrentDateOfItsTimeZoneOnRequest)
{
  source = SourceOf(ObliqueFixture(), folder, "+1400");
  DicomResultHeader header = HeaderOfTest();
  header.dates = DicomResultDates::Now;
  const std::time_t before = std::time(nullptr);
  WriteDicomMeasurements(source, ReportWithTwoGroups(), header, path);
  const std::time_t after = std::time(nullptr);
  DcmFileFormat     file = Loaded(path);
  EXPECT_EQ(ValueOf(file, DCM_StudyDate), "20010203");
  EXPECT_EQ(ValueOf(file, DCM_TimezoneOffsetFromUTC), "+1400");
  std::tm parts{};
  std::istringstream(ValueOf(file, DCM_ContentDate) + ValueOf(file, DCM_ContentTime)) >>
    std::get_time(&parts, "%Y%m%d%H%M%S");
  const std::time_t stated = timegm(&parts) - 14 * 3600;
  EXPECT_LE(before, stated);
  EXPECT_LE(stated, after);
  EXPECT_EQ(ValueOf(file, DCM_InstanceCreationDate), ValueOf(file, DCM_ContentDate));
}

TEST_F(DicomReport, RefusesInvalidPersonNames)
{
  for (const std::string & name : { std::string("Family^Given"), std::string("anonymous"), std::string(64, 'x') })
  {
    EXPECT_NO_THROW(RequireDicomPersonName("observer", name)) << name;
  }
  for (const std::string & name : { std::string(),
                                    std::string(65, 'x'),
                                    std::string("a\\b"),
                                    std::string("a=b"),
                                    std::string("a\nb"),
                                    std::string("\xFF"),
                                    std::string("1^2^3^4^5^6") })
  {
    EXPECT_THROW(RequireDicomPersonName("observer", name), ParameterError) << name;
  }
}

TEST_F(DicomReport, RefusesPointsOfAnotherPlace)
{
  this->Measured();
  DicomSource other = source;
  other.series.frameOfReferenceUID = "1.9";
  EXPECT_TRUE(Refuses([&] { ReadDicomReportPoints(path, other); }, "another frame of reference"));
  this->WriteCad({ PixelPointContent("CONTAINS", center, { 0.0, 0.0, 0.0 }, source) });
  for (auto & slice : other.series.slices)
  {
    slice.sopInstanceUID += ".1";
  }
  EXPECT_TRUE(Refuses([&] { ReadDicomReportPoints(path, other); }, "not a slice of the series"));
  EXPECT_TRUE(Refuses([&] { ReadDicomReportPoints(folder + "/im0001.dcm", source); }, "is of the kind"));
  this->WriteCad({});
  EXPECT_TRUE(Refuses([&] { ReadDicomReportPoints(path, source); }, "contains no points"));
}

TEST_F(DicomReport, RefusesGraphicsThatAreNone)
{
  const auto read = [&](const std::function<void(DcmItem &)> & change) {
    this->WriteCad({ PixelPointContent("CONTAINS", center, { 0.0, 0.0, 0.0 }, source) });
    DcmFileFormat file = Loaded(path);
    DcmItem *     item = nullptr;
    EXPECT_TRUE(file.getDataset()->findAndGetSequenceItem(DCM_ContentSequence, item, -1).good());
    change(*item);
    SaveDicom(file, path);
    return ReadDicomReportPoints(path, source).front().places.size();
  };
  const auto refuses = [&](const std::function<void(DcmItem &)> & change, const std::string & words) {
    return Refuses([&] { read(change); }, words);
  };
  const auto graphic = [](const char * type, std::vector<Float32> values) {
    return [type, values](DcmItem & item) {
      item.putAndInsertString(DCM_GraphicType, type);
      item.putAndInsertFloat32Array(DCM_GraphicData, values.data(), static_cast<unsigned long>(values.size()));
    };
  };
  EXPECT_EQ(read(graphic("POINT", { 1, 1 })), 1u);
  EXPECT_EQ(read(graphic("POLYLINE", { 1, 1, 2, 2, 3, 3 })), 3u);
  EXPECT_TRUE(refuses(graphic("POINT", { 1, 1, 2, 2 }), "invalid coordinates of a POINT"));
  EXPECT_TRUE(refuses(graphic("ELLIPSE", { 1, 1, 2, 2 }), "invalid coordinates of a ELLIPSE"));
  EXPECT_TRUE(refuses(graphic("FOO", { 1, 1 }), "invalid coordinates of a FOO"));
  EXPECT_TRUE(refuses(graphic("POINT", { 5000, 1 }), "outside their image"));
  EXPECT_TRUE(refuses(graphic("POINT", { 1, -1 }), "outside their image"));
  EXPECT_TRUE(refuses([](DcmItem & item) { item.findAndDeleteElement(DCM_ContentSequence); }, "reference no image"));
  EXPECT_TRUE(refuses(
    [](DcmItem & item) {
      DcmItem * image = nullptr;
      DcmItem * reference = nullptr;
      item.findAndGetSequenceItem(DCM_ContentSequence, image, 0);
      image->findAndGetSequenceItem(DCM_ReferencedSOPSequence, reference, 0);
      reference->putAndInsertString(DCM_ReferencedFrameNumber, "2");
    },
    "not a slice of the series"));
  EXPECT_TRUE(refuses(
    [](DcmItem & item) {
      DcmItem * image = nullptr;
      item.findAndGetSequenceItem(DCM_ContentSequence, image, 0);
      auto * const second = new DcmItem(*image);
      item.insertSequenceItem(DCM_ContentSequence, second);
    },
    "or more than one"));
}
