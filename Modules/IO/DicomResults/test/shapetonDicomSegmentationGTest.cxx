#include "shapetonDicomResultsTesting.h"
#include "shapetonDicomSegmentationReader.h"
#include "shapetonFileBytes.h"
#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"
#include "shapetonPi.h"
#include "shapetonTestImages.h"

#include <filesystem>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

namespace
{
using namespace shapeton;

/** 0 to 2 at random, slice 2 empty; 3 does not occur. */
DicomLabelImage::Pointer
RandomLabels(const DicomSource & source, unsigned int seed)
{
  const auto        labels = NewImageOn<DicomLabelImage>(source.grid, true);
  std::mt19937      random(seed);
  const std::size_t pixels = source.series.size[0] * source.series.size[1];
  for (std::size_t i = 0; i < pixels * source.series.size[2]; ++i)
  {
    labels->GetBufferPointer()[i] = i / pixels == 2 ? 0 : static_cast<unsigned short>(random() % 3);
  }
  return labels;
}

DicomSegment
Segment(const std::string & name, const DicomLabelImage * labels, unsigned short label)
{
  DicomSegment segment;
  segment.name = name;
  segment.category = { "123037004", "SCT", "Anatomical Structure" };
  segment.type = { "71854001", "SCT", "Colon" };
  segment.trackingID = name;
  segment.trackingUID = "2.25.1";
  segment.labels = labels;
  segment.label = label;
  return segment;
}

std::vector<unsigned short>
ValuesOf(const DicomLabelImage * image)
{
  return { image->GetBufferPointer(),
           image->GetBufferPointer() + image->GetLargestPossibleRegion().GetNumberOfPixels() };
}

/** A file with two segments, and one that overlaps them: source, labels and path. */
struct Written
{
  explicit Written(const DicomFixture & fixture, DicomSegmentationFormat format = DicomSegmentationFormat::Binary)
    : folder(TestFolder())
    , source(SourceOf(fixture, folder))
    , labels(RandomLabels(source, 1))
    , others(RandomLabels(source, 2))
    , path(folder + "/seg.dcm")
  {
    segmentation = WriteDicomSegmentation(source, this->Segments(), HeaderOfTest(), path, format);
  }

  std::vector<DicomSegment>
  Segments() const
  {
    return {
      Segment("one", labels, 1), Segment("none", labels, 3), Segment("two", labels, 2), Segment("other", others, 2)
    };
  }

  std::string              folder;
  DicomSource              source;
  DicomLabelImage::Pointer labels;
  DicomLabelImage::Pointer others;
  std::string              path;
  DicomSegmentation        segmentation;
};

/** Labels 1 and 2 are read back; 7 x 9 bits are not a multiple of a byte. */
void
ExpectRoundTrip(const Written & written)
{
  EXPECT_EQ(written.segmentation.numbers, (std::vector<int>{ 1, 0, 2, 3 }));
  const DicomSegmentationFile file = ReadDicomSegmentation(written.path);
  EXPECT_EQ(file.frameOfReferenceUID, "1.2.4");
  EXPECT_EQ(file.seriesUID, written.source.series.uid);
  ASSERT_EQ(file.segments.size(), 3u);
  EXPECT_EQ(file.segments[1].name, "two");
  EXPECT_EQ(file.segments[1].type.value, "71854001");
  const auto back = ReadDicomSegments(file, { 1, 2 }, written.source).labels;
  EXPECT_EQ(ValuesOf(back), ValuesOf(written.labels));
  EXPECT_TRUE(HaveSameGrid(back, written.source.grid));
  const auto covered = ReadDicomSegments(file, { 1, 2, 3 }, written.source); // 3 overlaps the others
  EXPECT_EQ(covered.voxels[0], written.segmentation.voxels[0]);
  EXPECT_EQ(covered.voxels[2], written.segmentation.voxels[3]);
  std::vector<unsigned short> third = ValuesOf(written.others);
  std::transform(third.begin(), third.end(), third.begin(), [](unsigned short value) { return value == 2 ? 3 : 0; });
  EXPECT_EQ(ValuesOf(ReadDicomSegments(file, { 3 }, written.source).labels), third);
}
} // namespace

TEST(DicomSegmentation, ComesBackFromAnObliqueSeries) { ExpectRoundTrip(Written(ObliqueFixture())); }

TEST(DicomSegmentation, ComesBackDeflated)
{
  const Written written(ObliqueFixture(), DicomSegmentationFormat::DeflatedBinary);
  EXPECT_EQ(DcmXfer(Loaded(written.path).getDataset()->getOriginalXfer()).getXfer(), EXS_DeflatedLittleEndianExplicit);
  ExpectRoundTrip(written);
}

