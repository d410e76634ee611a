// Series in the style of other programs: variants permitted by the standard, and violations found in practice.
#include "shapetonDicomSeriesListing.h"
#include "shapetonPrintable.h"
#include "shapetonVolumeTesting.h"

#include <cstdint>
#include <filesystem>
#include <fstream>

namespace
{
using shapeton::Contains;
using shapeton::DicomDefectKind;
using shapeton::DicomFixture;
using shapeton::DicomScan;
using shapeton::InputErrorOf;
using shapeton::ReadVolume;
using shapeton::SaveDicom;
using shapeton::ScanOf;
using shapeton::SetText;
using shapeton::TestFolder;
using shapeton::VolumeReadOptions;

// Half a step of the stored integers, and rounding to float.
constexpr double RoundingError = 0.5 / 32 + 1e-4;

VolumeReadOptions
AllRepairs()
{
  VolumeReadOptions options;
  options.resampleGaps = options.deshear = options.dropDuplicates = options.allowSingleSlice = true;
  return options;
}
} // namespace

// ---- VR UN ----

TEST(DicomOfOtherPrograms, AttributesWithUnknownRepresentationAreDecoded)
{
  for (const auto syntax : { EXS_LittleEndianExplicit, EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit })
  {
    const std::string folder = TestFolder();
    auto              files = DicomFixture().MakeSeries();
    for (const auto & file : files)
    {
      shapeton::StoreAllAsUnknown(*file->getDataset());
    }
    SaveDicom(files, folder, syntax);
    const auto scan = shapeton::ScanDicom(folder);
    ASSERT_EQ(scan.series.size(), 1U) << syntax;
    EXPECT_EQ(scan.series[0].description, "FIXTURE");
    EXPECT_LT(LargestDeviation(ReadVolume(folder), DicomFixture::Ramp), RoundingError) << syntax;
  }
}

TEST(DicomOfOtherPrograms, AttributesWithUnknownRepresentationAreDecodedWithinSequences)
{
  const std::vector<DcmTagKey> groups{ DCM_SharedFunctionalGroupsSequence, DCM_PerFrameFunctionalGroupsSequence };
  for (const bool isWhole : { true, false })
  {
    for (const auto syntax : { EXS_LittleEndianExplicit, EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit })
    {
      const std::string folder = TestFolder();
      const auto        file = DicomFixture().MakeEnhanced({ 6, 0, 4, 2 });
      if (isWhole)
      {
        shapeton::StoreAsUnknown(*file->getDataset(), groups);
      }
      for (signed long i = 0; i < 4 && !isWhole; ++i)
      {
        DcmItem * frame = nullptr;
        DcmItem * plane = nullptr;
        ASSERT_TRUE(file->getDataset()->findAndGetSequenceItem(groups[1], frame, i).good());
        ASSERT_TRUE(frame->findAndGetSequenceItem(DCM_PlanePositionSequence, plane).good());
        shapeton::StoreAsUnknown(*plane, { DCM_ImagePositionPatient });
        shapeton::StoreAsUnknown(*frame, { DCM_PixelValueTransformationSequence });
      }
      SaveDicom(*file, folder + "/multi.dcm", syntax);
      EXPECT_LT(LargestDeviation(ReadVolume(folder), DicomFixture::Ramp), RoundingError) << syntax << isWhole;
    }
  }
}

// ---- images that are not slices ----

namespace
{
const std::string tileCounter = "SIEMENS MR HEADER";
const std::string csaOwner = "SIEMENS CSA HEADER";
} // namespace

