#include "shapetonDicomFields.h"
#include "shapetonDicomSeriesWriter.h"
#include "shapetonFileBytes.h"
#include "shapetonPi.h"
#include "shapetonTestFolder.h"
#include "shapetonTestImages.h"
#include "shapetonTestReports.h"
#include "shapetonVolumeReader.h"

#include "itkGDCMImageIO.h"
#include "itkGDCMSeriesFileNames.h"
#include "itkImageSeriesReader.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
using basetest::FilesIn;
using basetest::Folder;
using ImageType = itk::Image<short, 3>;

// Oblique and anisotropic; pixels from the full range of a CT series.
ImageType::Pointer
MakeImage(unsigned int slices = 5, int offset = 0)
{
  const auto   image = basetest::NewImage<ImageType>({ { 7, 6, slices } },
                                                   { { 0.7, 0.9, 1.25 } },
                                                   { { -123.456789, 1.0 / 3.0, 1e-7 } },
                                                   basetest::Rotation(0, shapeton::Pi / 3.6) *
                                                     basetest::Rotation(2, shapeton::Pi / 6.0));
  unsigned int value = 12345 + offset;
  std::generate_n(image->GetBufferPointer(), image->GetBufferedRegion().GetNumberOfPixels(), [&value] {
    value = value * 1664525U + 1013904223U;
    return static_cast<short>(static_cast<int>(value >> 17) - 1024);
  });
  image->SetPixel({ { 0, 0, 0 } }, -1024);
  image->SetPixel({ { 1, 0, 0 } }, 31743);
  return image;
}

std::map<std::string, std::string>
BytesIn(const std::string & folder)
{
  std::map<std::string, std::string> bytes;
  for (const auto & name : FilesIn(folder))
  {
    bytes[name] = shapeton::ReadFileBytes(folder + "/" + name);
  }
  return bytes;
}

std::string
TextOf(DcmFileFormat & file, const DcmTagKey & tag)
{
  OFString text;
  EXPECT_TRUE(file.getDataset()->findAndGetOFStringArray(tag, text).good()) << DcmTag(tag).getTagName();
  return std::string(text.c_str(), text.size());
}

std::vector<double>
NumbersOf(DcmFileFormat & file, const DcmTagKey & tag)
{
  std::vector<double> numbers;
  std::istringstream  is(TextOf(file, tag));
  for (std::string part; std::getline(is, part, '\\');)
  {
    EXPECT_LE(part.size(), 16U);
    numbers.push_back(std::stod(part));
  }
  return numbers;
}

DcmFileFormat
Load(const std::string & path)
{
  DcmFileFormat file;
  EXPECT_TRUE(file.loadFile(path.c_str()).good()) << path;
  return file;
}

template <typename TImage>
void
ExpectSameImage(const ImageType * expected, const TImage * image)
{
  ASSERT_EQ(image->GetLargestPossibleRegion().GetSize(), expected->GetLargestPossibleRegion().GetSize());
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(image->GetOrigin()[i], expected->GetOrigin()[i], 1e-8);
    EXPECT_NEAR(image->GetSpacing()[i], expected->GetSpacing()[i], 1e-8);
    for (unsigned int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(image->GetDirection()(i, j), expected->GetDirection()(i, j), 1e-8);
    }
  }
  std::size_t differences = 0;
  for (itk::SizeValueType i = 0; i < expected->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    differences += image->GetBufferPointer()[i] != expected->GetBufferPointer()[i];
  }
  EXPECT_EQ(differences, 0U);
}

shapeton::DicomSeriesDescription
Describe(const std::string & text = "test")
{
  shapeton::DicomSeriesDescription description;
  description.seriesDescription = text;
  return description;
}
} // namespace

