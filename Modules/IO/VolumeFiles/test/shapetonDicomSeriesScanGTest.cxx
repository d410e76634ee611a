#include "shapetonDicomSeriesListing.h"
#include "shapetonDicomSeriesScan.h"
#include "shapetonJson.h"
#include "shapetonVolumeTesting.h"

#include <filesystem>

namespace
{
using shapeton::DicomDefectKind;
using shapeton::DicomFixture;
using shapeton::DicomScan;
using shapeton::DicomSeries;
namespace fs = std::filesystem;

/** The defects of the only series in a folder of WriteFaultyInputs. */
std::vector<std::string>
DefectNames(const DicomSeries & series)
{
  std::vector<std::string> names;
  for (const auto & defect : series.defects)
  {
    names.emplace_back(shapeton::GetDicomDefectName(defect.kind));
    EXPECT_FALSE(defect.message.empty());
    EXPECT_FALSE(defect.files.empty());
    EXPECT_FALSE(defect.slices.empty());
  }
  return names;
}

const std::string &
Faults()
{
  static const std::string folder = [] {
    const std::string path =
      std::string(SHAPETON_TEST_TEMPORARY_DIR) + "/DicomSeries/ScanFaults" + std::to_string(getpid());
    shapeton::WriteFaultyInputs(path);
    return path;
  }();
  return folder;
}

class DicomSeriesScan : public ::testing::Test
{
protected:
  static void
  TearDownTestSuite()
  {
    fs::remove_all(Faults());
  }
};
} // namespace

TEST_F(DicomSeriesScan, RegularSeries)
{
  const DicomScan scan = shapeton::ScanDicom(Faults() + "/regular");
  ASSERT_EQ(scan.series.size(), 1u);
  const DicomSeries & series = scan.series[0];
  EXPECT_TRUE(series.IsUsable());
  EXPECT_EQ(series.modality, "CT");
  EXPECT_EQ(series.description, "FIXTURE");
  EXPECT_EQ(series.patientPosition, "HFS");
  EXPECT_EQ(series.transferSyntax, "Little Endian Explicit");
  EXPECT_EQ(series.size[0], 7u);
  EXPECT_EQ(series.size[1], 9u);
  EXPECT_EQ(series.size[2], 6u);
  EXPECT_DOUBLE_EQ(series.spacing[0], 0.75); // column spacing, the second number of Pixel Spacing
  EXPECT_DOUBLE_EQ(series.spacing[1], 1.25);
  EXPECT_DOUBLE_EQ(series.spacing[2], 2.0); // from positions; thickness and spacing in the header are 6 and 10
  EXPECT_EQ(series.GetSelector(), series.uid);
}

TEST_F(DicomSeriesScan, EachFaultHasItsName)
{
  for (const std::string name : { "gap",
                                  "duplicateIdentical",
                                  "duplicateConflicting",
                                  "variableSpacing",
                                  "shear",
                                  "localizer",
                                  "truncated",
                                  "unsupportedTransferSyntax" })
  {
    const DicomScan scan = shapeton::ScanDicom(Faults() + "/" + name);
    ASSERT_EQ(scan.series.size(), 1u) << name;
    EXPECT_EQ(DefectNames(scan.series[0]), std::vector<std::string>{ name });
    EXPECT_FALSE(scan.series[0].IsUsable()) << name;
  }
}

TEST_F(DicomSeriesScan, TheSlicesConcernedAreNamed)
{
  const DicomScan gap = shapeton::ScanDicom(Faults() + "/gap");
  EXPECT_EQ(gap.series[0].defects[0].slices, (std::vector<unsigned int>{ 2, 3 }));
  EXPECT_EQ(gap.series[0].defects[0].message,
            "2 slices are missing between slice 2 (im0002.dcm) and slice 3 (im0003.dcm)");
  const DicomScan duplicate = shapeton::ScanDicom(Faults() + "/duplicateConflicting");
  EXPECT_EQ(duplicate.series[0].defects[0].slices, (std::vector<unsigned int>{ 3, 4 }));
  const DicomScan truncated = shapeton::ScanDicom(Faults() + "/truncated");
  ASSERT_EQ(truncated.series[0].defects[0].files.size(), 1u);
  EXPECT_EQ(fs::path(truncated.series[0].defects[0].files[0]).filename(), "im0003.dcm");
}

