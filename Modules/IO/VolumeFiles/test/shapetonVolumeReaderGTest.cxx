#include "shapetonDicomAttributes.h"
#include "shapetonVolumeTesting.h"

#include "shapetonDicomSeriesScan.h"
#include "shapetonProgressTests.h"
#include "shapetonTestImages.h"

#include <filesystem>
#include <sys/stat.h>

namespace
{
using shapeton::Contains;
using shapeton::DicomFixture;
using shapeton::InputErrorOf;
using shapeton::LargestDeviation;
using shapeton::ReadVolume;
using shapeton::SaveDicom;
using shapeton::SetText;
using shapeton::TestFolder;
using shapeton::Volume;
using shapeton::VolumeReadOptions;
namespace fs = std::filesystem;

// Half a step of the stored integers, and rounding to float.
constexpr double Quantization = 0.5 / 32 + 1e-4;

Volume
ReadSaved(const DicomFixture::Files & files, const VolumeReadOptions & options = {})
{
  const std::string folder = TestFolder();
  SaveDicom(files, folder);
  return ReadVolume(folder, options);
}

std::string
RefusalOf(const DicomFixture::Files & files)
{
  const std::string folder = TestFolder();
  SaveDicom(files, folder);
  return InputErrorOf([&folder] { ReadVolume(folder); });
}

DicomFixture::Files
SlicesAt(const DicomFixture & fixture, const std::vector<double> & distances)
{
  DicomFixture::Files files;
  for (const double distance : distances)
  {
    files.push_back(fixture.MakeSlice(fixture.SlicePosition(distance), static_cast<int>(files.size()) + 1));
  }
  return files;
}

void
ExpectSize(const Volume & volume, std::size_t x, std::size_t y, std::size_t z)
{
  const auto size = volume.image->GetLargestPossibleRegion().GetSize();
  EXPECT_EQ(size[0], x);
  EXPECT_EQ(size[1], y);
  EXPECT_EQ(size[2], z);
}
} // namespace

TEST(VolumeReader, GeometryIntensitiesAndIdentity)
{
  const DicomFixture fixture;
  const Volume       volume = ReadSaved(fixture.MakeSeries());
  ExpectSize(volume, 7, 9, 6);
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
  EXPECT_DOUBLE_EQ(volume.image->GetSpacing()[0], 0.75);
  EXPECT_DOUBLE_EQ(volume.image->GetSpacing()[1], 1.25);
  EXPECT_DOUBLE_EQ(volume.image->GetSpacing()[2], 2.0);
  EXPECT_EQ(volume.modality, "CT");
  EXPECT_EQ(volume.patientPosition, "HFS");
  EXPECT_DOUBLE_EQ(volume.sliceThickness, 6.0);
  EXPECT_EQ(volume.seriesUID, fixture.seriesUID);
  EXPECT_EQ(volume.identity, "seriesInstanceUID:" + fixture.seriesUID);
  EXPECT_TRUE(volume.repairs.empty());
  EXPECT_TRUE(volume.notes.empty());
}

TEST(VolumeReader, ObliqueAndSagittalPlanesKeepTheirPlaceInSpace)
{
  DicomFixture oblique;
  oblique.direction = DicomFixture::ObliqueDirection();
  DicomFixture sagittal;
  sagittal.direction.Fill(0.0);
  sagittal.direction(1, 0) = 1;
  sagittal.direction(2, 1) = -1;
  sagittal.direction(0, 2) = -1;
  for (const DicomFixture & fixture : { oblique, sagittal })
  {
    const Volume volume = ReadSaved(fixture.MakeSeries());
    EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
    EXPECT_TRUE(volume.image->GetDirection().GetVnlMatrix().as_matrix().is_equal(
      fixture.direction.GetVnlMatrix().as_matrix(), 1e-8));
  }
}

TEST(VolumeReader, TheOrderOfFilesAndInstanceNumbersDoesNotMatter)
{
  const DicomFixture fixture;
  auto               files = SlicesAt(fixture, { 10, 8, 6, 4, 2, 0 });
  std::swap(files[1], files[4]);
  EXPECT_LT(LargestDeviation(ReadSaved(files), DicomFixture::Ramp), Quantization);
}

/** GDCM 3.2, used by ITK 6, rejects RLE if a segment offset equals the number of bytes of the image, as in small noisy
 * images. */
DicomFixture
FixtureForRle()
{
  DicomFixture fixture;
  fixture.columns = 14;
  fixture.rows = 18;
  return fixture;
}

