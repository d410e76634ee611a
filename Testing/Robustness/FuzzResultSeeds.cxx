#include "FuzzResultSeeds.h"
#include "FuzzTrial.h"

#include "shapetonDicomFixture.h"
#include "shapetonDicomMeasurements.h"
#include "shapetonDicomReportReader.h"
#include "shapetonDicomSegmentationReader.h"
#include "shapetonFileBytes.h"
#include "shapetonMappedImage.h"

namespace
{
using namespace shapeton;

constexpr const char * frameOfReference = "1.2.4";

DicomLabelImage::Pointer
MakeLabels(const DicomSource & source)
{
  const auto labels = NewImageOn<DicomLabelImage>(source.grid);
  for (unsigned short i = 0; i < 7 * 9 * 6; ++i)
  {
    labels->GetBufferPointer()[i] = i % 3;
  }
  return labels;
}

std::string
MakeSegmentation(const std::string & path, const DicomSource & source, DicomSegmentationFormat format)
{
  const auto                labels = MakeLabels(source);
  std::vector<DicomSegment> segments(2);
  for (unsigned short i = 0; i < 2; ++i)
  {
    segments[i].name = "segment " + std::to_string(i);
    segments[i].category = { "123037004", "SCT", "Anatomical Structure" };
    segments[i].type = { "71854001", "SCT", "Colon" };
    segments[i].trackingID = segments[i].name;
    segments[i].trackingUID = "2.25.1";
    segments[i].labels = labels;
    segments[i].label = static_cast<unsigned short>(i + 1);
  }
  WriteDicomSegmentation(source, segments, { "Fuzz", "1", 1, "Fuzz" }, path, format);
  return ReadFileBytes(path);
}

std::string
MakeFractional(const std::string & path, const DicomSource & source)
{
  MakeSegmentation(path, source, DicomSegmentationFormat::Binary);
  DcmFileFormat file;
  file.loadFile(path.c_str());
  std::vector<Uint8> values(7 * 9 * 12, 200);
  file.getDataset()->putAndInsertString(DCM_SegmentationType, "FRACTIONAL");
  file.getDataset()->putAndInsertUint16(DCM_BitsAllocated, 8);
  file.getDataset()->putAndInsertUint16(DCM_BitsStored, 8);
  file.getDataset()->putAndInsertUint16(DCM_HighBit, 7);
  file.getDataset()->putAndInsertUint16(DCM_MaximumFractionalValue, 255);
  file.getDataset()->putAndInsertUint8Array(DCM_PixelData, values.data(), values.size());
  SaveDicom(file, path);
  return ReadFileBytes(path);
}

std::string
MakeCompressed(const std::string & path, const DicomSource & source, void (*compress)(const std::string &))
{
  MakeFractional(path, source);
  compress(path);
  return ReadFileBytes(path);
}

void
CompressAsJpegLS(const std::string & path)
{
  CompressSegmentation(path, "1.2.840.10008.1.2.4.80");
}

/** A segmentation as other programs write it: optionally with VR UN, and with a label in another character set. */
std::string
MakeLabelMap(const std::string & path, unsigned int bits, bool isUnknown)
{
  const DicomFixture  fixture;
  std::vector<Uint16> labels;
  for (Uint16 i = 0; i < 7 * 9 * 2; ++i)
  {
    labels.push_back(i % 3);
  }
  const auto file = fixture.MakeLabelMap({ fixture.origin, fixture.SlicePosition(4.0) }, labels, bits, { 1, 2 });
  DcmItem *  segment = nullptr;
  file->getDataset()->findAndGetSequenceItem(DCM_SegmentSequence, segment);
  SetText(*file, DCM_SpecificCharacterSet, "\\ISO 2022 IR 87");
  segment->putAndInsertString(DCM_SegmentLabel, "\x1b$B;3ED\x1b(B");
  if (isUnknown)
  {
    StoreAllAsUnknown(*file->getDataset());
  }
  SaveDicom(*file, path);
  return ReadFileBytes(path);
}

std::string
MakeReport(const std::string & path, const DicomSource & source, DicomReportKind kind)
{
  const DicomCode    center{ "111010", "DCM", "Center" };
  const DicomContent group = ContainerContent(
    "CONTAINS",
    { "125007", "DCM", "Measurement Group" },
    { TextContent("HAS OBS CONTEXT", { "112039", "DCM", "Tracking Identifier" }, "candidate"),
      kind == DicomReportKind::ColonCAD ? PixelPointContent("CONTAINS", center, { 0.0, 14.0, -16.0 }, source)
                                        : SpacePointContent("CONTAINS", center, { 1.0, 2.0, 3.0 }) });
  const DicomContent root = ContainerContent({}, { "126000", "DCM", "Imaging Measurement Report" }, { group }, "1500");
  WriteDicomReport(source, kind, root, {}, { "Fuzz", "1", 2, "Fuzz" }, path);
  return ReadFileBytes(path);
}
} // namespace

