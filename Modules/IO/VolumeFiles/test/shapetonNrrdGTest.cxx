#include "shapetonVolumeTesting.h"

#include "itk_zlib.h"

#include <bzlib.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

namespace
{
using shapeton::InputErrorOf;
using shapeton::ReadVolume;
using shapeton::TestFolder;

/** 2 x 2 x 2 voxels of 0 to 7 after these fields; spacing 2, 3, 4 unless they state directions. */
std::string
WriteNrrd(const std::string & fields, const std::string & data = "0 1 2 3 4 5 6 7\n")
{
  const bool        hasFrame = fields.find("spac") != std::string::npos;
  const std::string path = TestFolder() + "/volume.nrrd";
  shapeton::WriteText(path,
                      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\n" +
                        std::string(hasFrame ? "" : "spacings: 2 3 4\n") + fields + "encoding: text\n\n" + data);
  return path;
}

std::string
InSpace(const std::string & space, const std::string & more = "")
{
  return WriteNrrd("space: " + space + "\nspace directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (10,20,30)\n" +
                   more);
}

/** Position of voxel (1, 1, 1) in LPS. */
std::array<double, 3>
LastVoxelOf(const shapeton::Volume & volume)
{
  const auto point = volume.image->TransformIndexToPhysicalPoint<double>({ { 1, 1, 1 } });
  return { point[0], point[1], point[2] };
}

using Point = std::array<double, 3>;

namespace fs = std::filesystem;

const std::string voxels{ '\0', '\1', '\2', '\3', '\4', '\5', '\6', '\7' };

std::string
ContentOf(const std::string & path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

std::string
Gzipped(std::string data)
{
  constexpr int gzipWindow = MAX_WBITS + 16;
  constexpr int memory = 8;
  std::string   zipped(1000, '\0');
  z_stream      state{};
  deflateInit2(&state, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzipWindow, memory, Z_DEFAULT_STRATEGY);
  state.next_in = reinterpret_cast<Bytef *>(data.data());
  state.avail_in = static_cast<uInt>(data.size());
  state.next_out = reinterpret_cast<Bytef *>(zipped.data());
  state.avail_out = static_cast<uInt>(zipped.size());
  EXPECT_EQ(deflate(&state, Z_FINISH), Z_STREAM_END);
  zipped.resize(state.total_out);
  deflateEnd(&state);
  return zipped;
}

std::string
Bzipped(std::string data)
{
  constexpr int blocks = 9; // of 100,000 bytes
  std::string   zipped(1000, '\0');
  auto          size = static_cast<unsigned int>(zipped.size());
  const auto    length = static_cast<unsigned int>(data.size());
  EXPECT_EQ(BZ2_bzBuffToBuffCompress(zipped.data(), &size, data.data(), length, blocks, 0, 0), BZ_OK);
  return zipped.substr(0, size);
}
} // namespace

TEST(Nrrd, SpacesOfPatientsBecomeLps)
{
  EXPECT_EQ(LastVoxelOf(ReadVolume(InSpace("left-posterior-superior"))), (Point{ 12, 23, 34 }));
  EXPECT_EQ(LastVoxelOf(ReadVolume(InSpace("LPS"))), (Point{ 12, 23, 34 }));
  EXPECT_EQ(LastVoxelOf(ReadVolume(InSpace("right-anterior-superior"))), (Point{ -12, -23, 34 }));
  EXPECT_EQ(LastVoxelOf(ReadVolume(InSpace("RAS"))), (Point{ -12, -23, 34 }));
  EXPECT_EQ(LastVoxelOf(ReadVolume(InSpace("left-anterior-superior"))), (Point{ 12, -23, 34 }));
  EXPECT_EQ(LastVoxelOf(ReadVolume(InSpace("LAS"))), (Point{ 12, -23, 34 }));
  EXPECT_TRUE(ReadVolume(InSpace("LAS")).notes.empty());
}

TEST(Nrrd, OtherSpacesAreNamed)
{
  const shapeton::Volume volume = ReadVolume(InSpace("3D-right-handed"));
  ASSERT_EQ(volume.notes.size(), 1U);
  EXPECT_NE(volume.notes[0].find("does not state the orientation of a patient"), std::string::npos);
  EXPECT_EQ(LastVoxelOf(volume), (Point{ 12, 23, 34 }));
  EXPECT_NE(InputErrorOf([] { ReadVolume(InSpace("3D-left-handed")); }).find("left-handed"), std::string::npos);
  const shapeton::Volume unnamed =
    ReadVolume(WriteNrrd("space dimension: 3\nspace directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (10,20,30)\n"));
  ASSERT_EQ(unnamed.notes.size(), 1U);
  EXPECT_NE(unnamed.notes[0].find("its space without a name"), std::string::npos) << unnamed.notes[0];
}

TEST(Nrrd, UnitsBecomeMillimeters)
{
  const auto volume = ReadVolume(InSpace("LPS", "space units: \"cm\" \"cm\" \"cm\"\n"));
  EXPECT_EQ(LastVoxelOf(volume), (Point{ 120, 230, 340 }));
  EXPECT_EQ(volume.image->GetSpacing()[1], 30.0);
  ASSERT_EQ(volume.notes.size(), 1U);
  EXPECT_EQ(volume.notes[0], "lengths were converted from cm to mm");
  EXPECT_TRUE(ReadVolume(InSpace("LPS", "space units: \"mm\" \"mm\" \"mm\"\n")).notes.empty());
  EXPECT_EQ(ReadVolume(InSpace("LPS", "space units: \"furlong\" \"furlong\" \"furlong\"\n")).notes.size(), 1U);
  const auto error = InputErrorOf([] { ReadVolume(InSpace("LPS", "space units: \"mm\" \"mm\" \"m\"\n")); });
  EXPECT_NE(error.find("different units"), std::string::npos) << error;
}

TEST(Nrrd, WordsInsteadOfNumbersAreRefused)
{
  for (const std::string word : { "x", "nan", "inf", "1e999" })
  {
    const auto error = InputErrorOf([&] {
      ReadVolume(
        WriteNrrd("space: LPS\nspace directions: (2,0,0) (0," + word + ",0) (0,0,4)\nspace origin: (0,0,0)\n"));
    });
    EXPECT_NE(error.find("\"space directions\" contains \"" + word + '"'), std::string::npos) << error;
  }
  const auto error = InputErrorOf([] { ReadVolume(WriteNrrd("spacings: 2 two 4\n")); });
  EXPECT_NE(error.find("\"spacings\" contains \"two\""), std::string::npos) << error;
  EXPECT_EQ(ReadVolume(WriteNrrd("spacings: 2 nan 4\n")).notes.size(), 1U); // states none
}

TEST(Nrrd, OldSegmentationsOfSlicerAreAtTheirExtent)
{
  const std::string extent = "Segmentation_Extent:=60 61 40 41 8 9\n";
  const auto        volume = ReadVolume(InSpace("RAS", extent));
  EXPECT_EQ(LastVoxelOf(volume), (Point{ -(10 + 2 * 61), -(20 + 3 * 41), 30 + 4 * 9 }));
  ASSERT_EQ(volume.notes.size(), 1U);
  EXPECT_NE(volume.notes[0].find("Segmentation_Extent"), std::string::npos);
  const auto recent = ReadVolume(InSpace("RAS", extent + "Segmentation_ReferenceImageExtentOffset:=60 40 8\n"));
  EXPECT_EQ(LastVoxelOf(recent), (Point{ -12, -23, 34 }));
}

TEST(Nrrd, LinesAndBytesBeforeGzipDataAreSkipped)
{
  const std::string path = TestFolder() + "/volume.nrrd";
  const auto        read = [&](const std::string & fields, const std::string & lines, const std::string & bytes) {
    shapeton::WriteText(path,
                        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: gzip\n" +
                          fields + '\n' + lines + Gzipped(bytes + voxels));
    return ReadVolume(path).image->GetPixel({ { 1, 0, 1 } });
  };
  EXPECT_EQ(read("", "", ""), 5.0F);
  EXPECT_EQ(read("line skip: 3\n", "one\n\nthree\n", ""), 5.0F);
  EXPECT_EQ(read("byte skip: 4\n", "", "abcd"), 5.0F);
  EXPECT_EQ(read("line skip: 1\nbyteskip: 2\n", "a line\n", "ab"), 5.0F);
  EXPECT_NE(InputErrorOf([&] { read("byte skip: -1\n", "", ""); }).find("negative"), std::string::npos);
}

TEST(Nrrd, DataMayBeSplitAndCompressed)
{
  const std::string folder = TestFolder();
  const std::string halves[]{ voxels.substr(0, 4), voxels.substr(4) };
  for (const int i : { 0, 1 })
  {
    const std::string stem = folder + "/part 0" + std::to_string(i + 7);
    shapeton::WriteText(stem + ".raw", halves[i]);
    shapeton::WriteText(stem + ".gz", Gzipped(halves[i]));
    shapeton::WriteText(stem + ".bz2", Bzipped(halves[i]));
  }
  const auto read = [&](const std::string & encoding, const std::string & files) {
    const std::string path = folder + "/volume.nhdr";
    shapeton::WriteText(path,
                        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: " + encoding +
                          "\ndata file: " + files);
    return ReadVolume(path);
  };
  EXPECT_EQ(read("raw", "LIST\npart 07.raw\npart 08.raw\n").image->GetPixel({ { 1, 0, 1 } }), 5.0F);
  EXPECT_EQ(read("gzip", "LIST\npart 07.gz\npart 08.gz\n").image->GetPixel({ { 1, 0, 1 } }), 5.0F);
  const shapeton::Volume volume = read("bzip2", "LIST\npart 08.bz2\npart 07.bz2\n");
  EXPECT_EQ(volume.image->GetPixel({ { 1, 0, 1 } }), 1.0F);
  EXPECT_NE(volume.identity, read("bzip2", "LIST\npart 07.bz2\npart 08.bz2\n").identity);
  const auto missing = InputErrorOf([&] { read("raw", "LIST\npart 07.raw\npart 09.raw\n"); });
  EXPECT_NE(missing.find("part 09.raw is missing"), std::string::npos) << missing;
  const auto pattern = InputErrorOf([&] { read("raw", "part%s.raw 7 8 1\n"); });
  EXPECT_NE(pattern.find("names no data file"), std::string::npos) << pattern;

  fs::rename(folder + "/part 07.raw", folder + "/part07.raw");
  fs::rename(folder + "/part 08.raw", folder + "/part08.raw");
  EXPECT_EQ(read("raw", "part%02d.raw 7 8 1\n").image->GetPixel({ { 1, 0, 1 } }), 5.0F);
  EXPECT_EQ(read("raw", "part%02d.raw 8 7 -1\n").image->GetPixel({ { 1, 0, 1 } }), 1.0F);
}

TEST(Nrrd, CompressedVoxelsMayBeBigEndian)
{
  const std::string path = TestFolder() + "/volume.nrrd";
  std::string       shorts;
  for (const char value : voxels)
  {
    shorts += { '\1', value };
  }
  shapeton::WriteText(path,
                      "NRRD0004\ntype: short\nendian: big\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\n"
                      "encoding: bz2\n\n" +
                        Bzipped(shorts));
  EXPECT_EQ(ReadVolume(path).image->GetPixel({ { 1, 0, 1 } }), 261.0F);
  shapeton::WriteText(path, ContentOf(path).substr(0, 120));
  EXPECT_NE(InputErrorOf([&] { ReadVolume(path); }).find("truncated"), std::string::npos);
}

TEST(Nrrd, MoreDataThanTheHeaderDescribesAreNoted)
{
  const std::string path = TestFolder() + "/volume.nrrd";
  const auto        notesOf = [&](const std::string & encoding, const std::string & data) {
    shapeton::WriteText(
      path, "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\n" + encoding + "\n\n" + data);
    const shapeton::Volume volume = ReadVolume(path);
    EXPECT_EQ(volume.image->GetPixel({ { 1, 0, 1 } }), 5.0F);
    return volume.notes;
  };
  const std::string more = voxels + "more";
  for (const auto & [encoding, data] : std::map<std::string, std::string>{ { "encoding: raw", more },
                                                                           { "encoding: gzip", Gzipped(more) },
                                                                           { "encoding: gz", Gzipped(voxels) + "more" },
                                                                           { "encoding: bzip2", Bzipped(more) },
                                                                           { "encoding: text", "0 1 2 3 4 5 6 7 8" } })
  {
    const auto notes = notesOf(encoding, data);
    ASSERT_EQ(notes.size(), 1U) << encoding;
    EXPECT_NE(notes[0].find("more voxels than its header describes"), std::string::npos);
  }
  EXPECT_TRUE(notesOf("byte skip: 4\nencoding: raw", "more" + voxels).empty());
  EXPECT_TRUE(notesOf("byte skip: -1\nencoding: raw", "more" + voxels).empty());
  EXPECT_TRUE(notesOf("line skip: 1\nencoding: raw", "more\n" + voxels).empty());
}

TEST(Nrrd, DefectsOfTheHeaderAreNamed)
{
  const auto errorOf = [](std::string fields) {
    const std::string path = TestFolder() + "/volume.nrrd";
    shapeton::WriteText(path, "NRRD0004\n" + fields + "\n" + voxels);
    return InputErrorOf([&] { ReadVolume(path); });
  };
  const std::string three = "dimension: 3\nsizes: 2 2 2\n";
  const auto        expect = [&](const std::string & fields, const std::string & message) {
    const auto error = errorOf(fields);
    EXPECT_NE(error.find(message), std::string::npos) << error;
  };
  expect(three + "encoding: raw\n", "field \"type\" is missing");
  expect("type: uchar\ndimension: 3\nencoding: raw\n", "field \"sizes\" is missing");
  expect("type: quux\n" + three + "encoding: raw\n", "its type, \"quux\", is not one of NRRD");
  expect("type: short\n" + three + "encoding: raw\n", "field \"endian\" is missing");
  expect("type: uchar\ndimension: 3\nsizes: 2 2\nencoding: raw\n", "\"sizes\" has 2 words instead of 3");
  expect("type: uchar\ndimension: 3\nsizes: 2 -2 2\nencoding: raw\n", "size \"-2\" is not a positive integer");
  expect("type: uchar\ndimension: 1\nsizes: 8\nencoding: raw\n", "a 1-D image");
  expect("type: uchar\n" + three + "space: moon\nencoding: raw\n", "its space, \"moon\"");
  expect("type: uchar\n" + three + "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\n", "requires a space");
  expect("type: uchar\n" + three + "line skip: -1\nencoding: raw\n", "line skip is negative");
  expect("type: uchar\n" + three + "encoding: rot13\n", "its encoding \"rot13\"");
}

TEST(MetaImage, DataMayBeSplit)
{
  const std::string folder = TestFolder();
  shapeton::WriteText(folder + "/a0.raw", voxels.substr(0, 4));
  shapeton::WriteText(folder + "/a1.raw", voxels.substr(4));
  const auto read = [&](const std::string & files) {
    const std::string path = folder + "/volume.mhd";
    shapeton::WriteText(path,
                        "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\n"
                        "ElementType = MET_UCHAR\nElementDataFile = " +
                          files + '\n');
    return ReadVolume(path).image->GetPixel({ { 1, 0, 1 } });
  };
  EXPECT_EQ(read("LIST\na0.raw\na1.raw"), 5.0F);
  EXPECT_EQ(read("LIST\na1.raw\na0.raw"), 1.0F);
  EXPECT_EQ(read("a%d.raw 0 1 1"), 5.0F);
  EXPECT_NE(InputErrorOf([&] { read("LIST\na0.raw"); }).find("truncated"), std::string::npos);
  // MetaIO divides by the step.
  EXPECT_NE(InputErrorOf([&] { read("a%d.raw 0 1"); }).find("and step"), std::string::npos);
}

TEST(Nrrd, AListOfOneValueIsAVolume)
{
  const std::string path = TestFolder() + "/volume.nrrd";
  const auto        write = [&](const std::string & size, const std::string & data) {
    shapeton::WriteText(path,
                        "NRRD0004\ntype: uchar\ndimension: 4\nsizes: " + size +
                          " 2 2 2\nkinds: list domain domain domain\nspacings: nan 1 1 1\nencoding: text\n\n" + data);
  };
  write("1", "0 1 2 3 4 5 6 7\n");
  EXPECT_EQ(ReadVolume(path).image->GetPixel({ { 1, 0, 1 } }), 5.0F);
  write("2", "0 1 2 3 4 5 6 7 0 1 2 3 4 5 6 7\n");
  EXPECT_NE(InputErrorOf([&] { ReadVolume(path); }).find("2 components"), std::string::npos);
}