TEST(VolumeReader, EncodingsAgreeBitForBit)
{
  const DicomFixture fixture = FixtureForRle();
  const std::string  folder = TestFolder();
  std::vector<float> expected;
  const auto         check = [&](const std::string & name) {
    const Volume        volume = ReadVolume(folder + "/" + name);
    const float * const voxels = volume.image->GetBufferPointer();
    std::vector<float>  values(voxels, voxels + volume.image->GetLargestPossibleRegion().GetNumberOfPixels());
    expected = expected.empty() ? values : expected;
    EXPECT_EQ(values, expected) << name;
  };
  const std::pair<E_TransferSyntax, const char *> native[] = { { EXS_LittleEndianExplicit, "explicit" },
                                                               { EXS_LittleEndianImplicit, "implicit" },
                                                               { EXS_BigEndianExplicit, "bigEndian" },
                                                               { EXS_DeflatedLittleEndianExplicit, "deflated" },
                                                               { EXS_RLELossless, "rle" } };
  for (const auto & encoding : native)
  {
    fs::create_directory(folder + "/" + encoding.second);
    SaveDicom(fixture.MakeSeries(), folder + "/" + encoding.second, encoding.first);
    check(encoding.second);
  }
  const std::pair<const char *, const char *> compressed[] = { { "1.2.840.10008.1.2.4.57", "jpegLossless14" },
                                                               { "1.2.840.10008.1.2.4.70", "jpegLossless14SV1" },
                                                               { "1.2.840.10008.1.2.4.80", "jpegLS" },
                                                               { "1.2.840.10008.1.2.4.90", "jpeg2000" },
                                                               { "1.2.840.10008.1.2.5", "rleByGdcm" } };
  for (const auto & encoding : compressed)
  {
    const std::string subfolder = folder + "/" + encoding.second;
    fs::create_directory(subfolder);
    SaveDicom(fixture.MakeSeries(), subfolder);
    for (const auto & entry : fs::directory_iterator(subfolder))
    {
      shapeton::CompressDicom(entry.path().string(), encoding.first);
    }
    check(encoding.second);
  }
  const std::string deflated = folder + "/deflatedFrames";
  fs::create_directory(deflated);
  SaveDicom(fixture.MakeSeries(), deflated);
  for (const auto & entry : fs::directory_iterator(deflated))
  {
    shapeton::DeflateDicomFrames(entry.path().string());
  }
  check("deflatedFrames");
}

TEST(VolumeReader, DeflatedFramesThatDifferFromTheirHeaderAreRefused)
{
  const std::string folder = TestFolder();
  auto              files = DicomFixture().MakeSeries();
  SaveDicom(files, folder);
  const std::string path = folder + "/im0003.dcm";
  shapeton::DeflateDicomFrames(path);
  for (const std::size_t change : { 0, 1 }) // a larger frame than stored, then a smaller one
  {
    DcmFileFormat     file;
    const std::string fault = shapeton::LoadDicomFile(file, path, 4096);
    Uint16            rows = 0;
    ASSERT_EQ(fault, "");
    EXPECT_EQ(shapeton::DicomEncodingOf(file).name, "Deflated Image Frame Compression");
    ASSERT_TRUE(file.getDataset()->findAndGetUint16(DCM_Rows, rows).good());
    const std::size_t bytes = std::size_t{ rows } * 7 * 2;
    std::string       pixels(bytes + 4, '\0');
    EXPECT_NO_THROW(shapeton::DecodeDicomFrame(file, 0, bytes, &pixels[0]));
    EXPECT_THROW(shapeton::DecodeDicomFrame(file, 0, change == 0 ? bytes + 2 : bytes - 2, &pixels[0]),
                 std::runtime_error);
  }
}

TEST(VolumeReader, WithoutMetaHeaderAndWithoutExtension)
{
  const std::string folder = TestFolder();
  auto              files = DicomFixture().MakeSeries();
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const std::string path = folder + "/" + std::to_string(i);
    ASSERT_TRUE(files[i]->getDataset()->saveFile(path.c_str(), EXS_LittleEndianImplicit).good());
  }
  EXPECT_LT(LargestDeviation(ReadVolume(folder), DicomFixture::Ramp), Quantization);
}

TEST(VolumeReader, EachSliceHasItsOwnRescale)
{
  DicomFixture        fixture;
  DicomFixture::Files files;
  for (unsigned int i = 0; i < fixture.slices; ++i)
  {
    fixture.slope = (1.0 + i) / 64;
    fixture.intercept = 10.0 * i - 60;
    files.push_back(fixture.MakeSlice(fixture.SlicePosition(2.0 * i), static_cast<int>(i) + 1));
  }
  EXPECT_LT(LargestDeviation(ReadSaved(files), DicomFixture::Ramp), 0.5 * 6 / 64 + 1e-4);
}

