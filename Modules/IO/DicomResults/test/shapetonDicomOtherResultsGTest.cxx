// Results from other programs: label maps, tilted and single slices, encodings, values.
#include "shapetonDicomReport.h"
#include "shapetonDicomReportReader.h"
#include "shapetonDicomResultsTesting.h"
#include "shapetonDicomSegmentationReader.h"
#include "shapetonFileBytes.h"
#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <random>

namespace
{
using namespace shapeton;

/** A series of slices with this many rows, 7 x 9 by default. */
DicomFixture
FixtureOf(unsigned int columns, unsigned int rows)
{
  DicomFixture fixture = ObliqueFixture();
  fixture.columns = columns;
  fixture.rows = rows;
  return fixture;
}

/** A label map on slices 0, 3 and 5 of a fixture, with labels that are random in each run of pixels. */
struct LabelMap
{
  LabelMap(const std::vector<Uint16> & values,
           unsigned int                bits,
           const std::vector<Uint16> & segments,
           DicomFixture                series = FixtureOf(7, 9),
           std::size_t                 run = 1)
    : fixture(std::move(series))
    , folder(TestFolder())
    , source(SourceOf(fixture, folder))
    , path(folder + "/map.dcm")
    , expected(std::size_t{ fixture.columns } * fixture.rows * 6, 0)
  {
    const std::size_t                    pixelsOfSlice = std::size_t{ fixture.columns } * fixture.rows;
    std::mt19937                         random(7);
    std::vector<Uint16>                  labels;
    std::vector<DicomFixture::PointType> frames;
    for (const std::size_t slice : { 0, 3, 5 })
    {
      frames.push_back(fixture.SlicePosition(static_cast<double>(slice) * fixture.sliceSpacing));
      for (std::size_t i = 0; i < pixelsOfSlice; ++i)
      {
        labels.push_back(i % run == 0 ? values[random() % values.size()] : labels.back());
        const bool isSegment = std::count(segments.begin(), segments.end(), labels.back()) > 0;
        expected[slice * pixelsOfSlice + i] = isSegment ? labels.back() : Uint16(0);
      }
    }
    file = fixture.MakeLabelMap(frames, labels, bits, segments);
  }

  DcmDataset &
  Dataset()
  {
    return *file->getDataset();
  }

  DicomSegmentationFile
  Read(E_TransferSyntax syntax = EXS_LittleEndianExplicit)
  {
    SaveDicom(*file, path, syntax);
    return ReadDicomSegmentation(path);
  }

  void
  Expect(const DicomSegmentationFile & read, const std::vector<int> & numbers, const std::string & what)
  {
    const auto                  labels = ReadDicomSegments(read, numbers, source).labels;
    std::vector<unsigned short> values(labels->GetBufferPointer(), labels->GetBufferPointer() + expected.size());
    EXPECT_EQ(values, expected) << what;
  }

  DicomFixture                fixture;
  std::string                 folder;
  DicomSource                 source;
  std::string                 path;
  std::vector<unsigned short> expected;
  DicomFixture::File          file;
};

std::vector<int>
NumbersIn(const DicomSegmentationFile & file)
{
  std::vector<int> numbers;
  for (const DicomSegmentInFile & segment : file.segments)
  {
    numbers.push_back(segment.number);
  }
  return numbers;
}

std::string
OddData(const std::string & name)
{
  const char * const data = std::getenv("SHAPETON_TEST_DATA_DIR");
  const std::string  path = data ? std::string(data) + "/odd/seg/" + name : std::string();
  return std::filesystem::exists(path) ? path : std::string();
}

std::size_t
VoxelsOf(const std::string & path, const DicomSource & source)
{
  return ReadDicomSegments(ReadDicomSegmentation(path), { 1 }, source).voxels.at(0);
}
} // namespace

