#include "shapetonImageFile.h"
#include "shapetonNiftiTestFile.h"
#include "shapetonTestFolder.h"

#include "itkNiftiImageIO.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

namespace
{
using niftitest::NiftiFile;
using niftitest::WriteBytes;
using shapeton::ReadImageFile;
using shapeton::Volume;
using Point = std::array<double, 3>;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/** The volume of a single-file image. */
Volume
Read(const NiftiFile & file, std::size_t offset = 0)
{
  const basetest::Folder folder;
  WriteBytes(folder / "a.nii", file.Single(offset));
  return ReadImageFile(folder / "a.nii");
}

std::string
FaultOf(const NiftiFile & file)
{
  return basetest::MessageOf([&] { Read(file); });
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

/** Whether there is exactly one note, and it has this text. */
testing::AssertionResult
HasOnlyNote(const Volume & volume, const std::string & part)
{
  if (volume.notes.size() == 1 && Contains(volume.notes[0], part))
  {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << volume.notes.size()
                                     << " notes: " << (volume.notes.empty() ? "" : volume.notes.front());
}

Point
PlaceOf(const Volume & volume, const itk::Index<3> & index)
{
  Volume::ImageType::PointType point;
  volume.image->TransformIndexToPhysicalPoint(index, point);
  return { point[0], point[1], point[2] };
}

// ---- units: a rotation around z with cosine .6, spacing .5 x .75 x 2 mm, origin (-12.5, 30.25, 100) mm in RAS ----

/** Expected LPS position of an index. */
Point
TruePlace(const itk::Index<3> & i)
{
  const double x = 0.6 * 0.5 * i[0] - 0.8 * 0.75 * i[1] - 12.5;
  const double y = 0.8 * 0.5 * i[0] + 0.6 * 0.75 * i[1] + 30.25;
  return { -x, -y, 2.0 * i[2] + 100.0 };
}

NiftiFile
ObliqueFile(int version, bool isSwapped, bool hasSform, int unit)
{
  const double scale = unit == 1 ? 0.001 : unit == 3 ? 1000.0 : 1.0; // units of the file per mm
  NiftiFile    file(version, isSwapped);
  file.SetUnits(unit + 8); // and seconds
  file.SetCodes(hasSform ? 0 : 1, hasSform ? 2 : 0);
  file.SetPixdim({ 1, 0.5 * scale, 0.75 * scale, 2 * scale });
  file.SetQform({ 0, 0, std::sqrt(0.2), -12.5 * scale, 30.25 * scale, 100 * scale }); // sine of half the angle
  file.SetSform({ 0.3 * scale,
                  -0.6 * scale,
                  0,
                  -12.5 * scale,
                  0.4 * scale,
                  0.45 * scale,
                  0,
                  30.25 * scale,
                  0,
                  0,
                  2 * scale,
                  100 * scale });
  if (!hasSform)
  {
    file.SetSform({ 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9 }); // ignored
  }
  return file;
}

/** Writes a file for each variant; returns their names. */
std::vector<std::string>
WriteEachKind(const basetest::Folder & folder, const NiftiFile & file)
{
  WriteBytes(folder / "a.nii", file.Single());
  WriteBytes(folder / "a.nii.gz", file.Single(), "wb");
  WriteBytes(folder / "b.hdr", file.HeaderOfPair());
  WriteBytes(folder / "b.img", file.voxels);
  WriteBytes(folder / "c.hdr.gz", file.HeaderOfPair(), "wb");
  WriteBytes(folder / "c.img.gz", file.voxels, "wb");
  WriteBytes(folder / "D.HDR", file.HeaderOfPair());
  WriteBytes(folder / "D.IMG", file.voxels);
  WriteBytes(folder / "deflated.nii", file.Single(), "wb"); // compressed despite its name
  WriteBytes(folder / "raw.nii.gz", file.Single());
  return {
    "a.nii", "a.nii.gz", "b.hdr", "b.img", "c.hdr.gz", "c.img.gz", "D.HDR", "D.IMG", "deflated.nii", "raw.nii.gz"
  };
}

TEST(Nifti, UnitsOfLengthApplyToSpacingAndOrigin)
{
  for (int variant = 0; variant < 32; ++variant)
  {
    const int              unit = variant / 8;
    const NiftiFile        file = ObliqueFile(1 + variant % 2, variant / 2 % 2 == 1, variant / 4 % 2 == 1, unit);
    const basetest::Folder folder;
    for (const std::string & name : WriteEachKind(folder, file))
    {
      const Volume        volume = ReadImageFile(folder / name);
      const itk::Index<3> corner{ { 1, 2, 3 } };
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(PlaceOf(volume, { { 0, 0, 0 } })[axis], TruePlace({ { 0, 0, 0 } })[axis], 1e-5) << name << variant;
        EXPECT_NEAR(PlaceOf(volume, corner)[axis], TruePlace(corner)[axis], 1e-5) << name << variant;
      }
      EXPECT_EQ(volume.image->GetPixel(corner), 23.0F) << name << variant;
      EXPECT_EQ(volume.notes.size(), unit == 1 || unit == 3 ? 1u : 0u) << name << variant;
    }
  }
}

TEST(Nifti, UnknownUnitsAreMillimetersWithANote)
{
  NiftiFile file;
  file.SetUnits(5);
  const Volume volume = Read(file);
  EXPECT_EQ(volume.image->GetSpacing()[0], 1.0);
  EXPECT_TRUE(HasOnlyNote(volume, "unknown unit of length 5"));
}

// ITK's reader is the reference where applicable: mm, an sform that agrees with pixdim, or a qform.
TEST(Nifti, GeometryIsThatOfITKForRandomRotations)
{
  std::mt19937                     random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 40; ++trial)
  {
    double       q[4] = { normal(random), normal(random), normal(random), normal(random) };
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double & number : q)
    {
      number /= q[0] < 0 ? -norm : norm; // the scalar part is nonnegative in NIfTI
    }
    NiftiFile file(1, trial % 2 == 1);
    file.SetUnits(2);
    file.SetCodes(1, 0);
    file.SetPixdim({ trial % 4 < 2 ? 1.0 : -1.0, 0.7, 0.8, 1.5 });
    file.SetQform({ q[1], q[2], q[3], 10 * q[0], -200 * q[1], 30 * q[2] });
    const basetest::Folder folder;
    WriteBytes(folder / "a.nii", file.Single());
    const Volume volume = ReadImageFile(folder / "a.nii");
    const auto   peer = itk::NiftiImageIO::New();
    peer->SetFileName(folder / "a.nii");
    peer->ReadImageInformation();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(volume.image->GetSpacing()[axis], peer->GetSpacing(axis), 1e-6);
      EXPECT_NEAR(volume.image->GetOrigin()[axis], peer->GetOrigin(axis), 1e-4);
      for (unsigned int row = 0; row < 3; ++row)
      {
        EXPECT_NEAR(volume.image->GetDirection()(row, axis), peer->GetDirection(axis)[row], 1e-6) << trial;
      }
    }
  }
}

