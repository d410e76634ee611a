#include "shapetonFileBytes.h"
#include "shapetonNiftiTestFile.h"
#include "shapetonVolumeTesting.h"
#include "shapetonVolumeWriter.h"
#include "shapetonTestImages.h"

#include <cstdint>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sys/resource.h>

#if defined(__SANITIZE_ADDRESS__)
/** NrrdIO leaks its error messages if writing fails. */
extern "C" __attribute__((visibility("default"))) const char *
__lsan_default_suppressions()
{
  return "leak:libITKNrrdIO";
}
#endif

namespace
{
using shapeton::Contains;
using shapeton::DicomFixture;
using shapeton::InputErrorOf;
using shapeton::ReadVolume;
using shapeton::TestFolder;
using shapeton::Volume;
using shapeton::WriteVolume;

template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeOblique(bool isLeftHanded = false)
{
  itk::Matrix<double, 3, 3> direction = DicomFixture::ObliqueDirection();
  for (unsigned int i = 0; i < 3 && isLeftHanded; ++i)
  {
    direction(i, 0) = -direction(i, 0);
  }
  const auto image = basetest::NewImage<itk::Image<TPixel, 3>>(
    { { 5, 4, 3 } }, { { 0.5, 0.75, 2.0 } }, { { -12.5, 30.25, 100.0 } }, direction);
  std::mt19937 random(3);
  for (unsigned int i = 0; i < 60; ++i)
  {
    image->GetBufferPointer()[i] = static_cast<TPixel>(static_cast<double>(random() % 1000) / 8);
  }
  return image;
}

template <typename TPixel>
void
ExpectRoundTrip(const std::string & name, bool isLeftHanded = false)
{
  const auto        image = MakeOblique<TPixel>(isLeftHanded);
  const std::string path = TestFolder() + "/" + name;
  WriteVolume<TPixel>(image.GetPointer(), path);
  const Volume copy = ReadVolume(path);
  for (unsigned int i = 0; i < 60; ++i)
  {
    ASSERT_EQ(copy.image->GetBufferPointer()[i], static_cast<float>(image->GetBufferPointer()[i])) << name;
  }
  const double tolerance = Contains(name, ".nii") ? 1e-5 : 1e-14; // NIfTI keeps float
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(copy.image->GetSpacing()[i], image->GetSpacing()[i], tolerance) << name;
    EXPECT_NEAR(copy.image->GetOrigin()[i], image->GetOrigin()[i], tolerance) << name;
    for (unsigned int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(copy.image->GetDirection()(i, j), image->GetDirection()(i, j), tolerance) << name;
    }
  }
}

std::string
RefusalOf(const std::string & path)
{
  return InputErrorOf([&path] { ReadVolume(path); });
}

const std::string Bytes8(8, 'a');
const std::string EightBytes = "type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n";

std::string
WriteNrrd(const std::string & header, const std::string & data = Bytes8)
{
  const std::string path = TestFolder() + "/image.nrrd";
  shapeton::WriteText(path, "NRRD0004\n" + header + "\n" + data);
  return path;
}
} // namespace

TEST(VolumeWriter, RoundTripsKeepPixelsAndObliqueGeometry)
{
  for (const std::string extension : { "nrrd", "nii", "nii.gz", "mha" })
  {
    ExpectRoundTrip<float>("image." + extension);
    ExpectRoundTrip<short>("image." + extension);
    ExpectRoundTrip<unsigned char>("image." + extension);
    ExpectRoundTrip<unsigned short>("image." + extension);
    ExpectRoundTrip<unsigned int>("image." + extension);
  }
}