TEST(DicomOfOtherPrograms, ASiemensMosaicWithoutItsNormalIsRefusedByName)
{
  using Change = std::function<void(DcmFileFormat &)>;
  const std::vector<Change> changes{
    [](DcmFileFormat & file) { SetText(file, DCM_ImageType, "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC"); },
    [](DcmFileFormat & file) {
      shapeton::AddPrivate(*file.getDataset(), 0x19, tileCounter, 0x0A, std::string("\x23\0", 2));
    },
    [](DcmFileFormat & file) {
      shapeton::AddPrivate(
        *file.getDataset(), 0x29, csaOwner, 0x10, shapeton::CsaHeader({ { "NumberOfImagesInMosaic", { "35" } } }));
    }
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const std::string folder = TestFolder();
    auto              files = DicomFixture().MakeSeries();
    files.push_back(DicomFixture().MakeSlice(DicomFixture().origin, 7)); // a second slice at one position
    for (const auto & file : files)
    {
      changes[i](*file);
    }
    const DicomScan scan = ScanOf(files, folder);
    ASSERT_EQ(scan.series.size(), 1U) << i;
    EXPECT_FALSE(scan.series[0].IsUsable()) << i;
    EXPECT_TRUE(Contains(shapeton::FormatDicomScan(scan), "no: a Siemens mosaic")) << i;
    for (const std::string & path : { folder, folder + "/im0001.dcm" })
    {
      EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(path, AllRepairs()); }), "a Siemens mosaic")) << path << i;
    }
  }
}

TEST(DicomOfOtherPrograms, ASiemensMosaicIsAVolume)
{
  DicomFixture fixture;
  fixture.direction = DicomFixture::ObliqueDirection();
  fixture.sliceSpacing = 2.5;
  for (const bool isAscending : { true, false })
  {
    const std::string path = TestFolder() + "/mosaic.dcm";
    SaveDicom(*fixture.MakeMosaic(isAscending), path);
    for (const std::string syntax : { "", "1.2.840.10008.1.2.5" }) // RLE
    {
      if (!syntax.empty())
      {
        shapeton::CompressDicom(path, syntax);
      }
      const shapeton::Volume volume = ReadVolume(path);
      EXPECT_EQ(volume.image->GetLargestPossibleRegion().GetSize(), (itk::Size<3>{ { 7, 9, 6 } }));
      EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), RoundingError) << isAscending << syntax;
    }
  }
}

TEST(DicomOfOtherPrograms, MosaicsOfATimeSeriesAreParts)
{
  DicomFixture fixture;
  fixture.sliceSpacing = 2.5;
  DicomFixture::Files files;
  for (const std::string number : { "1", "2" })
  {
    files.push_back(fixture.MakeMosaic(true));
    SetText(*files.back(), DCM_AcquisitionNumber, number);
    SetText(*files.back(), DCM_SOPInstanceUID, "1.2.3." + number);
  }
  const auto scan = ScanOf(files);
  ASSERT_EQ(scan.series.size(), 2U);
  EXPECT_TRUE(scan.series[0].Has(DicomDefectKind::mixedSeries));
  EXPECT_EQ(scan.series[0].size[2], fixture.slices);
}

TEST(DicomOfOtherPrograms, ExactCopiesAreUsedOnce)
{
  const std::string folder = TestFolder();
  SaveDicom(DicomFixture().MakeSeries(), folder);
  std::filesystem::create_directory(folder + "/copies");
  std::filesystem::copy_file(folder + "/im0001.dcm", folder + "/copies/a.dcm");
  std::filesystem::copy_file(folder + "/im0004.dcm", folder + "/copies/b.dcm");
  const auto scan = shapeton::ScanDicom(folder);
  ASSERT_EQ(scan.series.size(), 1U);
  EXPECT_TRUE(scan.series[0].IsUsable());
  ASSERT_EQ(scan.series[0].remarks.size(), 1U);
  EXPECT_EQ(scan.series[0].remarks[0].kind, DicomDefectKind::copiedFile);
  EXPECT_EQ(scan.series[0].remarks[0].files.size(), 2U);
  const shapeton::Volume volume = ReadVolume(folder);
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), RoundingError);
  ASSERT_EQ(volume.notes.size(), 1U);
  EXPECT_TRUE(Contains(volume.notes[0], "2 files are exact copies of others and not used")) << volume.notes[0];
}

TEST(DicomOfOtherPrograms, SlicesWithASeriesUidEachAreNoVolume)
{
  auto files = DicomFixture().MakeSeries();
  SetText(files, DCM_SeriesInstanceUID, [](std::size_t i) { return "1.2.3." + std::to_string(i + 1); });
  const std::string folder = TestFolder();
  SaveDicom(files, folder);
  for (const auto & options : { VolumeReadOptions(), AllRepairs() })
  {
    const auto error = InputErrorOf([&] { ReadVolume(folder, options); });
    EXPECT_TRUE(Contains(error, "6 series of one slice each")) << error;
    EXPECT_TRUE(Contains(error, "they share study, frame of reference and description")) << error;
  }
}