TEST_F(DicomSeriesScan, MixedSeriesHasNumberedParts)
{
  const DicomScan scan = shapeton::ScanDicom(Faults() + "/mixedSeries");
  ASSERT_EQ(scan.series.size(), 2u);
  for (unsigned int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(DefectNames(scan.series[i]), std::vector<std::string>{ "mixedSeries" });
    EXPECT_EQ(scan.series[i].GetSelector(), scan.series[i].uid + "#" + std::to_string(i + 1));
  }
}

TEST_F(DicomSeriesScan, EquidistantSlicesOfSeveralFramesAreOneVolumeWithARemark)
{
  const DicomScan scan = shapeton::ScanDicom(Faults() + "/mixedFrameOfReference");
  ASSERT_EQ(scan.series.size(), 1u);
  EXPECT_TRUE(scan.series[0].IsUsable());
  EXPECT_EQ(scan.series[0].slices.size(), 6u);
  ASSERT_EQ(scan.series[0].remarks.size(), 1u);
  EXPECT_EQ(scan.series[0].remarks[0].kind, DicomDefectKind::mixedFrameOfReference);
  EXPECT_EQ(scan.series[0].remarks[0].slices.size(), 6u);
}

TEST_F(DicomSeriesScan, PatientsAndPositionsInOneSeriesStayApart)
{
  const auto scan = [](const DcmTagKey & tag, const std::string & first, const std::string & second) {
    const std::string folder = shapeton::TestFolder() + "/" + first + second;
    const auto        files = DicomFixture().MakeSeries();
    const auto        others = DicomFixture().MakeSeries();
    for (std::size_t i = 0; i < files.size(); ++i)
    {
      shapeton::SetText(*files[i], tag, first);
      shapeton::SetText(*others[i], tag, second);
    }
    shapeton::SaveDicom(files, shapeton::MakeFolder(folder));
    shapeton::SaveDicom(others, folder, EXS_LittleEndianExplicit, "other");
    return shapeton::ScanDicom(folder);
  };
  for (const DicomScan & apart : { scan(DCM_PatientPosition, "HFS", "HFP"), scan(DCM_PatientID, "A", "B") })
  {
    ASSERT_EQ(apart.series.size(), 2U);
    EXPECT_EQ(DefectNames(apart.series[0]), std::vector<std::string>{ "mixedSeries" });
    EXPECT_EQ(apart.series[0].slices.size(), DicomFixture().slices);
  }
  const DicomScan together = scan(DCM_PatientPosition, "HFS", "");
  ASSERT_EQ(together.series.size(), 1U);
  EXPECT_TRUE(together.series[0].Has(DicomDefectKind::duplicateIdentical));
}

TEST_F(DicomSeriesScan, EquidistantSlicesOfSeveralPatientsAreOneVolumeWithARemark)
{
  const auto files = DicomFixture().MakeSeries();
  shapeton::SetText(files, DCM_PatientID, [&](std::size_t i) { return "ANON" + std::to_string(i / 2); });
  const DicomScan scan = shapeton::ScanOf(files);
  ASSERT_EQ(scan.series.size(), 1U);
  EXPECT_TRUE(scan.series[0].IsUsable());
  ASSERT_EQ(scan.series[0].remarks.size(), 1U);
  EXPECT_EQ(scan.series[0].remarks[0].kind, DicomDefectKind::mixedPatient);
  EXPECT_NE(scan.series[0].remarks[0].message.find("3 patients"), std::string::npos);
  EXPECT_EQ(scan.series[0].remarks[0].message.find("ANON"), std::string::npos);
}