TEST(VolumeWriter, TheFirstIndexMayNotBeZero)
{
  const auto image = itk::Image<float, 3>::New();
  image->SetRegions(itk::ImageRegion<3>({ { 2, -3, 4 } }, { { 3, 4, 5 } }));
  image->SetSpacing(itk::Vector<double, 3>(2.0));
  image->Allocate(true);
  for (const std::string extension : { "nrrd", "nii.gz", "mha" })
  {
    const std::string path = TestFolder() + "/image." + extension;
    WriteVolume<float>(image, path);
    const auto first = ReadVolume(path).image->GetOrigin();
    EXPECT_EQ(std::vector<double>(first.Begin(), first.End()), (std::vector<double>{ 4.0, -6.0, 8.0 })) << extension;
  }
}

TEST(VolumeWriter, LeftHandedAxesAreKept)
{
  for (const std::string extension : { "nrrd", "nii", "mha" })
  {
    ExpectRoundTrip<float>("image." + extension, true);
  }
}

TEST(VolumeWriter, MetadataStandInTheHeaderAndEqualImagesGiveEqualBytes)
{
  const std::string              folder = TestFolder();
  const auto                     image = MakeOblique<float>();
  const shapeton::VolumeMetadata metadata = { { "tool", "Test" }, { "repair", "two\nlines" }, { "empty", "" } };
  for (const std::string extension : { "nrrd", "mha" })
  {
    WriteVolume<float>(image.GetPointer(), folder + "/a." + extension, metadata);
    WriteVolume<float>(image.GetPointer(), folder + "/b." + extension, metadata);
    const std::string bytes = shapeton::ReadFileBytes(folder + "/a." + extension);
    EXPECT_EQ(bytes, shapeton::ReadFileBytes(folder + "/b." + extension));
    EXPECT_TRUE(Contains(bytes, extension == "nrrd" ? "tool:=Test\n" : "tool = Test\n"));
    EXPECT_TRUE(Contains(bytes, "two lines"));
    EXPECT_EQ(ReadVolume(folder + "/a." + extension).image->GetBufferPointer()[7], image->GetBufferPointer()[7]);
  }
}

TEST(VolumeWriter, LabelsAreCompressedAndIntensitiesAreNot)
{
  const std::string folder = TestFolder();
  const auto        labels = basetest::NewImage<itk::Image<unsigned char, 3>>({ { 64, 64, 64 } });
  WriteVolume<unsigned char>(labels.GetPointer(), folder + "/labels.nrrd");
  EXPECT_LT(shapeton::ReadFileBytes(folder + "/labels.nrrd").size(), 64u * 64u);
  const auto image = MakeOblique<float>();
  WriteVolume<float>(image.GetPointer(), folder + "/image.nrrd");
  EXPECT_TRUE(Contains(shapeton::ReadFileBytes(folder + "/image.nrrd"), "encoding: raw"));
}

TEST(VolumeWriter, Failures)
{
  const auto image = MakeOblique<float>();
  EXPECT_THROW(WriteVolume<float>(image.GetPointer(), TestFolder() + "/image.png"), shapeton::ParameterError);
  EXPECT_THROW(WriteVolume<float>(image.GetPointer(), TestFolder() + "/missing/image.nrrd"), shapeton::OutputError);
}

TEST(VolumeWriter, AFullDiskIsNoticed)
{
  // A file size limit simulates a full disk; compressed and raw formats detect it at different points.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit tiny{ 120, before.rlim_max };
  const auto   handler = std::signal(SIGXFSZ, SIG_IGN);
  const auto   image = MakeOblique<float>();
  const auto   labels = MakeOblique<short>();
  for (const std::string name : { "full.nrrd", "full.nii", "full.nii.gz", "full.mha" })
  {
    const std::string path = TestFolder() + "/" + name;
    setrlimit(RLIMIT_FSIZE, &tiny);
    EXPECT_THROW(WriteVolume<float>(image.GetPointer(), path), shapeton::OutputError) << name;
    EXPECT_THROW(WriteVolume<short>(labels.GetPointer(), path), shapeton::OutputError) << name;
    setrlimit(RLIMIT_FSIZE, &before);
  }
  const auto zeros = basetest::NewImage<itk::Image<short, 3>>({ { 90, 90, 90 } });
  for (const std::string name : { "zeros.nrrd", "zeros.nii.gz", "zeros.mha" })
  {
    const std::string path = TestFolder() + "/" + name;
    WriteVolume<short>(zeros.GetPointer(), path);
    const rlimit tooSmall{ std::filesystem::file_size(path) - 2, before.rlim_max };
    std::filesystem::remove(path);
    setrlimit(RLIMIT_FSIZE, &tooSmall);
    EXPECT_THROW(WriteVolume<short>(zeros.GetPointer(), path), shapeton::OutputError) << name;
    setrlimit(RLIMIT_FSIZE, &before);
  }
  std::signal(SIGXFSZ, handler);
}