// ---- orientation ----

TEST(Nifti, WithoutAValidMagicIsRefused)
{
  for (const std::string & magic : { std::string("xx1\0", 4), std::string(4, '\0'), std::string("n+2\0", 4) })
  {
    NiftiFile file;
    file.SetMagic(magic);
    const std::string fault = FaultOf(file);
    EXPECT_TRUE(Contains(fault, "\"n+1\" or \"ni1\"") && Contains(fault, "ANALYZE 7.5")) << fault;
    const basetest::Folder folder; // a pair, as in ANALYZE 7.5
    WriteBytes(folder / "a.hdr", file.Header());
    WriteBytes(folder / "a.img", file.voxels);
    EXPECT_EQ(basetest::MessageOf([&] { ReadImageFile(folder / "a.img"); }).find("InputError"), 0u);
  }
}

TEST(Nifti, AShearedSformIsRefusedWithItsAngle)
{
  NiftiFile file;
  file.SetSform({ 1, 0.05, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 });
  // acos(.05 / sqrt(1 + .05^2)) = 87.14 degrees
  const std::string fault = FaultOf(file);
  EXPECT_TRUE(Contains(fault, "not orthogonal: the angle between axis 1 and axis 2 is 87.14 degrees; resample"))
    << fault;
  EXPECT_FALSE(Contains(fault, "ITK ERROR"));
  EXPECT_FALSE(Contains(fault, "sform_code")); // without a qform the advice is omitted
  file.SetCodes(1, 1);
  EXPECT_TRUE(Contains(FaultOf(file), "set sform_code to 0 to use its qform"));
  file.SetCodes(1, 0); // as the message advises
  EXPECT_NO_THROW(Read(file));
}