TEST(VolumeReader, ASliceWithoutTheRescaleOfTheOthersMakesAMixedSeries)
{
  auto files = DicomFixture().MakeSeries();
  files[2]->getDataset()->findAndDeleteElement(DCM_RescaleSlope);
  files[2]->getDataset()->findAndDeleteElement(DCM_RescaleIntercept);
  EXPECT_NE(RefusalOf(files).find("one Series Instance UID contains"), std::string::npos);
}

TEST(VolumeReader, ACtWithoutRescaleIsReadAsStoredWithANote)
{
  auto files = DicomFixture().MakeSeries();
  for (const auto & file : files)
  {
    file->getDataset()->findAndDeleteElement(DCM_RescaleSlope);
    file->getDataset()->findAndDeleteElement(DCM_RescaleIntercept);
  }
  const std::string folder = TestFolder();
  SaveDicom(files, folder);
  const Volume volume = ReadVolume(folder);
  ASSERT_EQ(volume.notes.size(), 1U);
  EXPECT_NE(volume.notes[0].find("perhaps not Hounsfield units"), std::string::npos);
}

TEST(VolumeReader, SlicesWithAFrameOfReferenceEachAreAVolumeWithANote)
{
  auto files = DicomFixture().MakeSeries();
  SetText(files, DCM_FrameOfReferenceUID, [&](std::size_t i) { return "1.2.3." + std::to_string(i + 1); });
  const std::string folder = TestFolder();
  SaveDicom(files, folder);
  const Volume volume = ReadVolume(folder);
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
  ASSERT_EQ(volume.notes.size(), 1U);
  EXPECT_NE(volume.notes[0].find("the slices have 6 frames of reference"), std::string::npos);
}

TEST(VolumeReader, SlicesApartAreOneEntryOfTheRefusal)
{
  auto files = DicomFixture().MakeSeries();
  SetText(files, DCM_FrameOfReferenceUID, [&](std::size_t i) { return "1.2.3." + std::to_string(i + 1); });
  files.erase(files.begin() + 2);
  const std::string refusal = RefusalOf(files);
  EXPECT_NE(refusal.find("one Series Instance UID contains"), std::string::npos);
  EXPECT_NE(refusal.find("and 4 other slices of the same kind"), std::string::npos) << refusal;
  EXPECT_EQ(refusal.find("#2 ("), std::string::npos) << refusal;
}

TEST(VolumeReader, ASliceWithoutPositionIsNamedBesideTheGapItLeaves)
{
  auto files = DicomFixture().MakeSeries();
  files[2]->getDataset()->findAndDeleteElement(DCM_ImagePositionPatient);
  const std::string refusal = RefusalOf(files);
  EXPECT_NE(refusal.find("1 slice is missing"), std::string::npos);
  EXPECT_NE(refusal.find("im0003.dcm"), std::string::npos) << refusal;
}

TEST(VolumeReader, AnEmptyFileIsNamedBesideTheGapItLeaves)
{
  const std::string folder = TestFolder();
  SaveDicom(DicomFixture().MakeSeries(), folder);
  std::filesystem::resize_file(folder + "/im0003.dcm", 0);
  const std::string refusal = InputErrorOf([&] { ReadVolume(folder); });
  EXPECT_TRUE(Contains(refusal, "1 slice is missing")) << refusal;
  EXPECT_TRUE(Contains(refusal, "copy this file from its source again: im0003.dcm: not a DICOM file")) << refusal;
}

TEST(VolumeReader, AStraySliceIsNotTakenInPlaceOfAnIrregularSeries)
{
  const std::string folder = TestFolder();
  DicomFixture      fixture;
  auto              files = fixture.MakeSeries();
  files.erase(files.begin() + 2);
  SaveDicom(files, folder);
  fixture.seriesUID += ".9";
  SaveDicom(*fixture.MakeSlice(fixture.SlicePosition(50.0), 1), folder + "/stray.dcm");
  VolumeReadOptions options;
  options.allowSingleSlice = true;
  EXPECT_NE(InputErrorOf([&] { ReadVolume(folder, options); }).find("1 slice is missing"), std::string::npos);
  EXPECT_EQ(ReadVolume(folder + "/stray.dcm", options).image->GetLargestPossibleRegion().GetSize(2), 1U);
}

TEST(VolumeReader, IntegersThatSinglePrecisionRoundsAreNoted)
{
  const std::string header = "NRRD0004\ntype: uint\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
                             "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: ascii\nspace origin: (0,0,0)\n\n";
  const std::string folder = TestFolder();
  shapeton::WriteText(folder + "/small.nrrd", header + "0 1 2 3 4 5 6 16777215\n");
  shapeton::WriteText(folder + "/large.nrrd", header + "0 1 2 3 4 5 6 4294967295\n");
  EXPECT_TRUE(ReadVolume(folder + "/small.nrrd").notes.empty());
  ASSERT_EQ(ReadVolume(folder + "/large.nrrd").notes.size(), 1U);
  EXPECT_NE(ReadVolume(folder + "/large.nrrd").notes[0].find("single precision"), std::string::npos);
}