TEST(DicomSeriesWriter, DcmtkReadsPixelsAndGeometry)
{
  const Folder folder;
  const auto   image = MakeImage();
  shapeton::WriteDicomSeries(image, folder / "", Describe());
  EXPECT_EQ(FilesIn(folder / ""),
            (std::set<std::string>{ "IM0001.dcm", "IM0002.dcm", "IM0003.dcm", "IM0004.dcm", "IM0005.dcm" }));
  std::set<std::string> instances;
  for (int slice = 0; slice < 5; ++slice)
  {
    DcmFileFormat file = Load(folder / ("IM000" + std::to_string(slice + 1) + ".dcm"));
    EXPECT_EQ(file.getDataset()->getOriginalXfer(), EXS_LittleEndianExplicit);
    EXPECT_EQ(TextOf(file, DCM_SOPClassUID), UID_CTImageStorage);
    EXPECT_EQ(TextOf(file, DCM_InstanceNumber), std::to_string(slice + 1));
    instances.insert(TextOf(file, DCM_SOPInstanceUID));

    ImageType::PointType position;
    image->TransformIndexToPhysicalPoint(ImageType::IndexType{ { 0, 0, slice } }, position);
    const auto written = NumbersOf(file, DCM_ImagePositionPatient);
    const auto orientation = NumbersOf(file, DCM_ImageOrientationPatient);
    ASSERT_EQ(written.size(), 3U);
    ASSERT_EQ(orientation.size(), 6U);
    for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(written[i], position[i], 1e-9);
      EXPECT_NEAR(orientation[i], image->GetDirection()(i, 0), 1e-12);
      EXPECT_NEAR(orientation[3 + i], image->GetDirection()(i, 1), 1e-12);
    }
    EXPECT_EQ(NumbersOf(file, DCM_PixelSpacing), (std::vector<double>{ 0.9, 0.7 })); // between rows, then columns

    const Uint16 * pixels = nullptr;
    unsigned long  count = 0;
    ASSERT_TRUE(file.getDataset()->findAndGetUint16Array(DCM_PixelData, pixels, &count).good());
    ASSERT_EQ(count, 42U);
    const short * const expected = image->GetBufferPointer() + 42 * slice;
    EXPECT_TRUE(std::equal(pixels, pixels + count, expected, [](Uint16 a, short b) { return a - 1024 == b; }));
  }
  EXPECT_EQ(instances.size(), 5U);
}

TEST(DicomSeriesWriter, GdcmReadsPixelsAndGeometry)
{
  const Folder folder;
  const auto   image = MakeImage();
  shapeton::WriteDicomSeries(image, folder / "", Describe());
  const auto names = itk::GDCMSeriesFileNames::New();
  names->SetDirectory(folder / "");
  const auto reader = itk::ImageSeriesReader<ImageType>::New();
  reader->SetImageIO(itk::GDCMImageIO::New());
  reader->SetFileNames(names->GetInputFileNames());
  reader->ForceOrthogonalDirectionOff();
  reader->Update();
  ExpectSameImage(image.GetPointer(), reader->GetOutput());

  reader->GetOutput()->SetMetaDataDictionary(*(*reader->GetMetaDataDictionaryArray())[0]);
  const auto ours = shapeton::ReadVolume(folder / "").image;
  for (const char * key : { shapeton::DicomModality, shapeton::DicomPatientPosition, shapeton::DicomSliceThickness })
  {
    EXPECT_EQ(shapeton::DicomField(reader->GetOutput(), key), shapeton::DicomField(ours, key));
    EXPECT_NE(shapeton::DicomField(ours, key), "");
  }
}

TEST(DicomSeriesWriter, OurReaderReadsPixelsAndGeometry)
{
  const Folder folder;
  const auto   image = MakeImage();
  auto         description = Describe();
  description.patientPosition = "FFP";
  shapeton::WriteDicomSeries(image, folder / "", description);
  const shapeton::Volume volume = shapeton::ReadVolume(folder / "");
  EXPECT_EQ(volume.modality, "CT");
  EXPECT_EQ(volume.patientPosition, "FFP");
  EXPECT_TRUE(volume.repairs.empty());
  ExpectSameImage(image.GetPointer(), volume.image.GetPointer());
}

TEST(DicomSeriesWriter, KeepsAStartIndexOutOfTheFile)
{
  const Folder folder;
  const auto   image = MakeImage();
  const auto   shifted = MakeImage();
  shifted->SetRegions(ImageType::RegionType({ { 10, -4, 3 } }, { { 7, 6, 5 } }));
  ImageType::PointType origin;
  ImageType::IndexType minusStart{ { -10, 4, -3 } };
  image->TransformIndexToPhysicalPoint(minusStart, origin);
  shifted->SetOrigin(origin);
  shapeton::WriteDicomSeries(shifted, folder / "", Describe());
  ExpectSameImage(image.GetPointer(), shapeton::ReadVolume(folder / "").image.GetPointer());
}

