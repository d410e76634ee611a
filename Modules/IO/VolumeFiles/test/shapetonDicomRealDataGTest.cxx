#include "shapetonDicomSeriesScan.h"
#include "shapetonVolumeTesting.h"

#include "itkGDCMImageIO.h"
#include "itkImageFileReader.h"
#include "itkNiftiImageIO.h"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

namespace
{
using shapeton::ReadVolume;
using shapeton::Volume;
using shapeton::VolumeReadOptions;
namespace fs = std::filesystem;

#define SKIP_WITHOUT_DATA()                                                                                            \
  const std::string data = DataFolder();                                                                               \
  if (data.empty())                                                                                                    \
  {                                                                                                                    \
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";                                                               \
  }

std::string
DataFolder()
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  return folder && fs::is_directory(folder) ? folder : "";
}

std::vector<float>
ReadSingle(const std::string & path)
{
  VolumeReadOptions options;
  options.allowSingleSlice = true;
  const Volume volume = ReadVolume(path, options);
  const auto   count = volume.image->GetLargestPossibleRegion().GetNumberOfPixels();
  return { volume.image->GetBufferPointer(), volume.image->GetBufferPointer() + count };
}

/** A slice read by ITK, with another parser. */
std::vector<float>
ReadByITK(const std::string & path)
{
  const auto reader = itk::ImageFileReader<itk::Image<float, 3>>::New();
  reader->SetFileName(path);
  reader->SetImageIO(itk::GDCMImageIO::New());
  reader->Update();
  const auto count = reader->GetOutput()->GetLargestPossibleRegion().GetNumberOfPixels();
  return { reader->GetOutput()->GetBufferPointer(), reader->GetOutput()->GetBufferPointer() + count };
}
} // namespace

TEST(DicomRealData, LosslessEncodingsOfNemaSlicesAgree)
{
  SKIP_WITHOUT_DATA();
  const std::string                                     folder = data + "/dicom/nema_WG04_CT/";
  const std::map<std::string, std::vector<std::string>> slices = {
    { "CT1_UNC",
      { "CT1_UNC.explicit_little_endian.dcm",
        "CT1_UNC.implicit_little_endian.dcm",
        "CT1_UNC.explicit_big_endian.dcm",
        "CT1_JPLL",
        "CT1_JLSL",
        "CT1_J2KR",
        "CT1_RLE" } },
    { "CT2_UNC", { "CT2_JPLL", "CT2_JLSL", "CT2_J2KR", "CT2_RLE" } }
  };
  for (const auto & slice : slices)
  {
    const auto expected = ReadSingle(folder + slice.first);
    EXPECT_EQ(expected.size(), 512u * 512u);
    for (const std::string & name : slice.second)
    {
      EXPECT_EQ(ReadSingle(folder + name), expected) << name;
    }
  }
}

TEST(DicomRealData, NemaSlicesAgreeWithITKButForPadding)
{
  SKIP_WITHOUT_DATA();
  const std::string folder = data + "/dicom/nema_WG04_CT/";
  EXPECT_EQ(ReadSingle(folder + "CT2_UNC"), ReadByITK(folder + "CT2_UNC"));
  const auto  ours = ReadSingle(folder + "CT1_UNC");
  const auto  others = ReadByITK(folder + "CT1_UNC");
  std::size_t padding = 0;
  ASSERT_EQ(ours.size(), others.size());
  for (std::size_t i = 0; i < ours.size(); ++i)
  {
    const bool isPadding = others[i] == -3024.0F; // Pixel Padding Value -2000, intercept -1024
    padding += isPadding ? 1 : 0;
    ASSERT_EQ(ours[i], isPadding ? -1024.0F : others[i]);
  }
  EXPECT_EQ(padding, 55772u);
}

TEST(DicomRealData, EnhancedMultiFrameInAllEncodings)
{
  SKIP_WITHOUT_DATA();
  const std::string folder = data + "/dicom/enhanced_CT_multiframe/";
  const auto        expected = ReadVolume(folder + "CT0012.explicit_little_endian.dcm");
  EXPECT_EQ(expected.image->GetLargestPossibleRegion().GetSize()[2], 2u);
  EXPECT_DOUBLE_EQ(expected.image->GetSpacing()[2], 10.0);
  const auto count = expected.image->GetLargestPossibleRegion().GetNumberOfPixels();
  unsigned   lossless = 0;
  for (const auto & entry : fs::directory_iterator(folder))
  {
    const std::string name = entry.path().filename().string();
    const Volume      volume = ReadVolume(entry.path().string());
    ASSERT_EQ(volume.image->GetLargestPossibleRegion().GetNumberOfPixels(), count) << name;
    if (!shapeton::Contains(name, ".51.") && !shapeton::Contains(name, ".81."))
    {
      ++lossless;
      EXPECT_TRUE(std::equal(
        volume.image->GetBufferPointer(), volume.image->GetBufferPointer() + count, expected.image->GetBufferPointer()))
        << name;
    }
  }
  EXPECT_EQ(lossless, 9u);
}