TEST(DicomSegmentation, LabelMapsComeBack)
{
  const std::string folder = TestFolder();
  const DicomSource source = SourceOf(ObliqueFixture(), folder);
  for (const unsigned short count : { 2, 300 }) // 8 and 16 bits
  {
    const auto        labels = NewImageOn<DicomLabelImage>(source.grid, true);
    const std::size_t voxels = labels->GetLargestPossibleRegion().GetNumberOfPixels();
    for (std::size_t i = 0; i < voxels; ++i)
    {
      labels->GetBufferPointer()[i] = static_cast<unsigned short>(i * 11 % (count + 1u));
    }
    std::vector<DicomSegment> segments;
    std::vector<int>          numbers;
    for (unsigned short k = 1; k <= count; ++k)
    {
      segments.push_back(Segment("segment " + std::to_string(k), labels, k));
      numbers.push_back(k);
    }
    for (const auto format : { DicomSegmentationFormat::LabelMap, DicomSegmentationFormat::DeflatedLabelMap })
    {
      const std::string path = folder + "/map.seg";
      WriteDicomSegmentation(source, segments, HeaderOfTest(), path, format);
      DcmFileFormat file = Loaded(path);
      EXPECT_EQ(ValueOf(file, DCM_SegmentationType), "LABELMAP");
      EXPECT_EQ(ValueOf(file, DCM_BitsAllocated), count > 255 ? "16" : "8");
      EXPECT_EQ(ValueOf(file, DCM_PixelPaddingValue), "0");
      EXPECT_EQ(ValueOf(file, DCM_NumberOfFrames), "6");
      EXPECT_EQ(file.getDataset()->getOriginalXfer(),
                format == DicomSegmentationFormat::LabelMap ? EXS_RLELossless : EXS_DeflatedLittleEndianExplicit);
      const DicomSegmentationFile header = ReadDicomSegmentation(path);
      ASSERT_EQ(header.segments.size(), count); // no segment of the background
      EXPECT_EQ(ValuesOf(ReadDicomSegments(header, numbers, source).labels), ValuesOf(labels));
    }
  }
}

TEST(DicomSegmentation, HasOtherUIDsInEachFormat)
{
  const std::string     folder = TestFolder();
  const DicomSource     source = SourceOf(ObliqueFixture(), folder);
  const auto            labels = RandomLabels(source, 1);
  std::set<std::string> instances, series;
  for (const auto format : { DicomSegmentationFormat::Binary,
                             DicomSegmentationFormat::DeflatedBinary,
                             DicomSegmentationFormat::LabelMap,
                             DicomSegmentationFormat::DeflatedLabelMap })
  {
    const auto written =
      WriteDicomSegmentation(source, { Segment("one", labels, 1) }, HeaderOfTest(), folder + "/x.seg", format);
    instances.insert(written.instance.sopInstanceUID);
    series.insert(written.instance.seriesUID);
  }
  EXPECT_EQ(instances.size(), 4u);
  EXPECT_EQ(series.size(), 4u);
}

TEST(DicomSegmentation, ALabelMapCannotOverlap)
{
  const Written written(ObliqueFixture());
  EXPECT_THROW(WriteDicomSegmentation(
                 written.source, written.Segments(), HeaderOfTest(), written.path, DicomSegmentationFormat::LabelMap),
               std::invalid_argument);
}

/** By brute force: of all voxels of a label, the center is the one nearest to their mean. */
TEST(DicomSegmentation, CentersAreTheVoxelsNearestToTheCentroid)
{
  const Written written(ObliqueFixture());
  const auto &  labels = written.labels;
  for (const std::size_t k : { 0, 2 }) // segments "one" and "two"
  {
    const auto                         label = static_cast<unsigned short>(k == 0 ? 1 : 2);
    std::vector<itk::Point<double, 3>> places;
    itk::Vector<double, 3>             sum(0.0);
    basetest::ForVoxels(labels, [&](const auto & index, const auto & point) {
      if (labels->GetPixel(index) == label)
      {
        places.push_back(point);
        sum += point.GetVectorFromOrigin();
      }
    });
    const itk::Point<double, 3> centroid(sum / static_cast<double>(places.size()));
    double                      least = std::numeric_limits<double>::infinity();
    for (const auto & place : places)
    {
      least = std::min(least, place.EuclideanDistanceTo(centroid));
    }
    const itk::Point<double, 3> center(written.segmentation.centers[k].data());
    EXPECT_NEAR(center.EuclideanDistanceTo(centroid), least, 1e-9);
    EXPECT_EQ(labels->GetPixel(labels->TransformPhysicalPointToIndex(center)), label);
  }
}