TEST(Nifti, AnSformThatDisagreesWithPixdimIsTakenWithANote)
{
  NiftiFile file;
  file.SetSform({ 0, -0.8, 0, 5, 1.2, 0, 0, 6, 0, 0, 3, 7 });
  file.SetPixdim({ 1, 1.2, 0.8, 3 });
  EXPECT_TRUE(Read(file).notes.empty());
  file.SetPixdim({ 1, 0.9, 0.9, 1.2 });
  const Volume volume = Read(file);
  EXPECT_TRUE(
    HasOnlyNote(volume, "pixdim, 0.9 x 0.9 x 1.2, differs from that of the sform, 1.2 x 0.8 x 3, which is used"));
  const Point place = PlaceOf(volume, { { 1, 1, 1 } });
  EXPECT_NEAR(place[0], -(5 - 0.8), 1e-6);
  EXPECT_NEAR(place[1], -(6 + 1.2), 1e-6);
  EXPECT_NEAR(place[2], 10, 1e-6);
}

// The qform is the identity. The sform is the identity or flips x, which moves the far corner by 2 mm.
TEST(Nifti, AQformThatDisagreesWithTheSformIsNoted)
{
  NiftiFile file;
  file.SetCodes(1, 4);
  EXPECT_TRUE(Read(file).notes.empty());
  file.SetSform({ -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 });
  const Volume volume = Read(file);
  EXPECT_TRUE(HasOnlyNote(volume, "sform (code 4) and qform (code 1) place the volume up to 2 mm apart"));
  EXPECT_EQ(PlaceOf(volume, { { 1, 0, 0 } }), (Point{ 1, 0, 0 }));
  file.SetQform({ NotANumber, 0, 0, 0, 0, 0 }); // cannot be compared
  EXPECT_TRUE(Read(file).notes.empty());
}

TEST(Nifti, WithoutCodesOrientationIsUnknown)
{
  NiftiFile file;
  file.SetCodes(0, 0);
  file.SetPixdim({ 1, 0.5, 0.75, 2 });
  const Volume volume = Read(file);
  EXPECT_TRUE(HasOnlyNote(volume, "left and right"));
  EXPECT_EQ(PlaceOf(volume, { { 1, 2, 3 } }), (Point{ 0.5, 1.5, 6.0 }));
  EXPECT_TRUE(volume.image->GetDirection().GetVnlMatrix().is_identity());
}

TEST(Nifti, SignsOfPixdim)
{
  NiftiFile file;
  file.SetCodes(1, 0);
  file.SetPixdim({ -1, 1, 1, 2 }); // qfac: the third axis is reversed
  EXPECT_EQ(PlaceOf(Read(file), { { 0, 0, 1 } }), (Point{ 0, 0, -2 }));
  file.SetPixdim({ 0, 1, 1, 2 }); // counts as 1
  EXPECT_EQ(PlaceOf(Read(file), { { 0, 0, 1 } }), (Point{ 0, 0, 2 }));
  file.SetPixdim({ 1, -1, 1, 2 });
  const Volume volume = Read(file);
  EXPECT_TRUE(HasOnlyNote(volume, "pixdim[1] = -1"));
  EXPECT_EQ(PlaceOf(volume, { { 1, 0, 0 } }), (Point{ -1, 0, 0 }));
}

// VNL's warning for a matrix with subnormal numbers must not be printed to standard error.
TEST(Nifti, DenormalCosinesAreZero)
{
  NiftiFile file(2);
  file.SetSform({ -1, 1e-312, 0, 0, -1e-320, -1, 1e-308, 0, 0, 2e-314, 1, 0 });
  testing::internal::CaptureStderr();
  const Volume volume = Read(file);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(volume.image->GetDirection().GetVnlMatrix().is_identity());
}

TEST(Nifti, NumbersThatAreNoGeometryAreRefused)
{
  NiftiFile nan;
  nan.SetSform({ 1, 0, 0, NotANumber });
  EXPECT_TRUE(Contains(FaultOf(nan), "sform (srow_x, srow_y, srow_z) is not finite"));
  NiftiFile flat;
  flat.SetSform({ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0 });
  EXPECT_TRUE(Contains(FaultOf(flat), "axis 3 of its sform has zero length"));
  NiftiFile turned;
  turned.SetCodes(1, 0);
  turned.SetQform({ 1, 1, 0, 0, 0, 0 });
  EXPECT_TRUE(Contains(FaultOf(turned), "quatern_b, c, d = 1, 1, 0 is longer than 1"));
}

// ---- voxels ----

template <typename TVoxel>
void
ExpectVoxelsOf(int datatype)
{
  for (const bool isSwapped : { false, true })
  {
    NiftiFile file(1, isSwapped);
    file.SetVoxels<TVoxel>(datatype);
    EXPECT_EQ(Read(file).image->GetPixel({ { 1, 2, 3 } }), 23.0F) << datatype;
    file.SetScale(0.5, -10);
    EXPECT_EQ(Read(file).image->GetPixel({ { 1, 2, 3 } }), 1.5F) << datatype;
  }
}