TEST(DicomRealData, VisibleFemaleAnkle)
{
  SKIP_WITHOUT_DATA();
  const Volume volume = ReadVolume(data + "/ct/visible-female-ankle");
  const auto   size = volume.image->GetLargestPossibleRegion().GetSize();
  EXPECT_EQ(size[0], 512u);
  EXPECT_EQ(size[1], 512u);
  EXPECT_EQ(size[2], 150u);
  EXPECT_TRUE(volume.notes.empty());
  const auto slice = ReadByITK(data + "/ct/visible-female-ankle/vhf.70.dcm");
  const auto reader = itk::ImageFileReader<itk::Image<float, 3>>::New();
  reader->SetFileName(data + "/ct/visible-female-ankle/vhf.70.dcm");
  reader->SetImageIO(itk::GDCMImageIO::New());
  reader->Update();
  itk::Index<3> index;
  ASSERT_TRUE(volume.image->TransformPhysicalPointToIndex(reader->GetOutput()->GetOrigin(), index));
  EXPECT_TRUE(std::equal(slice.begin(), slice.end(), &volume.image->GetPixel(index)));
}

TEST(DicomRealData, TotalSegmentatorJpeg2000MatchesItsLabels)
{
  SKIP_WITHOUT_DATA();
  const Volume volume = ReadVolume(data + "/ct/totalsegmentator/example_ct_dicom");
  const Volume labels = ReadVolume(data + "/ct/totalsegmentator/example_seg_dicom.nii.gz");
  EXPECT_EQ(volume.image->GetLargestPossibleRegion(), labels.image->GetLargestPossibleRegion());
  EXPECT_EQ(volume.identity.compare(0, 7, "sha256:"), 0); // its UIDs were removed
  // The axes differ (LAS and LPS), but not the physical positions; compare by physical points, spleen = 1.
  double      sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < labels.image->GetLargestPossibleRegion().GetNumberOfPixels(); ++i)
  {
    if (labels.image->GetBufferPointer()[i] == 1.0F)
    {
      itk::Point<double, 3> point;
      itk::Index<3>         index;
      labels.image->TransformIndexToPhysicalPoint(labels.image->ComputeIndex(static_cast<itk::OffsetValueType>(i)),
                                                  point);
      ASSERT_TRUE(volume.image->TransformPhysicalPointToIndex(point, index));
      sum += volume.image->GetPixel(index);
      ++count;
    }
  }
  ASSERT_GT(count, 1000u);
  EXPECT_NEAR(sum / static_cast<double>(count), 80.0, 70.0); // soft tissue, with or without contrast
}