TEST(VolumeReader, ANamedPipeIsRefusedAndNotWaitedFor)
{
  const std::string path = TestFolder() + "/pipe.nrrd";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_NE(InputErrorOf([&] { ReadVolume(path); }).find("neither a file nor a folder"), std::string::npos);
}

TEST(VolumeReader, StoredBits)
{
  const auto read = [](bool isSigned, unsigned int bits, double intercept) {
    DicomFixture fixture;
    fixture.isSigned = isSigned;
    fixture.bitsStored = bits;
    fixture.slope = 1;
    fixture.intercept = intercept;
    return LargestDeviation(ReadSaved(fixture.MakeSeries()), DicomFixture::Ramp);
  };
  EXPECT_LT(read(true, 12, 0), 0.5001);      // negative values in 12 of 16 bits
  EXPECT_LT(read(false, 12, -1024), 0.5001); // the usual CT
  EXPECT_LT(read(true, 16, 0), 0.5001);
  EXPECT_LT(read(false, 16, -32768), 0.5001);
}

TEST(VolumeReader, BitsAboveTheHighBitAreIgnored)
{
  DicomFixture fixture;
  fixture.isSigned = false;
  fixture.bitsStored = 12;
  fixture.slope = 1;
  fixture.intercept = -1024;
  auto files = fixture.MakeSeries();
  for (auto & file : files)
  {
    const Uint16 * pixels = nullptr;
    unsigned long  count = 0;
    ASSERT_TRUE(file->getDataset()->findAndGetUint16Array(DCM_PixelData, pixels, &count).good());
    std::vector<Uint16> withOverlay(pixels, pixels + count);
    for (std::size_t i = 0; i < withOverlay.size(); i += 3)
    {
      withOverlay[i] |= 0xA000; // an overlay in the unused bits, written by old scanners
    }
    file->getDataset()->putAndInsertUint16Array(DCM_PixelData, withOverlay.data(), count);
  }
  EXPECT_LT(LargestDeviation(ReadSaved(files), DicomFixture::Ramp), 0.5001);
}

TEST(VolumeReader, PaddingBecomesTheLowestIntensity)
{
  for (const bool isSigned : { true, false })
  {
    DicomFixture fixture;
    fixture.isSigned = isSigned;
    fixture.slope = 1;
    fixture.intercept = isSigned ? 0 : -3000;
    const double padding = isSigned ? -2000 : 3000 - 2000;
    fixture.intensity = [](const DicomFixture::PointType & point) {
      return point[0] < -3 ? -2000.0 : point[1] > 20 ? -1995.0 : DicomFixture::Ramp(point);
    };
    auto files = fixture.MakeSeries();
    for (auto & file : files)
    {
      const auto insert = [&](const DcmTagKey & tag, double value) {
        return isSigned ? file->getDataset()->putAndInsertSint16(tag, static_cast<Sint16>(value))
                        : file->getDataset()->putAndInsertUint16(tag, static_cast<Uint16>(value));
      };
      ASSERT_TRUE(insert(DCM_PixelPaddingValue, padding).good());
      ASSERT_TRUE(insert(DCM_PixelPaddingRangeLimit, padding + 10).good());
    }
    const Volume volume = ReadSaved(files);
    const auto   count = volume.image->GetLargestPossibleRegion().GetNumberOfPixels();
    const float  lowest = *std::min_element(volume.image->GetBufferPointer(), volume.image->GetBufferPointer() + count);
    EXPECT_GT(lowest, -400.0F);
    EXPECT_EQ(volume.image->GetPixel({ { 0, 0, 0 } }), lowest);
    EXPECT_EQ(volume.image->GetPixel({ { 3, 8, 0 } }), lowest);
    const itk::Index<3>     inside{ { 3, 2, 1 } };
    DicomFixture::PointType point;
    volume.image->TransformIndexToPhysicalPoint(inside, point);
    EXPECT_NEAR(volume.image->GetPixel(inside), DicomFixture::Ramp(point), 0.5001);
    ASSERT_EQ(volume.notes.size(), 1u);
    EXPECT_TRUE(Contains(volume.notes[0], "padding"));
  }
}

TEST(VolumeReader, InvertedGrayScaleKeepsItsValues)
{
  auto files = DicomFixture().MakeSeries();
  SetText(files, DCM_PhotometricInterpretation, "MONOCHROME1");
  const Volume volume = ReadSaved(files);
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
  ASSERT_EQ(volume.notes.size(), 1u);
  EXPECT_TRUE(Contains(volume.notes[0], "MONOCHROME1"));
}