TEST(Nifti, EachTypeOfVoxelInBothByteOrders)
{
  ExpectVoxelsOf<std::uint8_t>(2);
  ExpectVoxelsOf<std::int16_t>(4);
  ExpectVoxelsOf<std::int32_t>(8);
  ExpectVoxelsOf<float>(16);
  ExpectVoxelsOf<double>(64);
  ExpectVoxelsOf<std::int8_t>(256);
  ExpectVoxelsOf<std::uint16_t>(512);
  ExpectVoxelsOf<std::uint32_t>(768);
  ExpectVoxelsOf<std::int64_t>(1024);
  ExpectVoxelsOf<std::uint64_t>(1280);
  NiftiFile file;
  file.SetVoxels<float>(128);
  EXPECT_TRUE(Contains(FaultOf(file), "3 components"));
  file.SetVoxels<float>(1536);
  EXPECT_TRUE(Contains(FaultOf(file), "datatype = 1536"));
}

TEST(Nifti, ASlopeOfZeroOrNaNMeansNone)
{
  for (const double slope : { 0.0, NotANumber })
  {
    NiftiFile file;
    file.SetScale(slope, 100);
    EXPECT_EQ(Read(file).image->GetPixel({ { 1, 2, 3 } }), 23.0F) << slope;
  }
  NiftiFile file;
  file.SetScale(2, NotANumber);
  EXPECT_TRUE(Contains(FaultOf(file), "scl_inter is not a finite number"));
}

TEST(Nifti, VoxelsThatAreNotFiniteAreRefused)
{
  NiftiFile   file;
  const float bad = std::numeric_limits<float>::infinity();
  std::memcpy(&file.voxels[4 * 5], &bad, sizeof(bad));
  EXPECT_TRUE(Contains(FaultOf(file), "1 of 24 voxels are not finite numbers, the first at index (1, 2, 0)"));
}

TEST(Nifti, FurtherDimensionsOfOneVoxel)
{
  NiftiFile file;
  file.SetDimensions({ 5, 2, 3, 4, 1, 0, 9, 9 });
  EXPECT_EQ(Read(file).image->GetPixel({ { 1, 2, 3 } }), 23.0F);
  file.SetDimensions({ 4, 2, 3, 2, 2 });
  EXPECT_TRUE(Contains(FaultOf(file), "a series of 2 volumes (dimension 4)"));
  file.SetDimensions({ 2, 6, 4 });
  EXPECT_TRUE(Contains(FaultOf(file), "a 2-D image"));
  file.SetDimensions({ 9, 2, 3, 4 });
  EXPECT_TRUE(Contains(FaultOf(file), "dim[0], the number of dimensions, is 9"));
  file.SetDimensions({ 3, 2, -3, 4 });
  EXPECT_TRUE(Contains(FaultOf(file), "dim[2], a number of voxels, is -3"));
  file.SetDimensions({ 3, 30000, 30000, 30000 });
  EXPECT_TRUE(Contains(FaultOf(file), "truncated: "));
}

TEST(Nifti, VoxelsBeginWhereTheHeaderSays)
{
  NiftiFile file;
  file.SetOffset(400);
  EXPECT_EQ(Read(file, 400).image->GetPixel({ { 1, 2, 3 } }), 23.0F);
  EXPECT_TRUE(Contains(FaultOf(file), "truncated: "));
  for (const double offset : { 0.0, -1.0, 347.0, 352.5, NotANumber })
  {
    file.SetOffset(offset);
    EXPECT_TRUE(Contains(FaultOf(file), "vox_offset, the start of the voxels, is")) << offset;
  }
}

// ---- files of a pair ----

TEST(Nifti, BothFilesOfAPairAreOneVolume)
{
  const basetest::Folder folder;
  NiftiFile              file;
  WriteBytes(folder / "a.img", file.voxels);
  EXPECT_FALSE(shapeton::IsImageFile(folder / "a.img")); // it may be DICOM
  WriteBytes(folder / "a.hdr", file.HeaderOfPair());
  EXPECT_TRUE(shapeton::IsImageFile(folder / "a.img"));
  const std::string identity = ReadImageFile(folder / "a.hdr").identity;
  EXPECT_EQ(ReadImageFile(folder / "a.img").identity, identity);
  file.voxels[0] = 1;
  WriteBytes(folder / "a.img", file.voxels);
  EXPECT_NE(ReadImageFile(folder / "a.hdr").identity, identity);
  WriteBytes(folder / "lonely.hdr", file.HeaderOfPair());
  EXPECT_TRUE(Contains(basetest::MessageOf([&] { ReadImageFile(folder / "lonely.hdr"); }), "the .img file"));
}
} // namespace