TEST(DicomRealData, EachFileOfPydicomGivesAVolumeOrANamedMessage)
{
  SKIP_WITHOUT_DATA();
  std::map<std::string, std::string> outcome;
  for (const auto & entry : fs::directory_iterator(data + "/dicom/pydicom_test_files"))
  {
    if (!entry.is_regular_file())
    {
      continue;
    }
    VolumeReadOptions options;
    options.allowSingleSlice = true;
    const std::string name = entry.path().filename().string();
    try
    {
      const Volume volume = ReadVolume(entry.path().string(), options);
      outcome[name] = "volume";
    }
    catch (const shapeton::InputError & error)
    {
      outcome[name] = error.what();
      EXPECT_TRUE(shapeton::Contains(error.what(), name)) << error.what();
    }
  }
  for (const char * name : { "CT_small.dcm",
                             "MR_small.dcm",
                             "MR_small_RLE.dcm",
                             "MR_small_bigendian.dcm",
                             "MR_small_expb.dcm",
                             "MR_small_implicit.dcm",
                             "MR_small_jp2klossless.dcm",
                             "MR_small_jpeg_ls_lossless.dcm",
                             "MR_small_padded.dcm",
                             "J2K_pixelrep_mismatch.dcm",
                             "693_J2KI.dcm",
                             "examples_overlay.dcm" })
  {
    EXPECT_EQ(outcome[name], "volume") << name;
  }
  const std::map<std::string, std::string> messages = { { "MR_truncated.dcm", "truncated: " },
                                                        { "rtplan_truncated.dcm", "truncated: " },
                                                        { "README.txt", "the file is not a DICOM image" },
                                                        { "test-SR.dcm", "the file is not a DICOM image" },
                                                        { "rtstruct.dcm", "RTStructureSetStorage" },
                                                        { "waveform_ecg.dcm", "the file is not a DICOM image" },
                                                        { "SC_rgb_jpeg_gdcm.dcm", "a color image" },
                                                        { "examples_palette.dcm", "PALETTE COLOR" },
                                                        { "liver_1frame.dcm", "a segmentation" },
                                                        { "rtdose_1frame.dcm", "a dose grid" },
                                                        { "image_dfl.dcm", "a 2-D image" },
                                                        { "JPEG2000.dcm", "a 2-D image" },
                                                        { "zipMR.gz", "the file is not a DICOM image" } };
  for (const auto & message : messages)
  {
    EXPECT_TRUE(shapeton::Contains(outcome[message.first], message.second)) << outcome[message.first];
  }
}

TEST(DicomRealData, EncodingsOfPydicomsMRAgree)
{
  SKIP_WITHOUT_DATA();
  const std::string folder = data + "/dicom/pydicom_test_files/";
  const auto        expected = ReadSingle(folder + "MR_small.dcm");
  for (const char * name : { "MR_small_RLE.dcm",
                             "MR_small_bigendian.dcm",
                             "MR_small_expb.dcm",
                             "MR_small_implicit.dcm",
                             "MR_small_jp2klossless.dcm",
                             "MR_small_jpeg_ls_lossless.dcm",
                             "MR_small_padded.dcm" })
  {
    EXPECT_EQ(ReadSingle(folder + name), expected) << name;
  }
  // Signed in the header, unsigned in the JPEG 2000 stream; air outside the field of view is -2000.
  EXPECT_EQ(ReadSingle(folder + "J2K_pixelrep_mismatch.dcm").front(), -2000.0F);
}

TEST(DicomRealData, FoldersWithDicomdirs)
{
  SKIP_WITHOUT_DATA();
  const std::string     folder = data + "/dicom/pydicom_test_files/dicomdirtests";
  const auto            scan = shapeton::ScanDicom(folder);
  std::set<std::string> usable;
  for (const auto & series : scan.series)
  {
    if (series.IsUsable())
    {
      usable.insert(series.description);
    }
  }
  EXPECT_EQ(usable, std::set<std::string>{ "SmartScore - Gated 0.5 sec" });
  const auto dicomdirs =
    std::count_if(scan.otherFiles.begin(), scan.otherFiles.end(), [](const shapeton::DicomDefect & file) {
      return shapeton::Contains(file.message, "MediaStorageDirectoryStorage");
    });
  EXPECT_GE(dicomdirs, 7);
  const Volume volume = ReadVolume(folder);
  EXPECT_EQ(volume.image->GetLargestPossibleRegion().GetSize()[2], 5u);
  EXPECT_FALSE(volume.notes.empty());
}

TEST(DicomRealData, NiftiAgreesWithITK)
{
  SKIP_WITHOUT_DATA();
  for (const char * name : { "/volumes/ch2.nii.gz", "/ct/totalsegmentator/example_ct.nii.gz" })
  {
    const Volume volume = ReadVolume(data + name);
    const auto   reader = itk::ImageFileReader<itk::Image<float, 3>>::New();
    reader->SetFileName(data + name);
    reader->SetImageIO(itk::NiftiImageIO::New());
    reader->Update();
    const auto * const other = reader->GetOutput();
    EXPECT_EQ(volume.image->GetOrigin(), other->GetOrigin());
    EXPECT_EQ(volume.image->GetDirection(), other->GetDirection());
    EXPECT_EQ(volume.image->GetSpacing(), other->GetSpacing());
    const auto count = other->GetLargestPossibleRegion().GetNumberOfPixels();
    EXPECT_TRUE(
      std::equal(other->GetBufferPointer(), other->GetBufferPointer() + count, volume.image->GetBufferPointer()));
  }
}