TEST(DicomOfOtherPrograms, AWrongLengthOfTheFileMetaInformationIsIgnored)
{
  for (const int change : { -200, -3, 1, 100, 1'000'000 })
  {
    for (const auto syntax : { EXS_LittleEndianExplicit, EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit })
    {
      const std::string folder = TestFolder();
      SaveDicom(DicomFixture().MakeSeries(), folder, syntax);
      for (const auto & entry : std::filesystem::directory_iterator(folder))
      {
        constexpr std::streamoff place = 140; // of the length, after the preamble and the header of its attribute
        std::fstream             file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
        std::int32_t             length = 0;
        file.seekg(place).read(reinterpret_cast<char *>(&length), sizeof(length));
        length += change;
        file.seekp(place).write(reinterpret_cast<const char *>(&length), sizeof(length));
      }
      EXPECT_LT(LargestDeviation(ReadVolume(folder), DicomFixture::Ramp), RoundingError) << change << ' ' << syntax;
    }
  }
}

TEST(DicomOfOtherPrograms, FramesOfARefusedImageAreCounted)
{
  const auto file = DicomFixture().MakeSlice(DicomFixture().origin, 1);
  SetText(*file, DCM_NumberOfFrames, "24");
  const std::string folder = TestFolder();
  SaveDicom(*file, folder + "/cine.dcm");
  const auto scan = shapeton::ScanDicom(folder);
  EXPECT_FALSE(scan.series.at(0).refusal.empty());
  EXPECT_EQ(scan.series.at(0).size[2], 24U);
}

TEST(DicomOfOtherPrograms, OtherImagesOfSiemensAreSlices)
{
  auto files = DicomFixture().MakeSeries();
  for (const auto & file : files)
  {
    shapeton::AddPrivate(*file->getDataset(), 0x19, tileCounter, 0x0A, std::string("\1\0", 2));
    shapeton::AddPrivate(
      *file->getDataset(), 0x29, csaOwner, 0x10, shapeton::CsaHeader({ { "NumberOfImagesInMosaic", {} } }));
    shapeton::AddPrivate(*file->getDataset(), 0x21, tileCounter, 0x0A, std::string("\x23\0", 2)); // of another group
  }
  EXPECT_TRUE(ScanOf(files).series.at(0).IsUsable());
}

TEST(DicomOfOtherPrograms, ALabelMapIsNotAnImage)
{
  const std::string folder = TestFolder();
  const auto        file = DicomFixture().MakeLabelMap({ DicomFixture().origin, DicomFixture().SlicePosition(2.0) },
                                                std::vector<Uint16>(std::size_t(2) * 63, 1),
                                                8,
                                                { 1 });
  SaveDicom(*file, folder + "/map.dcm");
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder); }), "a segmentation; read it with DicomResultsToColon"));
  EXPECT_TRUE(Contains(shapeton::FormatDicomScan(shapeton::ScanDicom(folder)), "a segmentation; read it with"));
}

TEST(DicomOfOtherPrograms, AFolderOfOtherObjectsSaysWhatTheyAre)
{
  const std::string folder = TestFolder();
  DcmFileFormat     file;
  SetText(file, DCM_SOPClassUID, UID_RTStructureSetStorage);
  SetText(file, DCM_SOPInstanceUID, "1.2.3");
  SaveDicom(file, folder + "/contours.dcm");
  SaveDicom(file, folder + "/more.dcm");
  const std::string message = InputErrorOf([&] { ReadVolume(folder); });
  EXPECT_TRUE(Contains(message, "2 RTStructureSetStorage")) << message;
  EXPECT_TRUE(Contains(message, "contains only contours; use the folder with the image series")) << message;
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder + "/more.dcm"); }), "1 RTStructureSetStorage"));
}