TEST(DicomSegmentation, HasTheBodyPartOfItsHeader)
{
  const Written     written(ObliqueFixture());
  DicomResultHeader header = HeaderOfTest();
  header.bodyPart = "COLON";
  WriteDicomSegmentation(written.source, written.Segments(), header, written.path);
  DcmFileFormat file = Loaded(written.path);
  EXPECT_EQ(ValueOf(file, DCM_BodyPartExamined), "COLON");
  EXPECT_EQ(ValueOf(file, DCM_TimezoneOffsetFromUTC), "+0100");
}

TEST(DicomSegmentation, ComesBackFromFramesOfOneFile)
{
  const std::string  folder = TestFolder();
  const DicomFixture fixture = ObliqueFixture();
  const auto         enhanced = fixture.MakeEnhanced({ 6, 0, 4, 2 });
  SetText(*enhanced, DCM_StudyInstanceUID, "1.2.3");
  SetText(*enhanced, DCM_FrameOfReferenceUID, "1.2.4");
  SaveDicom(*enhanced, folder + "/enhanced.dcm");
  const DicomSource source = ReadDicomSource(folder);
  const auto        labels = RandomLabels(source, 3);
  WriteDicomSegmentation(source, { Segment("one", labels, 1) }, HeaderOfTest(), folder + "/seg.dcm");
  std::vector<unsigned short> expected = ValuesOf(labels);
  std::transform(expected.begin(), expected.end(), expected.begin(), [](unsigned short v) { return v == 1 ? 1 : 0; });
  const auto back = ReadDicomSegments(ReadDicomSegmentation(folder + "/seg.dcm"), { 1 }, source).labels;
  EXPECT_EQ(ValuesOf(back), expected);
  DcmFileFormat file = Loaded(folder + "/seg.dcm");
  EXPECT_EQ(ValueOf(file, DCM_ReferencedFrameNumber), "2"); // the first slice along the normal
}

TEST(DicomSegmentation, BelongsToItsSource)
{
  const Written written(ObliqueFixture());
  DcmFileFormat file = Loaded(written.path);
  EXPECT_EQ(ValueOf(file, DCM_PatientName), "Doe^Jane");
  EXPECT_EQ(ValueOf(file, DCM_PatientID), "P1");
  EXPECT_EQ(ValueOf(file, DCM_PatientAge), "064Y");
  EXPECT_EQ(ValueOf(file, DCM_StudyInstanceUID), "1.2.3");
  EXPECT_EQ(ValueOf(file, DCM_StudyDate), "20010203");
  EXPECT_EQ(ValueOf(file, DCM_ContentDate), "20010204");
  EXPECT_EQ(ValueOf(file, DCM_ContentTime), "101112");
  EXPECT_EQ(ValueOf(file, DCM_FrameOfReferenceUID), "1.2.4");
  EXPECT_EQ(ValueOf(file, DCM_ContentQualification), "RESEARCH");
  EXPECT_EQ(ValueOf(file, DCM_SegmentsOverlap), "YES");
  EXPECT_EQ(ValueOf(file, DCM_InstitutionName), "");
  EXPECT_EQ(ValueOf(file, DCM_NumberOfFrames), "15"); // of 18 because slice 2 is empty
  EXPECT_EQ(ValueOf(file, DCM_SOPInstanceUID), written.segmentation.instance.sopInstanceUID);
  DcmItem * reference = nullptr;
  DcmItem * series = nullptr;
  ASSERT_TRUE(file.getDataset()->findAndGetSequenceItem(DCM_ReferencedSeriesSequence, series).good());
  for (unsigned int i = 0; i < 6; ++i)
  {
    ASSERT_TRUE(series->findAndGetSequenceItem(DCM_ReferencedInstanceSequence, reference, i).good());
    OFString uid;
    reference->findAndGetOFString(DCM_ReferencedSOPInstanceUID, uid);
    EXPECT_EQ(std::string(uid.c_str()), written.source.series.slices[i].sopInstanceUID);
  }
}