TEST(VolumeWriter, ADeviceIsNoFile)
{
  const auto        image = MakeOblique<float>();
  const std::string link = TestFolder() + "/full.nrrd";
  std::filesystem::create_symlink("/dev/full", link);
  EXPECT_THROW(WriteVolume<float>(image.GetPointer(), link), shapeton::OutputError);
}

TEST(VolumeWriter, ToShortOnlyWithoutLoss)
{
  const auto image = MakeOblique<float>();
  EXPECT_TRUE(shapeton::ToShort(image).IsNull()); // eighths
  for (unsigned int i = 0; i < 60; ++i)
  {
    image->GetBufferPointer()[i] = static_cast<float>(i) * 1000 - 30000;
  }
  const auto whole = shapeton::ToShort(image);
  ASSERT_TRUE(whole.IsNotNull());
  EXPECT_EQ(whole->GetBufferPointer()[59], 29000);
  EXPECT_EQ(whole->GetDirection(), image->GetDirection());
  image->GetBufferPointer()[3] = 32768;
  EXPECT_TRUE(shapeton::ToShort(image).IsNull());
  image->GetBufferPointer()[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(shapeton::ToShort(image).IsNull());
}

// ---- NRRD ----

TEST(ImageFile, NrrdIdentityIsTheDigestOfTheFile)
{
  const Volume volume = ReadVolume(WriteNrrd(EightBytes));
  EXPECT_EQ(volume.identity.size(), std::string("sha256:").size() + 64);
  EXPECT_EQ(volume.image->GetPixel({ { 1, 1, 1 } }), 97.0F);
  EXPECT_TRUE(volume.modality.empty());
}

TEST(ImageFile, AFourthDimensionMustHaveSizeOne)
{
  const Volume volume = ReadVolume(WriteNrrd("type: uchar\ndimension: 4\nsizes: 2 2 2 1\nencoding: raw\n"));
  EXPECT_EQ(volume.image->GetLargestPossibleRegion().GetSize()[2], 2u);
  EXPECT_TRUE(Contains(RefusalOf(WriteNrrd("type: uchar\ndimension: 4\nsizes: 2 2 1 2\nencoding: raw\n")),
                       "a series of 2 volumes"));
}

TEST(ImageFile, HeadersThatClaimTooMuchAreRefusedBeforeAllocation)
{
  const std::string raw =
    RefusalOf(WriteNrrd("type: float\ndimension: 3\nsizes: 60000 60000 60000\nendian: little\nencoding: raw\n"));
  EXPECT_TRUE(Contains(raw, "truncated: the header states 60000x60000x60000 voxels")) << raw;
  const std::string gzip =
    RefusalOf(WriteNrrd("type: float\ndimension: 3\nsizes: 3000 3000 3000\nendian: little\nencoding: gzip\n"));
  EXPECT_TRUE(Contains(gzip, "truncated: ")) << gzip;
  const std::string overflow =
    RefusalOf(WriteNrrd("type: uchar\ndimension: 3\nsizes: 4294967296 4294967296 4294967296\nencoding: raw\n"));
  EXPECT_FALSE(overflow.empty());
}

TEST(ImageFile, NonFiniteVoxelsAreCountedAndTheFirstIsNamed)
{
  const float       voxels[8] = { 1, 1, 1, 1, 1, std::numeric_limits<float>::quiet_NaN(), 1, INFINITY };
  const std::string message =
    RefusalOf(WriteNrrd("type: float\ndimension: 3\nsizes: 2 2 2\nendian: little\nencoding: raw\n",
                        std::string(reinterpret_cast<const char *>(voxels), sizeof(voxels))));
  EXPECT_TRUE(Contains(message, "2 of 8 voxels are not finite numbers, the first at index (1, 0, 1)")) << message;
}

TEST(ImageFile, UnsuitableKindsAreNamed)
{
  EXPECT_TRUE(Contains(RefusalOf(WriteNrrd("type: uchar\ndimension: 2\nsizes: 2 4\nencoding: raw\n")), "a 2-D image"));
  EXPECT_TRUE(Contains(RefusalOf(WriteNrrd("type: uchar\ndimension: 4\nsizes: 3 2 2 2\nkinds: RGB-color domain domain "
                                           "domain\nencoding: raw\n",
                                           std::string(24, 'a'))),
                       "3 components"));
  EXPECT_TRUE(
    Contains(RefusalOf(WriteNrrd("type: uchar\ndimension: 3\nsizes: 2 4 1\nencoding: raw\n")), "a single slice"));
  EXPECT_TRUE(Contains(RefusalOf(WriteNrrd(EightBytes, "abc")), "truncated: "));
  shapeton::VolumeReadOptions options;
  options.seriesUID = "1.2";
  const std::string path = WriteNrrd(EightBytes);
  EXPECT_THROW(ReadVolume(path, options), shapeton::ParameterError);
}

TEST(ImageFile, UnusableGeometryIsRefused)
{
  const std::string head = "type: uchar\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\n";
  EXPECT_TRUE(Contains(RefusalOf(WriteNrrd(head + "space directions: (1,0,0) (0.3,1,0) (0,0,1)\nencoding: raw\n")),
                       "orthogonal"));
  EXPECT_FALSE(RefusalOf(WriteNrrd(head + "space directions: (1,0,0) (0,0,0) (0,0,1)\nencoding: raw\n")).empty());
  EXPECT_FALSE(RefusalOf(WriteNrrd(head + "space directions: (nan,0,0) (0,1,0) (0,0,1)\nencoding: raw\n")).empty());
}

TEST(ImageFile, AMissingSpacingIsNoted)
{
  const std::string meta = "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n";
  const std::string data = "ElementDataFile = LOCAL\n" + std::string(Bytes8);
  const auto        notesOfMeta = [&](const std::string & spacing) {
    const std::string path = TestFolder() + "/spacing.mha";
    shapeton::WriteText(path, meta + spacing + data);
    return ReadVolume(path).notes.size();
  };
  const auto notesOfNrrd = [&](const std::string & spacing) {
    return ReadVolume(WriteNrrd(EightBytes + spacing)).notes.size();
  };
  const auto notesOfNifti = [](double spacing) {
    niftitest::NiftiFile file;
    file.SetCodes(1, 0); // without a matrix
    file.SetPixdim({ 1, 1, spacing, 1 });
    const std::string path = TestFolder() + "/image.nii";
    shapeton::WriteText(path, file.Single());
    return ReadVolume(path).notes.size();
  };
  EXPECT_EQ(notesOfNrrd(""), 1u);
  EXPECT_EQ(notesOfNrrd("spacings: 1 nan 1\n"), 1u);
  EXPECT_EQ(notesOfNrrd("spacings: 1 2 1\n"), 0u);
  EXPECT_EQ(notesOfNrrd("space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"), 0u);
  EXPECT_EQ(notesOfMeta(""), 1u);
  EXPECT_EQ(notesOfMeta("ElementSpacing = 1 2 3\n"), 0u);
  EXPECT_EQ(notesOfNifti(0.0), 1u);
  EXPECT_EQ(notesOfNifti(1.0), 0u);
}

TEST(ImageFile, DetachedDataBelongToTheIdentity)
{
  const std::string folder = TestFolder();
  shapeton::WriteText(
    folder + "/a.mhd",
    "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = a.raw\n");
  EXPECT_TRUE(Contains(RefusalOf(folder + "/a.mhd"), "a.raw is missing"));
  shapeton::WriteText(folder + "/a.raw", Bytes8);
  const std::string first = ReadVolume(folder + "/a.mhd").identity;
  shapeton::WriteText(folder + "/a.raw", "abcdefgh");
  EXPECT_NE(ReadVolume(folder + "/a.mhd").identity, first);
  shapeton::WriteText(folder + "/a.raw", "abc");
  EXPECT_TRUE(Contains(RefusalOf(folder + "/a.mhd"), "truncated: "));
  shapeton::WriteText(folder + "/a.nhdr",
                      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: a.raw\n");
  shapeton::WriteText(folder + "/a.raw", Bytes8);
  EXPECT_EQ(ReadVolume(folder + "/a.nhdr").image->GetPixel({ { 0, 1, 1 } }), 97.0F);
}

TEST(ImageFile, TruncatedAndDamagedVoxelsAreNoticedInEachFormat)
{
  const std::string folder = TestFolder();
  const auto        image = MakeOblique<short>();
  for (const std::string name : { "a.nrrd", "a.mha", "a.nii.gz", "a.nii" })
  {
    const std::string path = folder + "/" + name;
    WriteVolume<short>(image.GetPointer(), path);
    const std::string whole = shapeton::ReadFileBytes(path);
    for (const std::size_t lost : { 1, 9, 40 })
    {
      shapeton::WriteText(path, whole.substr(0, whole.size() - lost));
      EXPECT_TRUE(Contains(RefusalOf(path), "truncated: ")) << name << " " << lost;
    }
    if (name != "a.nii") // raw voxels have no checksum
    {
      std::string damaged = whole;
      damaged[whole.size() - 30] = static_cast<char>(damaged[whole.size() - 30] ^ 0x55);
      shapeton::WriteText(path, damaged);
      EXPECT_FALSE(RefusalOf(path).empty()) << name;
    }
    shapeton::WriteText(path, whole);
    EXPECT_EQ(ReadVolume(path).image->GetPixel({ { 2, 1, 1 } }), image->GetPixel({ { 2, 1, 1 } })) << name;
  }
}

TEST(ImageFile, SeveralGzipMembersAreOneStream)
{
  const std::string bytes = niftitest::NiftiFile().Single();
  const std::string path = TestFolder() + "/image.nii.gz";
  niftitest::WriteBytes(path, bytes.substr(0, 352), "wb");
  niftitest::WriteBytes(path, bytes.substr(352, 40), "ab");
  EXPECT_TRUE(Contains(RefusalOf(path), "truncated: it contains 40 of 96 bytes"));
  niftitest::WriteBytes(path, bytes.substr(392), "ab");
  EXPECT_EQ(ReadVolume(path).image->GetPixel({ { 1, 2, 3 } }), 23.0F);
}

TEST(ImageFile, FilesOfOtherKindsAreNamed)
{
  const std::string folder = TestFolder();
  for (const std::string name : { "a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.txt", "a.nhdr", "a.mhd" })
  {
    shapeton::WriteText(folder + "/" + name, "no image at all\n");
    EXPECT_TRUE(Contains(RefusalOf(folder + "/" + name), folder + "/" + name)) << name;
    shapeton::WriteText(folder + "/" + name, "");
    EXPECT_FALSE(RefusalOf(folder + "/" + name).empty()) << name;
  }
  EXPECT_TRUE(Contains(RefusalOf(folder + "/missing.nrrd"), "does not exist"));
}