TEST(DicomOfOtherPrograms, EncodingsThatAreNotSupportedHaveTheirNames)
{
  for (const auto syntax : { EXS_LittleEndianExplicit, EXS_RLELossless }) // native, and in fragments
  {
    const std::string folder = TestFolder();
    SaveDicom(DicomFixture().MakeSeries(), folder, syntax);
    for (int i = 1; i <= 6; ++i)
    {
      shapeton::StateTransferSyntax(folder + "/im000" + std::to_string(i) + ".dcm", "1.2.840.10008.1.2.4.110");
    }
    const std::string message = InputErrorOf([&] { ReadVolume(folder); });
    EXPECT_TRUE(Contains(message, "the encoding JPEG XL Lossless (1.2.840.10008.1.2.4.110)")) << message;
  }
}

// ---- interleaved reconstructions ----

namespace
{
/** 8 slices with 2 mm spacing; each attribute is a function of the slice number. */
DicomFixture::Files
SlicesWith(const DcmTagKey & tag, const std::function<std::string(unsigned int)> & value)
{
  DicomFixture fixture;
  fixture.slices = 8;
  auto files = fixture.MakeSeries();
  SetText(files, tag, [&](std::size_t i) { return value(i); });
  return files;
}

const std::vector<std::pair<DcmTagKey, std::vector<std::string>>> &
Alternatives()
{
  static const std::vector<std::pair<DcmTagKey, std::vector<std::string>>> list{
    { DCM_ConvolutionKernel, { "B30f", "B70f" } },
    { DCM_AcquisitionNumber, { "1", "2" } },
    { DCM_FilterType, { "A", "B" } },
    { DCM_ReconstructionDiameter, { "300", "350" } },
    { DCM_SliceThickness, { "1.25", "5" } },
    { DCM_KVP, { "80", "140" } },
    { DCM_ImageType, { "ORIGINAL\\PRIMARY\\AXIAL", "DERIVED\\SECONDARY\\AXIAL" } },
    { DCM_EchoTime, { "10", "20" } },
    { DCM_SeriesDescription, { "SOFT", "LUNG" } }
  };
  return list;
}
} // namespace

TEST(DicomOfOtherPrograms, InterleavedReconstructionsAreTwoVolumesToChooseFrom)
{
  for (const auto & one : Alternatives())
  {
    const std::string folder = TestFolder();
    const DicomScan   scan = ScanOf(SlicesWith(one.first, [&](unsigned int i) { return one.second[i % 2]; }), folder);
    ASSERT_EQ(scan.series.size(), 2U) << one.first;
    VolumeReadOptions options;
    for (const auto & series : scan.series)
    {
      EXPECT_TRUE(series.Has(DicomDefectKind::mixedSeries)) << one.first;
      EXPECT_EQ(series.slices.size(), 4U);
      EXPECT_DOUBLE_EQ(series.spacing[2], 4.0);
      EXPECT_TRUE(Contains(series.distinction, DcmTag(one.first).getTagName())) << series.distinction;
      options.seriesUID = series.GetSelector();
      EXPECT_LT(LargestDeviation(ReadVolume(folder, options), DicomFixture::Ramp), RoundingError);
    }
    EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder, AllRepairs()); }), scan.series[1].distinction));
  }
}

TEST(DicomOfOtherPrograms, ThreeAndFourInterleavedReconstructionsComeApartToo)
{
  const auto kernel = [](unsigned int i) { return std::string(1, static_cast<char>('A' + i % 2)); };
  auto       files = SlicesWith(DCM_ConvolutionKernel, kernel); // A B A B ...
  SetText(files, DCM_AcquisitionNumber, [&](std::size_t i) {
    return i % 4 < 2 ? "1" : "2";
  }); // 1 1 2 2 ...: not a regular grid
  EXPECT_EQ(ScanOf(files).series.size(), 4U);
  SetText(files, DCM_ConvolutionKernel, [&](std::size_t i) {
    return i % 4 == 0 || i % 4 == 3 ? "A" : "B";
  }); // neither is a regular grid
  EXPECT_EQ(ScanOf(files).series.size(), 4U);
  DicomFixture fixture;
  fixture.slices = 9;
  files = fixture.MakeSeries();
  SetText(files, DCM_ConvolutionKernel, [&](std::size_t i) { return std::string(1, static_cast<char>('A' + i % 3)); });
  files.erase(files.begin() + 4); // one of them has a gap
  EXPECT_EQ(ScanOf(files).series.size(), 3U);
}