TEST(DicomSeriesWriter, EqualCallsWriteEqualBytes)
{
  const Folder first;
  const auto   path = first / "a";
  const auto   other = first / "b";
  fs::create_directory(path);
  fs::create_directory(other);
  shapeton::WriteDicomSeries(MakeImage(), path, Describe());
  shapeton::WriteDicomSeries(MakeImage(), other, Describe());
  EXPECT_EQ(BytesIn(path).size(), 5U);
  EXPECT_EQ(BytesIn(path), BytesIn(other));
}

TEST(DicomSeriesWriter, UIDsFollowTheContent)
{
  const Folder folder;
  const auto   uidsOf = [&folder](const ImageType * image, const shapeton::DicomSeriesDescription & description) {
    shapeton::WriteDicomSeries(image, folder / "", description);
    DcmFileFormat            file = Load(folder / "IM0001.dcm");
    std::vector<std::string> uids;
    for (const auto & tag :
         { DCM_StudyInstanceUID, DCM_FrameOfReferenceUID, DCM_SeriesInstanceUID, DCM_SOPInstanceUID })
    {
      uids.push_back(TextOf(file, tag));
      EXPECT_EQ(uids.back().substr(0, 5), "2.25.");
      EXPECT_TRUE(DcmUniqueIdentifier::checkStringValue(uids.back().c_str(), "1").good()) << uids.back();
    }
    EXPECT_EQ(std::set<std::string>(uids.begin(), uids.end()).size(), 4U);
    return uids;
  };
  const auto base = uidsOf(MakeImage(), Describe());
  EXPECT_EQ(uidsOf(MakeImage(), Describe()), base);

  const auto otherPixels = uidsOf(MakeImage(5, 1), Describe());
  const auto otherText = uidsOf(MakeImage(), Describe("other"));
  const auto moved = MakeImage();
  auto       origin = moved->GetOrigin();
  origin[0] += 1e-6;
  moved->SetOrigin(origin);
  for (const auto & uids : { otherPixels, otherText, uidsOf(moved, Describe()) })
  {
    EXPECT_EQ(uids[0], base[0]); // the same study and frame of reference
    EXPECT_EQ(uids[1], base[1]);
    EXPECT_NE(uids[2], base[2]);
    EXPECT_NE(uids[3], base[3]);
  }
  auto seeded = Describe();
  seeded.seed = 1;
  const auto otherSeed = uidsOf(MakeImage(), seeded);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NE(otherSeed[i], base[i]);
  }
}

TEST(DicomSeriesWriter, StoresTwelveBitsWhereTheyAreEnough)
{
  const Folder folder;
  const auto   image = MakeImage();
  image->FillBuffer(3071);
  shapeton::WriteDicomSeries(image, folder / "", Describe());
  DcmFileFormat file = Load(folder / "IM0001.dcm");
  EXPECT_EQ(TextOf(file, DCM_BitsStored), "12");
  image->FillBuffer(3072);
  shapeton::WriteDicomSeries(image, folder / "", Describe());
  file = Load(folder / "IM0001.dcm");
  EXPECT_EQ(TextOf(file, DCM_BitsStored), "16");
}