TEST(DicomResultsOfOtherPrograms, ALabelMapIsReadInEachEncoding)
{
  for (const auto syntax :
       { EXS_LittleEndianExplicit, EXS_LittleEndianImplicit, EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit })
  {
    const std::string what = DcmXfer(syntax).getXferName();
    LabelMap          bytes({ 0, 2, 7 }, 8, { 2, 7 });
    bytes.Expect(bytes.Read(syntax), { 2, 7 }, what);
    LabelMap words({ 0, 2, 300, 65535 }, 16, { 2, 300, 65535 });
    words.Expect(words.Read(syntax), { 65535, 300, 2 }, what);
  }
}

TEST(DicomResultsOfOtherPrograms, ALabelMapHasABackgroundOrNone)
{
  LabelMap none({ 2, 7 }, 8, { 2, 7 }); // each pixel belongs to a segment
  none.Expect(none.Read(), { 2, 7 }, "none");

  LabelMap padded({ 2, 7, 9 }, 8, { 2, 7 });
  padded.Dataset().putAndInsertUint16(DCM_PixelPaddingValue, 9);
  padded.Expect(padded.Read(), { 2, 7 }, "padding");

  for (const Uint16 number : { 0, 4 }) // declared by its type
  {
    LabelMap  declared({ number, 2, 7 }, 8, { 2, number, 7 });
    DcmItem * segment = nullptr;
    DcmItem * type = nullptr;
    ASSERT_TRUE(declared.Dataset().findAndGetSequenceItem(DCM_SegmentSequence, segment, 1).good());
    ASSERT_TRUE(segment->findAndGetSequenceItem(DCM_SegmentedPropertyTypeCodeSequence, type).good());
    type->putAndInsertString(DCM_CodeValue, "125040");
    type->putAndInsertString(DCM_CodingSchemeDesignator, "DCM");
    std::replace(declared.expected.begin(), declared.expected.end(), static_cast<unsigned short>(number), Uint16(0));
    const auto file = declared.Read();
    EXPECT_EQ(NumbersIn(file), (std::vector<int>{ 2, 7 }));
    declared.Expect(file, { 2, 7 }, "declared");
  }
}

TEST(DicomResultsOfOtherPrograms, ALabelMapMayBeInColor)
{
  LabelMap map({ 0, 2, 7 }, 8, { 2, 7 });
  map.Dataset().putAndInsertString(DCM_PhotometricInterpretation, "PALETTE COLOR");
  map.Expect(map.Read(), { 2, 7 }, "palette");
}

TEST(DicomResultsOfOtherPrograms, LabelsThatAreNotDeclaredAreRefused)
{
  LabelMap   map({ 0, 2, 8 }, 8, { 2, 7 });
  const auto file = map.Read();
  EXPECT_TRUE(
    Refuses([&] { ReadDicomSegments(file, { 2 }, map.source); }, "has pixels of segment 8, which it does not declare"));
  LabelMap zero({ 0, 2 }, 8, { 0, 2 }); // a separate structure; 0 means none in derived data
  EXPECT_THROW(ReadDicomSegments(zero.Read(), { 0, 2 }, zero.source), ParameterError);
  EXPECT_NO_THROW(ReadDicomSegments(zero.Read(), { 2 }, zero.source));
  LabelMap wide({ 0, 2 }, 8, { 2 });
  wide.Dataset().putAndInsertUint16(DCM_BitsAllocated, 32);
  EXPECT_TRUE(Refuses([&] { wide.Read(); }, "LABELMAP with 32 bits"));
}

TEST(DicomResultsOfOtherPrograms, AttributesWithUnknownRepresentationAreDecoded)
{
  for (const auto syntax : { EXS_LittleEndianExplicit, EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit })
  {
    LabelMap map({ 0, 2, 7 }, 16, { 2, 7 });
    StoreAllAsUnknown(map.Dataset());
    map.Expect(map.Read(syntax), { 2, 7 }, DcmXfer(syntax).getXferName());
  }
}