TEST(DicomOfOtherPrograms, AnAttributeThatVariesWithoutInterleavingIsOneVolume)
{
  for (const auto & one : Alternatives())
  {
    const auto halves = [&](unsigned int i) { return one.second[i / 4]; };
    const auto few = [&](unsigned int i) { return one.second[i == 2 || i == 5 ? 1 : 0]; };
    const auto once = [&](unsigned int i) { return one.second[i == 3 ? 1 : 0]; };
    for (const auto & value : { std::function<std::string(unsigned int)>(halves),
                                std::function<std::string(unsigned int)>(few),
                                std::function<std::string(unsigned int)>(once) })
    {
      const DicomScan scan = ScanOf(SlicesWith(one.first, value));
      ASSERT_EQ(scan.series.size(), 1U) << one.first;
      EXPECT_TRUE(scan.series[0].IsUsable()) << one.first;
    }
  }
  const DicomScan scan = ScanOf(SlicesWith(DCM_AcquisitionNumber, [](unsigned int i) { return std::to_string(i); }));
  ASSERT_EQ(scan.series.size(), 1U);
  EXPECT_TRUE(scan.series[0].IsUsable());
}

// ---- numbers ----

TEST(DicomOfOtherPrograms, ANumberWithACommaIsNamedWithItsFileAndAttribute)
{
  for (const DcmTagKey & tag : { DCM_ImagePositionPatient,
                                 DCM_ImageOrientationPatient,
                                 DCM_PixelSpacing,
                                 DCM_SliceThickness,
                                 DCM_RescaleSlope,
                                 DCM_RescaleIntercept })
  {
    for (const bool isOnlyTheLast : { false, true })
    {
      const std::string folder = TestFolder();
      auto              files = DicomFixture().MakeSeries();
      std::string       value;
      for (std::size_t i = isOnlyTheLast ? files.size() - 1 : 0; i < files.size(); ++i)
      {
        OFString text;
        files[i]->getDataset()->findAndGetOFStringArray(tag, text);
        value = text.c_str();
        value = value.find('.') == std::string::npos ? "1,0" + value : value;
        std::replace(value.begin(), value.end(), '.', ',');
        SetText(*files[i], tag, value);
      }
      const DicomScan   scan = ScanOf(files, folder);
      const std::string message = InputErrorOf([&] { ReadVolume(folder, AllRepairs()); });
      for (const std::string & part : { std::string(isOnlyTheLast ? "im0006.dcm" : "im0001.dcm"),
                                        std::string(DcmTag(tag).getTagName()),
                                        std::string("comma instead of a decimal point") })
      {
        EXPECT_TRUE(Contains(message, part)) << message;
      }
      EXPECT_TRUE(!isOnlyTheLast || Contains(message, '"' + value + '"')) << message << value;
      for (const auto & series : scan.series)
      {
        EXPECT_TRUE(series.Has(DicomDefectKind::malformedValue));
      }
    }
  }
}

TEST(DicomOfOtherPrograms, NumbersAreCountedAndCheckedButBlanksAndSignsAreFine)
{
  const auto messageOf = [](const std::string & spacing) {
    auto files = DicomFixture().MakeSeries();
    SetText(files, DCM_PixelSpacing, spacing);
    const DicomScan scan = ScanOf(files);
    return scan.series.at(0).IsUsable() ? std::string() : shapeton::FormatDicomScan(scan);
  };
  EXPECT_EQ(messageOf(" +1.25 \\ 7.5e-1 "), "");
  EXPECT_TRUE(Contains(messageOf("1.25"), "PixelSpacing (0028,0030) is \"1.25\", which is not 2 numbers"));
  EXPECT_TRUE(Contains(messageOf("1.25\\x"), "which is not a decimal number"));
  EXPECT_TRUE(Contains(messageOf("1.25\\nan"), "which is not a decimal number"));
}

// ---- functional groups, character sets, folders ----