TEST(DicomSegmentation, HasEqualBytesOnRepeatAndOtherUIDsOtherwise)
{
  const Written     written(ObliqueFixture());
  const std::string again = written.folder + "/again.dcm";
  WriteDicomSegmentation(written.source, written.Segments(), HeaderOfTest(), again);
  EXPECT_EQ(ReadFileBytes(written.path), ReadFileBytes(again));
  written.labels->GetBufferPointer()[0] = 3 - written.labels->GetBufferPointer()[0];
  const auto other = WriteDicomSegmentation(written.source, written.Segments(), HeaderOfTest(), again);
  EXPECT_NE(other.instance.sopInstanceUID, written.segmentation.instance.sopInstanceUID);
  EXPECT_NE(other.instance.seriesUID, written.segmentation.instance.seriesUID);
}

TEST(DicomSegmentation, RefusesAnotherGrid)
{
  const Written written(ObliqueFixture());
  DicomFixture  moved = ObliqueFixture();
  moved.origin[0] += 0.4;
  const DicomSource other = SourceOf(moved, MakeFolder(written.folder + "/moved"));
  EXPECT_TRUE(Refuses([&] { WriteDicomSegmentation(other, written.Segments(), HeaderOfTest(), written.path); },
                      "is not on the grid of the series"));
  EXPECT_TRUE(Refuses([&] { ReadDicomSegments(ReadDicomSegmentation(written.path), { 1 }, other); },
                      "does not match the slices of the given series: 15 of its 15 frames lie at no slice"));
}

TEST(DicomSegmentation, SaysHowItDiffersFromTheSlices)
{
  const Written               written(ObliqueFixture());
  const DicomSegmentationFile file = ReadDicomSegmentation(written.path);
  const auto                  refuses = [&](const std::function<void(DicomSeries &)> & change, const char * reason) {
    DicomSource other = written.source;
    change(other.series);
    return Refuses([&] { ReadDicomSegments(file, { 1 }, other); }, reason);
  };
  EXPECT_TRUE(
    refuses([](DicomSeries & series) { series.size[0] = 6; }, "15 of its 15 frames extend beyond the slices"));
  EXPECT_TRUE(refuses([](DicomSeries & series) { series.spacing[0] = 1.5; },
                      "pixels have 0.75 x 1.25 mm, those of the slices 1.5 x 1.25 mm"));
  const double degree = Pi / 180.0;
  EXPECT_TRUE(refuses([&](DicomSeries & series) { series.direction *= basetest::Rotation(1, 30.0 * degree); },
                      "frames are inclined to them by 30 degrees"));
  EXPECT_TRUE(refuses([&](DicomSeries & series) { series.direction *= basetest::Rotation(2, 45.0 * degree); },
                      "rows and columns of its frames have other directions"));
  EXPECT_TRUE(
    refuses([](DicomSeries & series) { series.slices.resize(3); }, "of its 15 frames lie at no slice, the first at ("));
}

TEST(DicomSegmentation, MirroredFramesAreReadToTheirPlaces)
{
  const Written         written(ObliqueFixture());
  DicomSegmentationFile file = ReadDicomSegmentation(written.path);
  const auto            size = written.labels->GetLargestPossibleRegion().GetSize();
  for (unsigned int k = 0; k < 3; ++k)
  {
    file.orientation[k] *= -1.0;
    for (DicomSegmentFrame & frame : file.frames)
    {
      frame.position[k] += written.source.series.direction(k, 0) * written.source.series.spacing[0] * (size[0] - 1.0);
    }
  }
  const auto mirrored = ReadDicomSegments(file, { 1, 2 }, written.source).labels;
  basetest::ForVoxels(mirrored, [&](const itk::Index<3> & index, const itk::Point<double, 3> &) {
    const itk::Index<3> other{ { static_cast<long>(size[0]) - 1 - index[0], index[1], index[2] } };
    EXPECT_EQ(mirrored->GetPixel(index), written.labels->GetPixel(other)) << index;
  });
}

TEST(DicomSegmentation, RefusesWhatIsNoSegmentation)
{
  const Written written(ObliqueFixture());
  EXPECT_TRUE(Refuses([&] { ReadDicomSegmentation(written.folder + "/im0001.dcm"); }, "is of the kind CTImageStorage"));
  Truncate(written.path, std::filesystem::file_size(written.path) - 20);
  EXPECT_TRUE(Refuses([&] { ReadDicomSegmentation(written.path); }, "seg.dcm\" "));
  EXPECT_THROW(
    WriteDicomSegmentation(written.source, { Segment("none", written.labels, 9) }, HeaderOfTest(), written.path),
    InputError);
}