DicomSource
MakeResultSource(const std::string & folder)
{
  const auto files = DicomFixture().MakeSeries();
  for (const auto & file : files)
  {
    SetText(*file, DCM_StudyInstanceUID, "1.2.3");
    SetText(*file, DCM_FrameOfReferenceUID, frameOfReference);
  }
  SaveDicom(files, folder);
  return ReadDicomSource(folder);
}

std::string
MakeResultOfFalseLength(const std::string & folder, const DicomSource & source)
{
  const std::string path = folder + "/seed.dcm";
  MakeSegmentation(path, source, DicomSegmentationFormat::Binary);
  StateTransferSyntax(path, "1.2.840.10008.1.2.1.99"); // deflated
  const std::string     bytes = ReadFileBytes(path);
  constexpr std::size_t groupLength = 140; // value of (0002,0000)
  const std::size_t     start = groupLength + 4 + static_cast<unsigned char>(bytes.at(groupLength));
  std::string           dataset = bytes.substr(start);
  const std::size_t     pixels = dataset.rfind(std::string("\xE0\x7F\x10\0OB\0\0", 8));
  dataset.replace(pixels + 8, 4, std::string("\0\0\0\xE0", 4));
  const std::string     gzipped = Gzip(dataset);
  constexpr std::size_t header = 10, trailer = 8; // RFC 1952
  return bytes.substr(0, start) + gzipped.substr(header, gzipped.size() - header - trailer);
}

std::vector<FuzzSeed>
MakeResultSeeds(const std::string & folder, const DicomSource & source)
{
  const std::string path = folder + "/seed.dcm";
  return { { ResultExtension, MakeSegmentation(path, source, DicomSegmentationFormat::Binary) },
           { ResultExtension, MakeSegmentation(path, source, DicomSegmentationFormat::DeflatedBinary) },
           { ResultExtension, MakeSegmentation(path, source, DicomSegmentationFormat::LabelMap) },
           { ResultExtension, MakeSegmentation(path, source, DicomSegmentationFormat::DeflatedLabelMap) },
           { ResultExtension, MakeCompressed(path, source, DeflateDicomFrames) },
           { ResultExtension, MakeCompressed(path, source, CompressAsJpegLS) },
           { ResultExtension, MakeFractional(path, source) },
           { ResultExtension, MakeLabelMap(path, 8, false) },
           { ResultExtension, MakeLabelMap(path, 16, false) },
           { ResultExtension, MakeLabelMap(path, 8, true) },
           { ResultExtension, MakeReport(path, source, DicomReportKind::Comprehensive3D) },
           { ResultExtension, MakeReport(path, source, DicomReportKind::ColonCAD) } };
}

bool
ReadAllOfResult(const std::string & path, const DicomSource & source)
{
  bool isRead = IsRead([&] {
    const DicomSegmentationFile file = ReadDicomSegmentation(path);
    std::vector<int>            numbers;
    for (const DicomSegmentInFile & segment : file.segments)
    {
      numbers.push_back(segment.number);
    }
    ReadDicomSegments(file, numbers, source);
  });
  isRead |= IsRead([&] { ReadDicomReportPoints(path, source); });
  return isRead;
}