TEST(DicomOfOtherPrograms, APlainSliceMayHaveFunctionalGroups)
{
  const std::string folder = TestFolder();
  auto              files = DicomFixture().MakeSeries();
  for (const auto & file : files)
  {
    DcmItem * shared = nullptr;
    ASSERT_TRUE(file->getDataset()->findOrCreateSequenceItem(DCM_SharedFunctionalGroupsSequence, shared, -2).good());
    SetText(*file, DCM_NumberOfFrames, "1");
  }
  const DicomScan scan = ScanOf(files, folder);
  ASSERT_EQ(scan.series.size(), 1U);
  EXPECT_FALSE(scan.series[0].slices[0].isMultiFrame);
  EXPECT_LT(LargestDeviation(ReadVolume(folder), DicomFixture::Ramp), RoundingError);
}

TEST(DicomOfOtherPrograms, TextsInEachCharacterSetAreUtf8)
{
  struct Case
  {
    std::string set;
    std::string bytes;
    std::string expected;
  };
  const std::vector<Case> cases{
    { "ISO_IR 100", "\xfc", "\u00fc" },
    { "ISO_IR 192", "\xc3\xbc", "\u00fc" },
    { "ISO 2022 IR 100", "\xfc", "\u00fc" },
    { "\\ISO 2022 IR 100", "\xfc", "\u00fc" }, // without its escape sequence
    { "\\ISO 2022 IR 100", "\x1b-A\xfc", "\u00fc" },
    { "ISO 2022 IR 101", "\xb3", "\u0142" },
    { "ISO 2022 IR 109", "\xa9", "\u0130" },
    { "ISO 2022 IR 110", "\xb3", "\u0157" },
    { "ISO 2022 IR 144", "\xbb\xee\xda", "\u041b\u044e\u043a" },
    { "\\ISO 2022 IR 144", "\x1b-L\xbb\xee\xda", "\u041b\u044e\u043a" },
    { "ISO 2022 IR 126", "\xc4", "\u0394" },
    { "ISO 2022 IR 127", "\xc7", "\u0627" },
    { "ISO 2022 IR 138", "\xf9", "\u05e9" },
    { "ISO 2022 IR 148", "\xfd", "\u0131" },
    { "ISO 2022 IR 166", "\xb9\xd2", "\u0e19\u0e32" },
    { "ISO_IR 203", "\xa4", "\u20ac" },
    { "ISO_IR 13", "\xd4\xcf\xc0\xde", "\uff94\uff8f\uff80\uff9e" },
    { "\\ISO 2022 IR 87", "Y=\x1b$B;3ED\x1b(B^", "Y=\u5c71\u7530^" }, // PS3.5 H.3.1
    { "ISO 2022 IR 6\\ISO 2022 IR 87", "\x1b$BB@O:\x1b(B", "\u592a\u90ce" },
    { "ISO 2022 IR 87", "\x1b$B;3ED\x1b(B", "\u5c71\u7530" },
    { "ISO 2022 IR 13\\ISO 2022 IR 87", "\xd4\xcf=\x1b$B;3ED\x1b(J", "\uff94\uff8f=\u5c71\u7530" }, // H.3.2
    { "\\ISO 2022 IR 87\\ISO 2022 IR 159", "\x1b$(D\x30\x21\x1b(B\x1b$B;3\x1b(B", "\u4e02\u5c71" },
    { "\\ISO 2022 IR 149", "Hong=\x1b$)C\xfb\xf3", "Hong=\u6d2a" }, // PS3.5 I.2
    { "\\ISO 2022 IR 58", "Zhang=\x1b$)A\xd5\xc5", "Zhang=\u5f20" },
    { "GB18030", "\xcd\xf5", "\u738b" }, // PS3.5 J.4
    { "GBK", "\xcd\xf5", "\u738b" },
    { "ISO_IR_100", "\xfc", "\u00fc" } // a common misspelling
  };
  for (const Case & one : cases)
  {
    auto files = DicomFixture().MakeSeries();
    SetText(files, DCM_SpecificCharacterSet, one.set);
    SetText(files, DCM_SeriesDescription, one.bytes);
    const DicomScan scan = ScanOf(files);
    EXPECT_EQ(scan.series.at(0).description, one.expected) << one.set;
    EXPECT_TRUE(scan.series[0].remarks.empty()) << one.set;
  }
}