TEST(DicomSegmentation, ReadsFractionalOnesFromHalfOn)
{
  const Written      written(DicomFixture{});
  DcmFileFormat      file = Loaded(written.path);
  DcmDataset &       dataset = *file.getDataset();
  const std::size_t  pixels = 63;
  std::vector<Uint8> values(pixels * 15 + 1, 0);
  values[3] = 127; // below half of 255
  values[4] = 128;
  dataset.putAndInsertString(DCM_SegmentationType, "FRACTIONAL");
  dataset.putAndInsertUint16(DCM_BitsAllocated, 8);
  dataset.putAndInsertUint16(DCM_MaximumFractionalValue, 255);
  dataset.putAndInsertUint8Array(DCM_PixelData, values.data(), values.size());
  SaveDicom(file, written.path);
  const auto labels = ReadDicomSegments(ReadDicomSegmentation(written.path), { 1 }, written.source).labels;
  std::vector<unsigned short> expected(pixels * 6, 0);
  expected[4] = 1;
  EXPECT_EQ(ValuesOf(labels), expected);
}

TEST(DicomSegmentation, BelongsToTheSeriesThatItNames)
{
  const Written         written(ObliqueFixture());
  DicomSegmentationFile file = ReadDicomSegmentation(written.path);
  EXPECT_NO_THROW(RequireMadeOn(file, written.source));
  DicomSource other = written.source; // same grid at another position
  other.series.uid += ".1";
  EXPECT_TRUE(Refuses([&] { RequireMadeOn(file, other); }, "created from another series"));
  other = written.source;
  other.series.frameOfReferenceUID += ".1";
  EXPECT_TRUE(Refuses([&] { RequireMadeOn(file, other); }, "created from another series"));
  file.seriesUID.clear();
  EXPECT_NO_THROW(RequireMadeOn(file, written.source));
  file.frameOfReferenceUID.clear();
  EXPECT_TRUE(Refuses([&] { RequireMadeOn(file, written.source); }, "does not reference the series"));
}

TEST(DicomSegmentation, RefusesFramesAndSegmentsThatContradictEachOther)
{
  const auto refuses = [](const std::function<void(DcmDataset &)> & change, const std::string & words) {
    const Written written(ObliqueFixture());
    DcmFileFormat file = Loaded(written.path);
    change(*file.getDataset());
    SaveDicom(file, written.path);
    return Refuses([&] { ReadDicomSegments(ReadDicomSegmentation(written.path), { 1 }, written.source); }, words);
  };
  const auto numberOf = [](DcmDataset & dataset, signed long item, Uint16 number) {
    DcmItem * segment = nullptr;
    ASSERT_TRUE(dataset.findAndGetSequenceItem(DCM_SegmentSequence, segment, item).good());
    segment->putAndInsertUint16(DCM_SegmentNumber, number);
  };
  EXPECT_TRUE(refuses([&](DcmDataset & dataset) { numberOf(dataset, 1, 1); }, "declares segment 1 twice"));
  EXPECT_TRUE(refuses([&](DcmDataset & dataset) { numberOf(dataset, 0, 99); }, "which it does not declare"));
  EXPECT_TRUE(refuses([](DcmDataset & dataset) { dataset.findAndDeleteElement(DCM_SegmentSequence); }, "no segment"));
  EXPECT_TRUE(refuses(
    [](DcmDataset & dataset) {
      DcmItem * frames[2];
      for (signed long i = 0; i < 2; ++i)
      {
        dataset.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frames[i], i);
      }
      *frames[1] = *frames[0];
    },
    "two frames of segment 1 in one plane"));
}

TEST(DicomSegmentation, ASegmentIsAskedForOnce)
{
  const Written written(ObliqueFixture());
  EXPECT_THROW(ReadDicomSegments(ReadDicomSegmentation(written.path), { 1, 1 }, written.source), ParameterError);
}

TEST(DicomSegmentation, NamesInOtherCharacterSetsAreUtf8)
{
  const Written written(ObliqueFixture());
  DcmFileFormat file = Loaded(written.path);
  DcmItem *     segment = nullptr;
  ASSERT_TRUE(file.getDataset()->findAndGetSequenceItem(DCM_SegmentSequence, segment, 0).good());
  file.getDataset()->putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 100");
  segment->putAndInsertString(DCM_SegmentLabel,
                              "Gr\xF6\xDF"
                              "e");
  SaveDicom(file, written.path);
  EXPECT_EQ(ReadDicomSegmentation(written.path).segments[0].name,
            "Gr\xC3\xB6\xC3\x9F"
            "e");
}