// ---- rejected inputs ----

TEST(VolumeReader, IrregularSeriesAreRefusedWithDefectSlicesAndAdvice)
{
  const DicomFixture fixture;
  const std::string  gap = RefusalOf(SlicesAt(fixture, { 0, 2, 8, 10 }));
  EXPECT_TRUE(Contains(gap, "2 slices are missing between slice 2 (im0002.dcm) and slice 3 (im0003.dcm)")) << gap;
  EXPECT_TRUE(Contains(gap, "the parameter \"resampleGaps\"")) << gap;
  EXPECT_TRUE(Contains(gap, fixture.seriesUID)) << gap;
  const std::string variable = RefusalOf(SlicesAt(fixture, { 0, 2, 4.5, 6, 8 }));
  EXPECT_TRUE(Contains(variable, "the distance between slices varies from 1.5 mm to 2.5 mm")) << variable;
  const std::string duplicate = RefusalOf(SlicesAt(fixture, { 0, 2, 2, 4 }));
  EXPECT_TRUE(Contains(duplicate, "1 position with several slices with equal pixels")) << duplicate;
  EXPECT_TRUE(Contains(duplicate, "the parameter \"dropDuplicates\"")) << duplicate;
}

TEST(VolumeReader, ModalityTablesAndZeroSlopesAreRefused)
{
  auto files = DicomFixture().MakeSeries();
  for (auto & file : files)
  {
    DcmItem * item = nullptr;
    ASSERT_TRUE(file->getDataset()->findOrCreateSequenceItem(DCM_ModalityLUTSequence, item, 0).good());
    item->putAndInsertString(DCM_ModalityLUTType, "HU");
  }
  EXPECT_TRUE(Contains(RefusalOf(files), "Modality LUT"));
  files = DicomFixture().MakeSeries();
  SetText(files, DCM_RescaleSlope, "0");
  EXPECT_TRUE(Contains(RefusalOf(files), "Rescale Slope is 0"));
}

TEST(VolumeReader, OneOfTwoVolumesHasToBeChosen)
{
  const std::string folder = TestFolder();
  DicomFixture      first;
  DicomFixture      second;
  second.seriesUID = "1.2.3.4";
  second.description = "PRONE";
  second.intensity = [](const DicomFixture::PointType & point) { return point[2]; };
  SaveDicom(first.MakeSeries(), folder, EXS_LittleEndianExplicit, "a");
  SaveDicom(second.MakeSeries(), folder, EXS_LittleEndianExplicit, "b");
  const std::string message = InputErrorOf([&folder] { ReadVolume(folder); });
  EXPECT_TRUE(Contains(message, first.seriesUID + " (FIXTURE, CT, 6 slices)")) << message;
  EXPECT_TRUE(Contains(message, "1.2.3.4 (PRONE, CT, 6 slices)")) << message;
  EXPECT_TRUE(Contains(message, "the parameter \"seriesUID\"")) << message;

  VolumeReadOptions options;
  options.seriesUID = "1.2.3.4";
  EXPECT_LT(LargestDeviation(ReadVolume(folder, options), second.intensity), Quantization);
  options.seriesUID = "9.9";
  const std::string unknown = InputErrorOf([&] { ReadVolume(folder, options); });
  EXPECT_TRUE(Contains(unknown, "series UID 9.9 not found; available: ")) << unknown;
}

TEST(VolumeReader, TheOnlyVolumeIsTakenWithANoteAboutTheRest)
{
  const std::string folder = TestFolder();
  shapeton::WriteFaultyInputs(folder);
  const Volume volume = ReadVolume(folder + "/withLocalizer");
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
  EXPECT_EQ(volume.notes, std::vector<std::string>{ "2 localizer images were skipped" });
}

TEST(VolumeReader, PartsOfAMixedSeriesCanBeChosen)
{
  const std::string folder = TestFolder();
  DicomFixture      axial;
  DicomFixture      small = axial;
  small.rows = 5;
  small.slices = 3;
  SaveDicom(axial.MakeSeries(), folder, EXS_LittleEndianExplicit, "a");
  SaveDicom(small.MakeSeries(), folder, EXS_LittleEndianExplicit, "b");
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder); }), "contains images of 2 kinds"));
  VolumeReadOptions options;
  options.seriesUID = axial.seriesUID;
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder, options); }), "contains images of 2 kinds"));
  options.seriesUID = axial.seriesUID + "#2";
  const Volume volume = ReadVolume(folder, options);
  ExpectSize(volume, 7, 5, 3);
  EXPECT_EQ(volume.identity, "seriesInstanceUID:" + axial.seriesUID + "#2");
}