TEST(DicomOfOtherPrograms, ATextThatCannotBeDecodedHasARemarkAndIsPrintable)
{
  using Text = std::pair<std::string, std::string>;
  for (const auto & one : { Text{ "ISO_IR 6",
                                  "\xfc"
                                  "ber" },
                            Text{ "ISO_IR 192",
                                  "\xfc"
                                  "ber" },
                            Text{ "UNHEARD OF",
                                  "\xfc"
                                  "ber" },
                            Text{ "\\ISO 2022 IR 87",
                                  "\x1b-A\xfc"
                                  "ber" } })
  {
    const std::string folder = TestFolder();
    auto              files = DicomFixture().MakeSeries();
    for (const auto & file : files)
    {
      SetText(*file, DCM_SpecificCharacterSet, one.first);
      SetText(*file, DCM_SeriesDescription, one.second);
      SetText(*file, DCM_PatientPosition, "\xfc");
    }
    const DicomScan scan = ScanOf(files, folder);
    ASSERT_EQ(scan.series.at(0).remarks.size(), 1U) << one.first;
    EXPECT_EQ(scan.series[0].remarks[0].kind, DicomDefectKind::undecodableText);
    EXPECT_TRUE(scan.series[0].IsUsable());
    EXPECT_TRUE(Contains(scan.series[0].description, "?ber"));
    const std::string listing = shapeton::FormatDicomScan(scan);
    EXPECT_EQ(listing.find('\x1b'), std::string::npos);
    EXPECT_EQ(listing.find('\xfc'), std::string::npos);
    EXPECT_TRUE(Contains(ReadVolume(folder).notes.at(0), "the Series Description contains bytes that are invalid"));
  }
}

TEST(DicomOfOtherPrograms, ARepairIsNotAdvisedWhereItWouldBeRefused)
{
  const DicomFixture fixture;
  const auto         slicesAt = [&](const std::vector<std::pair<double, double>> & places) {
    DicomFixture::Files files;
    for (const auto & place : places)
    {
      files.push_back(
        fixture.MakeSlice(fixture.SlicePosition(place.first, place.second), static_cast<int>(files.size()) + 1));
    }
    return files;
  };
  struct Case
  {
    DicomFixture::Files files;
    std::string         repair;
    bool                isRepairable;
  };
  std::vector<Case> cases;
  cases.push_back({ slicesAt({ { 0, 0 }, { 2, 0 }, { 4, 0 }, { 34, 0 } }), "resampleGaps", true }); // 18 of 4 slices
  cases.push_back({ slicesAt({ { 0, 0 }, { 2, 0 }, { 4, 0 }, { 36, 0 } }), "resampleGaps", false });
  cases.push_back({ slicesAt({ { 0, 0 }, { 2, 0 }, { 4, 0 }, { 35.5, 0 } }), "resampleGaps", false }); // uneven
  cases.push_back({ slicesAt({ { 0, 0 }, { 2, 7 }, { 4, 14 } }), "deshear", true }); // 5.25 mm are 7 columns
  cases.push_back({ slicesAt({ { 0, 0 }, { 2, 9 }, { 4, 18 } }), "deshear", false });
  for (const Case & one : cases)
  {
    const std::string folder = TestFolder();
    const DicomScan   scan = ScanOf(one.files, folder);
    EXPECT_EQ(Contains(shapeton::FormatDicomScan(scan), one.repair), one.isRepairable);
    EXPECT_EQ(Contains(InputErrorOf([&] { ReadVolume(folder); }), one.repair), one.isRepairable);
    if (one.isRepairable)
    {
      EXPECT_NO_THROW(ReadVolume(folder, AllRepairs()));
    }
    else
    {
      EXPECT_THROW(ReadVolume(folder, AllRepairs()), shapeton::InputError);
    }
  }
}

TEST(DicomOfOtherPrograms, WhoHasChosenASeriesHearsOfTheOthersInOneLine)
{
  const std::string folder = TestFolder();
  DicomFixture      fixture;
  for (int i = 0; i < 5; ++i)
  {
    fixture.seriesUID = "1.2.3." + std::to_string(i + 1);
    SaveDicom(fixture.MakeSeries(), folder, EXS_LittleEndianExplicit, "series" + std::to_string(i));
  }
  VolumeReadOptions options;
  options.seriesUID = "1.2.3.2";
  const auto notes = ReadVolume(folder, options).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(Contains(notes[0], "4 other series"));
}