TEST(DicomSeriesWriter, RefusesWhatNoSeriesCanHold)
{
  const Folder folder;
  const auto   refuses = [&folder](const ImageType * image, const shapeton::DicomSeriesDescription & description) {
    return basetest::ErrorOf([&] { shapeton::WriteDicomSeries(image, folder / "", description); });
  };
  auto image = MakeImage();
  auto direction = image->GetDirection();
  for (unsigned int i = 0; i < 3; ++i)
  {
    direction(i, 2) *= -1.0;
  }
  image->SetDirection(direction);
  EXPECT_NE(refuses(image, Describe()).find("left-handed"), std::string::npos);
  direction(0, 2) += 0.2;
  image->SetDirection(direction);
  EXPECT_NE(refuses(image, Describe()).find("not perpendicular"), std::string::npos);
  image = MakeImage();
  image->SetPixel({ { 3, 3, 3 } }, -1025);
  EXPECT_NE(refuses(image, Describe()).find("-1025"), std::string::npos);
  image->SetPixel({ { 3, 3, 3 } }, 31744);
  EXPECT_NE(refuses(image, Describe()).find("31744"), std::string::npos);
  EXPECT_NE(refuses(MakeImage(1), Describe()).find("two slices"), std::string::npos);
  EXPECT_NE(refuses(MakeImage(), Describe(std::string(65, 'x'))).find("more than 64"), std::string::npos);
  EXPECT_NE(refuses(MakeImage(), Describe("a\\b")).find("backslash"), std::string::npos);
  EXPECT_NE(refuses(MakeImage(), Describe("a\nb")).find("control"), std::string::npos);
  auto upsideDown = Describe();
  upsideDown.patientPosition = "XYZ";
  EXPECT_NE(refuses(MakeImage(), upsideDown).find("XYZ"), std::string::npos);
  EXPECT_TRUE(FilesIn(folder / "").empty());

  const std::string umlauts = Describe(std::string(64, 'x')).seriesDescription.substr(2) + "\xC3\xA4\xC3\xB6";
  EXPECT_EQ(refuses(MakeImage(), Describe(umlauts)), ""); // 64 characters in 66 bytes
  EXPECT_THROW(shapeton::WriteDicomSeries(MakeImage(), folder / "absent", Describe()), shapeton::OutputError);
}

TEST(DicomSeriesFolder, MakesFillsAndReplacesAFolder)
{
  const Folder folder;
  const auto   series = folder / "series";
  shapeton::WriteDicomSeriesFolder(MakeImage(), series, Describe());
  EXPECT_EQ(FilesIn(series).size(), 5U);
  const auto before = BytesIn(series);
  shapeton::WriteDicomSeriesFolder(MakeImage(3, 1), series + "/", Describe());
  EXPECT_EQ(FilesIn(series), (std::set<std::string>{ "IM0001.dcm", "IM0002.dcm", "IM0003.dcm" }));
  shapeton::WriteDicomSeriesFolder(MakeImage(), series, Describe());
  EXPECT_EQ(BytesIn(series), before);
  fs::create_directory(folder / "empty");
  shapeton::WriteDicomSeriesFolder(MakeImage(), folder / "empty", Describe());
  EXPECT_EQ(BytesIn(folder / "empty"), before);
  EXPECT_EQ(FilesIn(folder / ""), (std::set<std::string>{ "empty", "series" }));
}

TEST(DicomSeriesFolder, WritesThroughALink)
{
  const Folder folder;
  fs::create_directory(folder / "real");
  fs::create_directory_symlink(folder / "real", folder / "link");
  shapeton::WriteDicomSeriesFolder(MakeImage(), folder / "link", Describe());
  shapeton::WriteDicomSeriesFolder(MakeImage(), folder / "link", Describe());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(FilesIn(folder / "real").size(), 5U);
}

TEST(DicomSeriesFolder, RefusesAFolderWithOtherThings)
{
  const Folder folder;
  const auto   series = folder / "series";
  shapeton::WriteDicomSeriesFolder(MakeImage(), series, Describe());
  const auto refuses = [&series] {
    const auto before = BytesIn(series);
    EXPECT_THROW(shapeton::CheckDicomSeriesFolder(series), shapeton::ParameterError);
    EXPECT_THROW(shapeton::WriteDicomSeriesFolder(MakeImage(2), series, Describe()), shapeton::ParameterError);
    EXPECT_EQ(BytesIn(series), before);
  };
  EXPECT_NO_THROW(shapeton::CheckDicomSeriesFolder(series));
  std::ofstream(series + "/notes.txt") << "mine";
  refuses();
  fs::remove(series + "/notes.txt");
  std::ofstream(series + "/IM0006.dcm") << "not DICOM";
  refuses();
  // A slice from another vendor with a matching file name.
  DcmFileFormat file = Load(series + "/IM0001.dcm");
  file.getDataset()->putAndInsertString(DCM_Manufacturer, "Scanner");
  ASSERT_TRUE(file.saveFile((series + "/IM0006.dcm").c_str(), EXS_LittleEndianExplicit).good());
  refuses();

  std::ofstream(folder / "file") << "mine";
  EXPECT_THROW(shapeton::WriteDicomSeriesFolder(MakeImage(), folder / "file", Describe()), shapeton::OutputError);
  EXPECT_THROW(shapeton::WriteDicomSeriesFolder(MakeImage(), folder / "absent/series", Describe()),
               shapeton::OutputError);
  EXPECT_THROW(shapeton::WriteDicomSeriesFolder(MakeImage(), ".", Describe()), shapeton::OutputError);
  EXPECT_THROW(shapeton::WriteDicomSeriesFolder(MakeImage(), "", Describe()), shapeton::OutputError);
  EXPECT_EQ(FilesIn(folder / ""), (std::set<std::string>{ "file", "series" }));
}