TEST(DicomResultsOfOtherPrograms, FaultsAreNamed)
{
  LabelMap  comma({ 0, 2 }, 8, { 2 });
  DcmItem * shared = nullptr;
  DcmItem * measures = nullptr;
  ASSERT_TRUE(comma.Dataset().findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared).good());
  ASSERT_TRUE(shared->findAndGetSequenceItem(DCM_PixelMeasuresSequence, measures).good());
  measures->putAndInsertString(DCM_PixelSpacing, "1,25\\0,75");
  const std::string message = InputErrorOf([&] { comma.Read(); });
  EXPECT_TRUE(
    Contains(message, "map.dcm\" cannot be read: its PixelSpacing (0028,0030) is \"1,25\\0,75\", with a comma"));

  for (const auto syntax : { EXS_LittleEndianExplicit, EXS_RLELossless }) // native, and in fragments
  {
    LabelMap encoded({ 0, 2 }, 8, { 2 });
    SaveDicom(*encoded.file, encoded.path, syntax);
    StateTransferSyntax(encoded.path, "1.2.840.10008.1.2.4.110");
    EXPECT_TRUE(Refuses([&] { ReadDicomSegmentation(encoded.path); },
                        "is encoded as JPEG XL Lossless (1.2.840.10008.1.2.4.110), which is not supported"));
  }
  LabelMap native({ 0, 2 }, 8, { 2 });
  SaveDicom(*native.file, native.path);
  StateTransferSyntax(native.path, "1.2.840.10008.1.2.8.1"); // a false statement
  EXPECT_NE(InputErrorOf([&] { ReadDicomSegments(ReadDicomSegmentation(native.path), { 2 }, native.source); }), "");
  LabelMap damaged({ 0, 2 }, 8, { 2 });
  SaveDicom(*damaged.file, damaged.path);
  DeflateDicomFrames(damaged.path);
  std::string bytes = ReadFileBytes(damaged.path);
  bytes[bytes.size() - 40] = static_cast<char>(~bytes[bytes.size() - 40]); // in the last frame
  WriteText(damaged.path, bytes);
  EXPECT_NE(InputErrorOf([&] { ReadDicomSegments(ReadDicomSegmentation(damaged.path), { 2 }, damaged.source); }), "");
}

TEST(DicomResultsOfOtherPrograms, CompressedFramesAreRead)
{
  const auto compressions = std::map<std::string, std::function<void(const std::string &)>>{
    { "RLE", [](const std::string & path) { CompressSegmentation(path, "1.2.840.10008.1.2.5"); } },
    { "JPEG-LS", [](const std::string & path) { CompressSegmentation(path, "1.2.840.10008.1.2.4.80"); } },
    { "deflated frames", DeflateDicomFrames }
  };
  for (const auto & [name, compress] : compressions)
  {
    for (const unsigned int bits : { 8u, 16u })
    {
      const Uint16 large = bits == 8 ? 200 : 40000;
      LabelMap     map({ 0, 2, large }, bits, { 2, large });
      map.Read();
      compress(map.path);
      map.Expect(ReadDicomSegmentation(map.path), { 2, large }, name + ", bits " + std::to_string(bits));
    }
  }
  // The JPEG 2000 encoder of GDCM writes past its buffer if the frame does not become smaller.
  LabelMap map({ 0, 2, 7 }, 8, { 2, 7 }, FixtureOf(64, 48), 64);
  map.Read();
  CompressSegmentation(map.path, "1.2.840.10008.1.2.4.90");
  map.Expect(ReadDicomSegmentation(map.path), { 2, 7 }, "JPEG 2000");
}