TEST(VolumeReader, ATruncatedSliceSpoilsTheSeries)
{
  const std::string folder = TestFolder();
  SaveDicom(DicomFixture().MakeSeries(), folder);
  shapeton::Truncate(folder + "/im0006.dcm", fs::file_size(folder + "/im0006.dcm") - 10);
  const std::string message = InputErrorOf([&] { ReadVolume(folder); });
  EXPECT_TRUE(Contains(message, "truncated: ")) << message;
  EXPECT_TRUE(Contains(message, "im0006.dcm")) << message;
  // A file truncated before its series UID may be the last slice, which would not leave a gap.
  shapeton::Truncate(folder + "/im0006.dcm", 300);
  const std::string unknown = InputErrorOf([&] { ReadVolume(folder); });
  EXPECT_TRUE(Contains(unknown, "truncated: ")) << unknown;
  EXPECT_TRUE(Contains(unknown, "im0006.dcm")) << unknown;
  VolumeReadOptions options;
  options.seriesUID = DicomFixture().seriesUID;
  const Volume volume = ReadVolume(folder, options);
  ExpectSize(volume, 7, 9, 5);
  EXPECT_EQ(volume.notes, std::vector<std::string>{ "1 truncated file was skipped" });
}

TEST(VolumeReader, TruncatedCompressedPixelsAreNamed)
{
  const std::string folder = TestFolder();
  SaveDicom(DicomFixture().MakeSeries(), folder);
  const std::string path = folder + "/im0002.dcm";
  shapeton::CompressDicom(path, "1.2.840.10008.1.2.4.90");
  shapeton::Truncate(path, fs::file_size(path) - 60);
  const std::string message = InputErrorOf([&] { ReadVolume(folder); });
  EXPECT_TRUE(Contains(message, "truncated: ")) << message;
  EXPECT_TRUE(Contains(message, "im0002.dcm")) << message;
}

TEST(VolumeReader, DamagedCompressedPixelsAreNamed)
{
  const std::string folder = TestFolder();
  SaveDicom(DicomFixture().MakeSeries(), folder);
  const std::string path = folder + "/im0002.dcm";
  shapeton::CompressDicom(path, "1.2.840.10008.1.2.4.70");
  std::fstream      stream(path, std::ios::in | std::ios::out | std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const auto        start = bytes.find("\xFF\xD8\xFF");
  ASSERT_NE(start, std::string::npos);
  stream.seekp(static_cast<std::streamoff>(start));
  stream << std::string(20, 'x');
  stream.close();
  const std::string message = InputErrorOf([&] { ReadVolume(folder); });
  EXPECT_TRUE(Contains(message, "im0002.dcm")) << message;
}

TEST(VolumeReader, ASingleSliceOnlyWhereItIsAskedFor)
{
  const std::string  folder = TestFolder();
  const DicomFixture fixture;
  SaveDicom(fixture.MakeSeries(), folder);
  const std::string path = folder + "/im0003.dcm";
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(path); }), "a single slice"));
  VolumeReadOptions options;
  options.allowSingleSlice = true;
  const Volume volume = ReadVolume(path, options);
  ExpectSize(volume, 7, 9, 1);
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
  EXPECT_DOUBLE_EQ(volume.image->GetSpacing()[2], 6.0); // Slice Thickness
  ASSERT_EQ(volume.notes.size(), 1u);
}

// ---- multi-frame ----

TEST(VolumeReader, EnhancedFramesAreSortedByPositionAndRescaledOneByOne)
{
  const std::string  folder = TestFolder();
  const DicomFixture fixture;
  SaveDicom(*fixture.MakeEnhanced({ 6, 0, 10, 2, 8, 4 }), folder + "/multi.dcm");
  for (const std::string & path : { folder, folder + "/multi.dcm" })
  {
    const Volume volume = ReadVolume(path);
    ExpectSize(volume, 7, 9, 6);
    EXPECT_DOUBLE_EQ(volume.image->GetSpacing()[2], 2.0);
    EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), 2 * Quantization);
  }
}

TEST(VolumeReader, EnhancedFramesInAllEncodings)
{
  const DicomFixture fixture = FixtureForRle();
  const std::string  folder = TestFolder();
  for (const auto syntax :
       { EXS_LittleEndianImplicit, EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit, EXS_RLELossless })
  {
    SaveDicom(*fixture.MakeEnhanced({ 6, 0, 4, 2 }), folder + "/multi.dcm", syntax);
    EXPECT_LT(LargestDeviation(ReadVolume(folder), DicomFixture::Ramp), 2 * Quantization);
  }
  for (const char * syntax : { "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.80", "1.2.840.10008.1.2.4.90" })
  {
    SaveDicom(*fixture.MakeEnhanced({ 6, 0, 4, 2 }), folder + "/multi.dcm");
    shapeton::CompressDicom(folder + "/multi.dcm", syntax);
    EXPECT_LT(LargestDeviation(ReadVolume(folder), DicomFixture::Ramp), 2 * Quantization) << syntax;
  }
}