TEST(DicomSeriesFolder, AFailureKeepsTheOldSeries)
{
  const Folder folder;
  const auto   series = folder / "series";
  shapeton::WriteDicomSeriesFolder(MakeImage(), series, Describe());
  const auto before = BytesIn(series);
  EXPECT_THROW(shapeton::WriteDicomSeriesFolder(MakeImage(1), series, Describe()), shapeton::InputError);
  EXPECT_EQ(BytesIn(series), before);
  EXPECT_EQ(FilesIn(folder / ""), (std::set<std::string>{ "series" }));
}

namespace
{
// An unused process id.
std::string
NumberOfADeadProcess()
{
  const pid_t child = fork();
  if (child == 0)
  {
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  return std::to_string(child);
}
} // namespace

TEST(DicomSeriesFolder, TidiesAfterKilledRuns)
{
  const Folder folder;
  const auto   series = folder / "series";
  const auto   dead = NumberOfADeadProcess();
  shapeton::WriteDicomSeriesFolder(MakeImage(), series, Describe());
  const auto old = BytesIn(series);

  fs::copy(series, folder / (".series." + dead + ".part"));
  shapeton::WriteDicomSeriesFolder(MakeImage(3), series, Describe());
  EXPECT_EQ(FilesIn(folder / ""), (std::set<std::string>{ "series" }));

  // Killed between the two renames on a file system without exchange: the old series is restored.
  shapeton::WriteDicomSeriesFolder(MakeImage(), series, Describe());
  fs::rename(series, folder / (".series." + dead + ".old"));
  EXPECT_THROW(shapeton::WriteDicomSeriesFolder(MakeImage(1), series, Describe()), shapeton::InputError);
  EXPECT_EQ(BytesIn(series), old);
  EXPECT_EQ(FilesIn(folder / ""), (std::set<std::string>{ "series" }));

  // A written folder with an additional file is left unchanged.
  fs::create_directory(folder / (".series." + dead + ".part"));
  std::ofstream(folder / (".series." + dead + ".part/notes.txt")) << "mine";
  shapeton::WriteDicomSeriesFolder(MakeImage(), series, Describe());
  EXPECT_TRUE(fs::exists(folder / (".series." + dead + ".part/notes.txt")));
}

class KilledRun : public testing::TestWithParam<int>
{};

// Whenever the signal arrives, there is one complete series, old or new.
TEST_P(KilledRun, LeavesAWholeSeries)
{
  const int    signal = GetParam();
  const Folder folder;
  const auto   series = folder / "series";
  const auto   oldImage = MakeImage(200);
  const auto   newImage = MakeImage(200, 1);
  shapeton::WriteDicomSeriesFolder(newImage, series, Describe());
  const auto newBytes = BytesIn(series);
  shapeton::WriteDicomSeriesFolder(oldImage, series, Describe());
  const auto oldBytes = BytesIn(series);
  int        killed = 0;
  for (int delay = 0; delay < 12; ++delay)
  {
    const pid_t child = fork();
    if (child == 0)
    {
      shapeton::WriteDicomSeriesFolder(newImage, series, Describe());
      _exit(0);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(3 * delay));
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    killed += WIFSIGNALED(status);
    const auto bytes = BytesIn(series);
    EXPECT_TRUE(bytes == oldBytes || bytes == newBytes) << bytes.size() << " files";
    if (signal == SIGTERM)
    {
      EXPECT_EQ(FilesIn(folder / ""), (std::set<std::string>{ "series" }));
    }
  }
  shapeton::WriteDicomSeriesFolder(oldImage, series, Describe());
  EXPECT_EQ(BytesIn(series), oldBytes);
  EXPECT_EQ(FilesIn(folder / ""), (std::set<std::string>{ "series" }));
  EXPECT_GT(killed, 0);
}

INSTANTIATE_TEST_SUITE_P(Signals, KilledRun, testing::Values(SIGTERM, SIGKILL));