TEST_F(DicomSeriesScan, FramesStayApartWhereTheirSlicesAreNotEquidistantOrNotOfOneStudy)
{
  EXPECT_EQ(shapeton::ScanDicom(Faults() + "/framesApart").series.size(), 5u);
  const std::string folder = shapeton::TestFolder();
  auto              files = DicomFixture().MakeSeries();
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    shapeton::SetText(*files[i], DCM_FrameOfReferenceUID, "1.2.3." + std::to_string(i + 1));
    shapeton::SetText(*files[i], DCM_StudyInstanceUID, i < 3 ? "1.2.4.1" : "1.2.4.2");
  }
  shapeton::SaveDicom(files, folder);
  EXPECT_EQ(shapeton::ScanDicom(folder).series.size(), 6u);
}

TEST_F(DicomSeriesScan, TwoVolumesInTwoFramesAreMixedEvenWhereTheirSlicesInterleave)
{
  DicomFixture fixture;
  auto         files = fixture.MakeSeries();
  shapeton::SetText(files, DCM_FrameOfReferenceUID, [&](std::size_t i) { return i % 2 == 0 ? "1.2.3.1" : "1.2.3.2"; });
  const DicomScan scan = shapeton::ScanOf(files);
  ASSERT_EQ(scan.series.size(), 2u);
  EXPECT_TRUE(scan.series[0].Has(DicomDefectKind::mixedSeries));
  EXPECT_EQ(scan.series[0].slices.size(), 3u);
}

TEST_F(DicomSeriesScan, FilesWithoutAnImage)
{
  const DicomScan text = shapeton::ScanDicom(Faults() + "/text");
  EXPECT_TRUE(text.series.empty());
  ASSERT_EQ(text.otherFiles.size(), 2u);
  EXPECT_EQ(text.otherFiles[0].kind, DicomDefectKind::notAnImage);
  const DicomScan cut = shapeton::ScanDicom(Faults() + "/truncatedHeader");
  ASSERT_EQ(cut.otherFiles.size(), 1u);
  EXPECT_EQ(cut.otherFiles[0].kind, DicomDefectKind::truncated);
}

TEST_F(DicomSeriesScan, ColorAnd2DImagesAreNoVolumes)
{
  for (const std::string name : { "color", "twoDimensional", "single" })
  {
    const DicomScan scan = shapeton::ScanDicom(Faults() + "/" + name);
    ASSERT_EQ(scan.series.size(), 1u) << name;
    EXPECT_FALSE(scan.series[0].IsUsable()) << name;
    EXPECT_FALSE(scan.series[0].refusal.empty()) << name;
  }
}

TEST_F(DicomSeriesScan, MissingAndEmptyFolders)
{
  EXPECT_TRUE(
    shapeton::Contains(shapeton::InputErrorOf([] { shapeton::ScanDicom("/nowhere/at/all"); }), "does not exist"));
  EXPECT_TRUE(shapeton::Contains(shapeton::InputErrorOf([] { shapeton::ScanDicom(Faults() + "/empty"); }), "empty"));
}

TEST_F(DicomSeriesScan, AcquisitionsAtTheSamePositionsAreSeparated)
{
  const std::string folder = shapeton::TestFolder();
  DicomFixture      fixture;
  auto              first = fixture.MakeSeries();
  auto              second = fixture.MakeSeries();
  shapeton::SetText(second, DCM_AcquisitionNumber, "2");
  shapeton::SaveDicom(first, folder, EXS_LittleEndianExplicit, "a");
  shapeton::SaveDicom(second, folder, EXS_LittleEndianExplicit, "b");
  const DicomScan scan = shapeton::ScanDicom(folder);
  ASSERT_EQ(scan.series.size(), 2u);
  EXPECT_TRUE(scan.series[0].Has(DicomDefectKind::mixedSeries));
  EXPECT_EQ(scan.series[0].slices.size(), 6u);
  EXPECT_EQ(scan.series[1].slices.size(), 6u);
}