std::string
FromHexadecimal(const std::string & digits)
{
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
  {
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

/** Segments 1 to `count` of a label image on the slices of a series, in single bits: 7 x 9 bits are not a multiple of a
 * byte. */
class Bits
{
public:
  Bits()
    : m_Folder(TestFolder())
    , m_Source(SourceOf(ObliqueFixture(), m_Folder))
    , m_Labels(NewImageOn<DicomLabelImage>(m_Source.grid, true))
    , m_Path(m_Folder + "/seg.dcm")
  {}

  /** Labels each voxel; voxels are numbered from the first one of the first slice. */
  void
  Write(const std::function<unsigned short(std::size_t)> & labelOf, unsigned short count)
  {
    for (std::size_t i = 0; i < this->Voxels(); ++i)
    {
      m_Labels->GetBufferPointer()[i] = labelOf(i);
    }
    std::vector<DicomSegment> segments(count);
    for (unsigned short i = 0; i < count; ++i)
    {
      segments[i].name = segments[i].trackingID = "segment";
      segments[i].category = segments[i].type = { "71854001", "SCT", "Colon" };
      segments[i].trackingUID = "2.25.1";
      segments[i].labels = m_Labels;
      segments[i].label = static_cast<unsigned short>(i + 1);
      m_Numbers.push_back(i + 1);
    }
    WriteDicomSegmentation(m_Source, segments, HeaderOfTest(), m_Path);
  }

  const std::string &
  Path() const
  {
    return m_Path;
  }

  bool
  AreReadBack() const
  {
    const auto         back = ReadDicomSegments(ReadDicomSegmentation(m_Path), m_Numbers, m_Source).labels;
    const auto * const labels = m_Labels->GetBufferPointer();
    return std::equal(labels, labels + this->Voxels(), back->GetBufferPointer());
  }

private:
  std::size_t
  Voxels() const
  {
    return m_Labels->GetLargestPossibleRegion().GetNumberOfPixels();
  }

  std::string              m_Folder;
  DicomSource              m_Source;
  DicomLabelImage::Pointer m_Labels;
  std::string              m_Path;
  std::vector<int>         m_Numbers;
};

/** Frames are padded when compressed, but not otherwise. */
TEST(DicomResultsOfOtherPrograms, DeflatedFramesOfBitsAreRead)
{
  Bits         bits;
  std::mt19937 random(5);
  bits.Write([&](std::size_t) { return static_cast<unsigned short>(random() % 3); }, 2);
  DeflateDicomFrames(bits.Path());
  EXPECT_TRUE(bits.AreReadBack());
}

/** The frames are streams written by opj_compress of OpenJPEG 2.5.0. */
TEST(DicomResultsOfOtherPrograms, FramesOfBitsInJpeg2000AreRead)
{
  const std::string patterns[2] = { "110100001101000011010001000000001100001101100101101011111011001",
                                    "011011101000001111101101001101101110001100010011110001100010011" };
  const std::string header = "ff4fff51002900000000000700000009000000000000000000000007000000090000000000000000000100"
                             "0101ff52000c00000001000004040001ff5c00044008";
  const std::string streams[2] = {
    FromHexadecimal(header + "ff90000a00000000001d0001ff93d5a00bfe022acfc812d5d18238fb2fffd9"),
    FromHexadecimal(header + "ff90000a00000000001c0001ff93d58010f45a7fe1bc0a4809934537ffd9")
  };
  const std::string     lossless = "1.2.840.10008.1.2.4.90";
  constexpr std::size_t pixels = 63;
  Bits                  bits;
  bits.Write([&](std::size_t i) { return static_cast<unsigned short>(patterns[i / pixels % 2][i % pixels] - '0'); }, 1);
  std::vector<std::string> frames;
  for (std::size_t slice = 0; slice < 6; ++slice)
  {
    frames.push_back(streams[slice % 2]);
  }
  ReplaceFrames(bits.Path(), frames, lossless);
  EXPECT_TRUE(bits.AreReadBack());

  const auto [columns, components, precision] = std::array<std::size_t, 3>{ 11, 41, 42 }; // bytes of the stream
  for (const auto & [place, value] : std::map<std::size_t, char>{ { columns, 6 }, { components, 3 }, { precision, 7 } })
  {
    std::vector<std::string> others = frames;
    others[3][place] = value;
    ReplaceFrames(bits.Path(), others, lossless);
    EXPECT_TRUE(Refuses([&] { bits.AreReadBack(); }, "not the single bits of its header")) << place;
  }
  std::vector<std::string> truncated = frames;
  truncated[5].resize(50);
  ReplaceFrames(bits.Path(), truncated, lossless);
  EXPECT_NE(InputErrorOf([&] { bits.AreReadBack(); }), "");
  ReplaceFrames(bits.Path(), frames, "1.2.840.10008.1.2.4.80");
  EXPECT_TRUE(Refuses([&] { bits.AreReadBack(); }, "which is not supported; decompress it"));
}

TEST(DicomResultsOfOtherPrograms, NamesOfSegmentsAreDecoded)
{
  const auto labelOf = [](const std::string & set, const std::string & label) {
    LabelMap  map({ 0, 2 }, 8, { 2 });
    DcmItem * segment = nullptr;
    EXPECT_TRUE(map.Dataset().findAndGetSequenceItem(DCM_SegmentSequence, segment).good());
    map.Dataset().putAndInsertString(DCM_SpecificCharacterSet, set.c_str());
    segment->putAndInsertString(DCM_SegmentLabel, label.c_str());
    return map.Read();
  };
  auto file = labelOf("\\ISO 2022 IR 87", "\x1b$B;3ED\x1b(B");
  EXPECT_EQ(file.segments.at(0).name, "\u5c71\u7530");
  EXPECT_TRUE(file.notes.empty());
  file = labelOf("ISO_IR 6", "K\xf6rper");
  EXPECT_EQ(file.segments.at(0).name, "K?rper");
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_TRUE(Contains(file.notes[0], "segment 2"));
}

// ---- tilted series ----

TEST(DicomResultsOfOtherPrograms, ASegmentationIsDeshearedWithItsSeries)
{
  const DicomFixture                   fixture = ObliqueFixture();
  const std::string                    folder = TestFolder();
  std::vector<DicomFixture::PointType> places;
  DicomFixture::Files                  files;
  for (int i = 0; i < 6; ++i)
  {
    places.push_back(fixture.SlicePosition(2.0 * i, -0.4 * i, 0.9 * i));
    files.push_back(fixture.MakeSlice(places.back(), i + 1));
  }
  SaveDicom(files, folder);
  const std::vector<Uint16> labels(std::size_t{ 6 } * fixture.columns * fixture.rows, 3); // all pixels
  SaveDicom(*fixture.MakeLabelMap(places, labels, 8, { 3 }), MakeFolder(folder + "/map") + "/map.dcm");

  EXPECT_TRUE(Refuses([&] { ReadDicomSource(folder + "/im0001.dcm"); }, "single slice"));
  std::filesystem::rename(folder + "/map", folder + ".map");
  DicomSourceOptions options;
  EXPECT_FALSE(Contains(InputErrorOf([&] { ReadDicomSource(folder, options); }), "deshear"));
  options.offersDeshear = true;
  EXPECT_TRUE(Refuses([&] { ReadDicomSource(folder, options); }, "the parameter \"deshear\""));
  options.deshear = true;
  const DicomSource source = ReadDicomSource(folder, options);
  VolumeReadOptions volume;
  volume.deshear = true;
  EXPECT_TRUE(HaveSameGrid(ReadVolume(folder, volume).image.GetPointer(), source.grid));

  const auto read = ReadDicomSegments(ReadDicomSegmentation(folder + ".map/map.dcm"), { 3 }, source);
  EXPECT_EQ(read.voxels[0], labels.size());
  std::size_t painted = 0;
  basetest::ForVoxels(read.labels, [&](const auto & index, const auto & point) {
    if (read.labels->GetPixel(index) != 3)
    {
      return;
    }
    ++painted; // each within half a pixel of a pixel in its slice
    const auto step = point - places[static_cast<std::size_t>(index[2])];
    const auto along = [&](unsigned int axis, double spacing) {
      double sum = 0;
      for (unsigned int k = 0; k < 3; ++k)
      {
        sum += step[k] * fixture.direction(k, axis);
      }
      return sum / spacing;
    };
    EXPECT_TRUE(along(0, fixture.columnSpacing) >= -0.501 && along(0, fixture.columnSpacing) <= 6.501);
    EXPECT_TRUE(along(1, fixture.rowSpacing) >= -0.501 && along(1, fixture.rowSpacing) <= 8.501);
    EXPECT_NEAR(along(2, 1.0), 0.0, 1e-6);
  });
  EXPECT_EQ(painted, labels.size());
  std::filesystem::remove_all(folder + ".map");
}

// ---- reports ----

TEST(DicomResultsOfOtherPrograms, PointsInPixelsNeedNeitherAVolumeNorAFrameOfReference)
{
  const DicomFixture fixture = ObliqueFixture();
  const std::string  folder = TestFolder();
  const DicomSource  whole = SourceOf(fixture, folder);
  const DicomCode    center{ "111010", "DCM", "Center" };
  const auto         place = fixture.SlicePosition(4.0, 1.5, 2.5);
  const auto         write = [&](const DicomContent & point, const std::string & name) {
    const DicomContent root =
      ContainerContent({}, { "126000", "DCM", "Imaging Measurement Report" }, { point }, "1500");
    WriteDicomReport(whole, DicomReportKind::Comprehensive3D, root, {}, HeaderOfTest(), folder + name);
    return folder + name;
  };
  const std::array<double, 3> point{ place[0], place[1], place[2] };
  const std::string           inPixels = write(PixelPointContent("CONTAINS", center, point, whole), "/pixels.sr");
  const std::string           inSpace = write(SpacePointContent("CONTAINS", center, point), "/space.sr");

  DcmFileFormat slice = Loaded(folder + "/im0003.dcm");
  slice.getDataset()->findAndDeleteElement(DCM_FrameOfReferenceUID);
  SaveDicom(slice, MakeFolder(folder + ".one") + "/slice.dcm");
  EXPECT_TRUE(Refuses([&] { ReadDicomSource(folder + ".one"); }, "a single slice"));
  DicomSourceOptions options;
  options.forPoints = true;
  const DicomSource one = ReadDicomSource(folder + ".one", options);
  const auto        points = ReadDicomReportPoints(inPixels, one);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_LT(points[0].places.at(0).EuclideanDistanceTo(place), 1e-4); // the report stores floats
  EXPECT_TRUE(Refuses([&] { ReadDicomReportPoints(inSpace, one); }, "has no frame of reference"));
  std::filesystem::remove(folder + "/im0002.dcm"); // a gap
  EXPECT_TRUE(Refuses([&] { ReadDicomSource(folder); }, "1 slice is missing"));
  EXPECT_LT(
    ReadDicomReportPoints(inPixels, ReadDicomSource(folder, options)).at(0).places.at(0).EuclideanDistanceTo(place),
    1e-4);
  std::filesystem::remove_all(folder + ".one");
}

// ---- real files ----

TEST(DicomResultsOfOtherPrograms, RealFilesOfOtherPrograms)
{
  if (OddData("ct-tilted").empty() || OddData("sparse-labelmap-noppv.dcm").empty())
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set, or lacks odd/seg";
  }
  DicomSourceOptions options;
  options.deshear = true;
  EXPECT_EQ(VoxelsOf(OddData("08-on-tilted-series.dcm"), ReadDicomSource(OddData("ct-tilted"), options)), 1600U);

  DicomFixture liver; // a series with the grid of the label maps, which contain every second slice
  liver.columns = 24;
  liver.rows = 38;
  liver.slices = 3;
  liver.columnSpacing = liver.rowSpacing = 0.7;
  liver.sliceSpacing = 2.5;
  const double origin[3] = { 46.464901, 5.0188098, -177.75 };
  liver.origin = DicomFixture::PointType(origin);
  const DicomSource source = SourceOf(liver, TestFolder());
  for (const char * name : { "sparse-labelmap-noppv.dcm", "sparse-labelmap-ppv5.dcm" })
  {
    EXPECT_EQ(NumbersIn(ReadDicomSegmentation(OddData(name))), std::vector<int>{ 1 });
    EXPECT_EQ(VoxelsOf(OddData(name), source), 630U) << name;
  }
}