TEST(VolumeReader, EnhancedGapsAndDuplicatesAreFound)
{
  const std::string  folder = TestFolder();
  const DicomFixture fixture;
  SaveDicom(*fixture.MakeEnhanced({ 0, 2, 8, 10 }), folder + "/multi.dcm");
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder); }), "2 slices are missing"));
  SaveDicom(*fixture.MakeEnhanced({ 0, 2, 4, 4 }), folder + "/multi.dcm");
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder); }), "1 position with several slices"));
}

TEST(VolumeReader, FramesThatAreClaimedButNotDescribedAreTruncation)
{
  const std::string folder = TestFolder();
  const auto        file = DicomFixture().MakeEnhanced({ 0, 2, 4 });
  SetText(*file, DCM_NumberOfFrames, "2000000000");
  SaveDicom(*file, folder + "/multi.dcm");
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder); }), "it describes 3 of 2000000000 frames"));
}

// ---- repairs: the interpolation of an affine function is exact ----

TEST(VolumeReader, DropDuplicatesKeepsTheFirst)
{
  const DicomFixture fixture;
  DicomFixture       other = fixture;
  other.intensity = [](const DicomFixture::PointType &) { return 0.0; };
  auto files = SlicesAt(fixture, { 0, 2, 4, 6 });
  files.push_back(other.MakeSlice(fixture.SlicePosition(4), 99));
  VolumeReadOptions options;
  options.dropDuplicates = true;
  const Volume volume = ReadSaved(files, options);
  ExpectSize(volume, 7, 9, 4);
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
  EXPECT_EQ(volume.repairs, std::vector<std::string>{ "dropDuplicates: 1 slice at positions of other slices skipped" });
}

TEST(VolumeReader, ResampleGapsFillsGaps)
{
  DicomFixture fixture;
  fixture.direction = DicomFixture::ObliqueDirection();
  VolumeReadOptions options;
  options.resampleGaps = true;
  const Volume volume = ReadSaved(SlicesAt(fixture, { 0, 2, 8, 10, 12, 16 }), options);
  ExpectSize(volume, 7, 9, 9);
  EXPECT_NEAR(volume.image->GetSpacing()[2], 2.0, 1e-9);
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
  ASSERT_EQ(volume.repairs.size(), 1u);
  EXPECT_TRUE(Contains(volume.repairs[0], "3 of them by linear interpolation")) << volume.repairs[0];
}

TEST(VolumeReader, ResampleGapsKeepsTheSlicesOfTheGrid)
{
  DicomFixture fixture;
  fixture.intensity = [](const DicomFixture::PointType & point) {
    return 50 * std::sin(3 * point[0] + 5 * point[1] + 7 * point[2]);
  };
  VolumeReadOptions options;
  options.resampleGaps = true;
  const Volume volume = ReadSaved(SlicesAt(fixture, { 0, 2, 6, 8 }), options);
  ExpectSize(volume, 7, 9, 5);
  for (const int k : { 0, 1, 3, 4 })
  {
    const itk::Index<3>     index{ { 3, 4, k } };
    DicomFixture::PointType point;
    volume.image->TransformIndexToPhysicalPoint(index, point);
    EXPECT_NEAR(volume.image->GetPixel(index), fixture.intensity(point), Quantization) << k;
  }
}

TEST(VolumeReader, ResampleGapsEvensOutVariableSpacing)
{
  const DicomFixture fixture;
  VolumeReadOptions  options;
  options.resampleGaps = true;
  const Volume volume = ReadSaved(SlicesAt(fixture, { 0, 2, 4, 6, 9, 12, 15 }), options);
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
  const auto size = volume.image->GetLargestPossibleRegion().GetSize();
  EXPECT_NEAR(static_cast<double>(size[2] - 1) * volume.image->GetSpacing()[2], 15.0, 1e-9);
}

TEST(VolumeReader, GapsTooWideAreNotFilled)
{
  const std::string folder = TestFolder();
  SaveDicom(SlicesAt(DicomFixture(), { 0, 2, 4, 400 }), folder);
  VolumeReadOptions options;
  options.resampleGaps = true;
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadVolume(folder, options); }), "too wide"));
}