TEST_F(DicomSeriesScan, AcquisitionNumbersOfTheStepsOfOneScanAreNot)
{
  DicomFixture fixture;
  auto         files = fixture.MakeSeries();
  shapeton::SetText(files, DCM_AcquisitionNumber, [&](std::size_t i) { return std::to_string(i / 2); });
  const DicomScan scan = shapeton::ScanOf(files);
  ASSERT_EQ(scan.series.size(), 1u);
  EXPECT_TRUE(scan.series[0].IsUsable());
}

TEST_F(DicomSeriesScan, BlocksOfOneScanThatShareASliceAreADuplicate)
{
  DicomFixture fixture;
  auto         files = fixture.MakeSeries();
  files.push_back(fixture.MakeSlice(fixture.SlicePosition(2 * fixture.sliceSpacing), 7));
  shapeton::SetText(files, DCM_AcquisitionNumber, [&](std::size_t i) {
    return i < 3 ? "1" : "2";
  }); // 0 2 4 and 4 6 8 10 mm, each regular
  const DicomScan scan = shapeton::ScanOf(files);
  ASSERT_EQ(scan.series.size(), 1u);
  EXPECT_EQ(DefectNames(scan.series[0]), std::vector<std::string>{ "duplicateIdentical" });
}

TEST_F(DicomSeriesScan, SymbolicLinksAreFollowedOnce)
{
  const std::string folder = shapeton::TestFolder();
  fs::create_directories(folder + "/deep/er");
  shapeton::SaveDicom(DicomFixture().MakeSeries(), folder + "/deep/er");
  fs::create_directory_symlink(folder, folder + "/deep/loop");
  fs::create_symlink(folder + "/deep/er/im0001.dcm", folder + "/again.dcm");
  fs::create_symlink(folder + "/gone", folder + "/dangling");
  const DicomScan scan = shapeton::ScanDicom(folder);
  EXPECT_EQ(scan.files, 6u);
  ASSERT_EQ(scan.series.size(), 1u);
  EXPECT_TRUE(scan.series[0].IsUsable());
}

TEST_F(DicomSeriesScan, ListingsHoldWhatTheScanFound)
{
  const DicomScan   scan = shapeton::ScanDicom(Faults() + "/gap");
  const std::string text = shapeton::FormatDicomScan(scan);
  for (const std::string part :
       { "FIXTURE", "CT", "axial", "7 x 9 x 4", "0.75 x 1.25 x 2", "HFS", "no: gap", "the parameter \"resampleGaps\"" })
  {
    EXPECT_TRUE(shapeton::Contains(text, part)) << part << "\n" << text;
  }
  const auto asOption = [](const std::string &) { return std::string("--option"); };
  EXPECT_TRUE(shapeton::Contains(shapeton::FormatDicomScan(scan, asOption), "(im0003.dcm); --option\n"));
  const std::string path = shapeton::TestFolder() + "/listing.json";
  shapeton::WriteDicomScan(scan, path);
  const shapeton::Json json = shapeton::ReadJson(path);
  EXPECT_EQ(json["schema"], "shapeton.dicomSeries.1");
  ASSERT_EQ(json["series"].size(), 1u);
  const shapeton::Json & series = json["series"][0];
  EXPECT_EQ(series["usable"], false);
  EXPECT_EQ(series["size"], (std::vector<int>{ 7, 9, 4 }));
  EXPECT_EQ(series["spacing"], (std::vector<double>{ 0.75, 1.25, 2.0 }));
  EXPECT_EQ(series["origin"], (std::vector<double>{ -3.5, 12.25, -20.0 }));
  EXPECT_EQ(series["defects"][0]["name"], "gap");
  EXPECT_EQ(series["defects"][0]["files"], (std::vector<std::string>{ "im0002.dcm", "im0003.dcm" }));
  EXPECT_EQ(series["slices"][3]["position"], 10.0);
}