TEST(VolumeReader, DeshearPutsEachSliceInItsPlace)
{
  for (const bool isOblique : { false, true })
  {
    DicomFixture fixture;
    fixture.direction = isOblique ? DicomFixture::ObliqueDirection() : fixture.direction;
    DicomFixture::Files files;
    for (int i = 0; i < 6; ++i)
    {
      files.push_back(fixture.MakeSlice(fixture.SlicePosition(2.0 * i, -0.31 * i, 0.57 * i), i + 1));
    }
    VolumeReadOptions options;
    options.deshear = true;
    const Volume volume = ReadSaved(files, options);
    ExpectSize(volume, 7 + 3, 9 + 3, 6); // 1.55 mm are 2.07 columns, 2.85 mm are 2.28 rows
    const float outside = *std::min_element(volume.image->GetBufferPointer(),
                                            volume.image->GetBufferPointer() +
                                              volume.image->GetLargestPossibleRegion().GetNumberOfPixels());
    std::size_t covered = 0;
    basetest::ForVoxels(volume.image, [&](const auto & index, const auto & point) {
      const float value = volume.image->GetPixel(index);
      if (value != outside)
      {
        ++covered;
        ASSERT_NEAR(value, DicomFixture::Ramp(point), Quantization) << index;
      }
    });
    // Each slice covers its 7 x 9 pixels except for the border, where interpolation lacks a neighbor.
    EXPECT_GE(covered, 6u * 6u * 8u);
    ASSERT_EQ(volume.repairs.size(), 1u);
    EXPECT_TRUE(Contains(volume.repairs[0], "deshear: 6 slices shifted")) << volume.repairs[0];
  }
}

TEST(VolumeReader, DeshearAfterAGantryTiltRestoresTheRamp)
{
  // Gantry tilt: the table moves along z, the planes are tilted by 15 degrees about x.
  const double angle = 15.0 * std::acos(-1.0) / 180.0;
  DicomFixture fixture;
  fixture.direction(1, 1) = std::cos(angle);
  fixture.direction(2, 1) = -std::sin(angle);
  fixture.direction(1, 2) = std::sin(angle);
  fixture.direction(2, 2) = std::cos(angle);
  DicomFixture::Files files;
  for (int i = 0; i < 6; ++i)
  {
    DicomFixture::PointType position = fixture.origin;
    position[2] += 2.0 * i;
    files.push_back(fixture.MakeSlice(position, i + 1));
  }
  VolumeReadOptions options;
  options.deshear = true;
  const Volume volume = ReadSaved(files, options);
  EXPECT_NEAR(volume.image->GetSpacing()[2], 2.0 * std::cos(angle), 1e-9);
  const itk::Index<3>     index{ { 3, 6, 3 } };
  DicomFixture::PointType point;
  volume.image->TransformIndexToPhysicalPoint(index, point);
  EXPECT_NEAR(volume.image->GetPixel(index), DicomFixture::Ramp(point), Quantization);
}

TEST(VolumeReader, RepairsCombine)
{
  const DicomFixture  fixture;
  DicomFixture::Files files;
  for (const double distance : { 0.0, 2.0, 2.0, 6.0, 8.0 })
  {
    files.push_back(
      fixture.MakeSlice(fixture.SlicePosition(distance, 0, 0.25 * distance), static_cast<int>(files.size()) + 1));
  }
  VolumeReadOptions options;
  options.deshear = true;
  options.dropDuplicates = true;
  EXPECT_TRUE(Contains(InputErrorOf([&] { ReadSaved(files, options); }), "1 slice is missing"));
  options.resampleGaps = true;
  const Volume volume = ReadSaved(files, options);
  EXPECT_EQ(volume.repairs.size(), 3u);
  ExpectSize(volume, 7, 9 + 2, 5);
  const itk::Index<3>     index{ { 3, 5, 2 } };
  DicomFixture::PointType point;
  volume.image->TransformIndexToPhysicalPoint(index, point);
  EXPECT_NEAR(volume.image->GetPixel(index), DicomFixture::Ramp(point), Quantization);
}

TEST(VolumeReader, RepairsLeaveASoundSeriesAsItIs)
{
  VolumeReadOptions options;
  options.deshear = options.dropDuplicates = options.resampleGaps = true;
  const Volume volume = ReadSaved(DicomFixture().MakeSeries(), options);
  EXPECT_TRUE(volume.repairs.empty());
  EXPECT_LT(LargestDeviation(volume, DicomFixture::Ramp), Quantization);
}

TEST(VolumeReader, IsAbortedByProgressOfEachFileAndSlice)
{
  const std::string folder = TestFolder();
  const auto        files = DicomFixture().MakeSeries();
  SaveDicom(files, folder);
  const auto work = [&](const shapeton::Progress & progress) { ReadVolume(folder, {}, progress); };
  shapeton::test::ExpectProgress(work, files.size() + 2); // only one thread reports its slices
}
