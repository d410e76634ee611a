#include "shapetonDicomFixture.h"

#include "itk_zlib.h"

#include "dcmtk/dcmdata/dcostrmb.h"
#include "dcmtk/dcmdata/dcpixel.h"
#include "dcmtk/dcmdata/dcpixseq.h"
#include "dcmtk/dcmdata/dcpxitem.h"
#include "dcmtk/dcmdata/dcrledrg.h"
#include "dcmtk/dcmdata/dcrleerg.h"

#include "gdcmImageChangeTransferSyntax.h"
#include "gdcmImageReader.h"
#include "gdcmTrace.h"
#include "gdcmWriter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;

void
Check(const OFCondition & condition, const std::string & what)
{
  if (condition.bad())
  {
    throw std::runtime_error(what + ": " + condition.text());
  }
}

void
Put(DcmItem & item, const DcmTagKey & tag, const std::string & value)
{
  Check(item.putAndInsertString(tag, value.c_str()), "put");
}

/** A new item in a sequence of an item. */
DcmItem &
AddItem(DcmItem & item, const DcmTagKey & sequence)
{
  DcmItem * added = nullptr;
  Check(item.findOrCreateSequenceItem(sequence, added, -2), "add item");
  return *added;
}

void
PutNumber(std::string & bytes, std::uint32_t number)
{
  bytes.append(reinterpret_cast<const char *>(&number), sizeof(number));
}

void
SetPixelAttributes(DcmItem & item, const DicomFixture & fixture)
{
  item.putAndInsertUint16(DCM_SamplesPerPixel, 1);
  Put(item, DCM_PhotometricInterpretation, "MONOCHROME2");
  item.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(fixture.rows));
  item.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(fixture.columns));
  item.putAndInsertUint16(DCM_BitsAllocated, DicomFixture::bitsAllocated);
  item.putAndInsertUint16(DCM_BitsStored, static_cast<Uint16>(fixture.bitsStored));
  item.putAndInsertUint16(DCM_HighBit, static_cast<Uint16>(fixture.bitsStored - 1));
  item.putAndInsertUint16(DCM_PixelRepresentation, fixture.isSigned ? 1 : 0);
}
} // namespace

std::string
DicomNumbers(const std::vector<double> & numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%.10g", number);
    text += (text.empty() ? "" : "\\") + std::string(digits);
  }
  return text;
}

std::string
DicomOrientation(const itk::Matrix<double, 3, 3> & m)
{
  return DicomNumbers({ m(0, 0), m(1, 0), m(2, 0), m(0, 1), m(1, 1), m(2, 1) });
}

void
SetText(DcmFileFormat & file, const DcmTagKey & tag, const std::string & value)
{
  Put(*file.getDataset(), tag, value);
}

void
SetText(const DicomFixture::Files & files, const DcmTagKey & tag, const std::string & value)
{
  SetText(files, tag, [&](std::size_t) { return value; });
}

void
SetText(const DicomFixture::Files & files, const DcmTagKey & tag, const std::function<std::string(std::size_t)> & value)
{
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    SetText(*files[i], tag, value(i));
  }
}

itk::Matrix<double, 3, 3>
DicomFixture::MakeIdentity()
{
  itk::Matrix<double, 3, 3> identity;
  identity.SetIdentity();
  return identity;
}

DicomFixture::PointType
DicomFixture::MakeOrigin()
{
  const double origin[3] = { -3.5, 12.25, -20.0 };
  return PointType(origin);
}

itk::Matrix<double, 3, 3>
DicomFixture::ObliqueDirection()
{
  // Rotation by 30 degrees about z after 20 degrees about x.
  const double              a = 0.5235987755982988;
  const double              b = 0.3490658503988659;
  const double              rows[9] = { std::cos(a),
                                        -std::sin(a) * std::cos(b),
                                        std::sin(a) * std::sin(b),
                                        std::sin(a),
                                        std::cos(a) * std::cos(b),
                                        -std::cos(a) * std::sin(b),
                                        0.0,
                                        std::sin(b),
                                        std::cos(b) };
  itk::Matrix<double, 3, 3> m;
  std::copy_n(rows, 9, m.GetVnlMatrix().data_block());
  return m;
}

std::vector<double>
DicomFixture::RegularDistances() const
{
  std::vector<double> distances;
  for (unsigned int i = 0; i < slices; ++i)
  {
    distances.push_back(i * sliceSpacing);
  }
  return distances;
}

DicomFixture::PointType
DicomFixture::SlicePosition(double distance, double alongRow, double alongColumn) const
{
  PointType position = origin;
  for (unsigned int i = 0; i < 3; ++i)
  {
    position[i] += direction(i, 0) * alongRow + direction(i, 1) * alongColumn + direction(i, 2) * distance;
  }
  return position;
}

std::vector<Uint16>
DicomFixture::MakePixels(const PointType & position) const
{
  std::vector<Uint16> pixels;
  const unsigned int  mask = (1u << bitsStored) - 1;
  for (unsigned int row = 0; row < rows; ++row)
  {
    for (unsigned int column = 0; column < columns; ++column)
    {
      PointType point = position;
      for (unsigned int i = 0; i < 3; ++i)
      {
        point[i] += direction(i, 0) * columnSpacing * column + direction(i, 1) * rowSpacing * row;
      }
      const auto stored = static_cast<int>(std::lround((intensity(point) - intercept) / slope));
      pixels.push_back(static_cast<Uint16>(static_cast<unsigned int>(stored) & mask));
    }
  }
  return pixels;
}

void
DicomFixture::FillIdentity(DcmDataset & dataset, int instanceNumber) const
{
  Put(dataset, DCM_SpecificCharacterSet, "ISO_IR 192");
  Put(dataset, DCM_SOPInstanceUID, seriesUID + "." + std::to_string(instanceNumber));
  Put(dataset, DCM_StudyInstanceUID, "1.2.826.0.1.3680043.10.1");
  Put(dataset, DCM_SeriesInstanceUID, seriesUID);
  Put(dataset, DCM_FrameOfReferenceUID, "1.2.826.0.1.3680043.10.1.9");
  Put(dataset, DCM_Modality, modality);
  Put(dataset, DCM_SeriesDescription, description);
  Put(dataset, DCM_SeriesNumber, std::to_string(seriesNumber));
  Put(dataset, DCM_InstanceNumber, std::to_string(instanceNumber));
  Put(dataset, DCM_PatientPosition, "HFS");
}

DicomFixture::File
DicomFixture::MakeSlice(const PointType & position, int instanceNumber) const
{
  auto         file = std::make_unique<DcmFileFormat>();
  DcmDataset & dataset = *file->getDataset();
  Put(dataset, DCM_SOPClassUID, UID_CTImageStorage);
  FillIdentity(dataset, instanceNumber);
  Put(dataset, DCM_ImageType, "ORIGINAL\\PRIMARY\\AXIAL");
  Put(dataset, DCM_AcquisitionNumber, "1");
  // Deliberately wrong; readers must not use them as slice distance.
  Put(dataset, DCM_SliceThickness, DicomNumbers({ 3 * sliceSpacing }));
  Put(dataset, DCM_SpacingBetweenSlices, DicomNumbers({ 5 * sliceSpacing }));
  Put(dataset, DCM_ImagePositionPatient, DicomNumbers({ position[0], position[1], position[2] }));
  Put(dataset, DCM_ImageOrientationPatient, DicomOrientation(direction));
  Put(dataset, DCM_PixelSpacing, DicomNumbers({ rowSpacing, columnSpacing }));
  Put(dataset, DCM_RescaleSlope, DicomNumbers({ slope }));
  Put(dataset, DCM_RescaleIntercept, DicomNumbers({ intercept }));
  SetPixelAttributes(dataset, *this);
  const auto pixels = MakePixels(position);
  Check(dataset.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size()), "pixels");
  return file;
}

DicomFixture::Files
DicomFixture::MakeSeries() const
{
  Files files;
  for (unsigned int i = 0; i < slices; ++i)
  {
    files.push_back(MakeSlice(SlicePosition(i * sliceSpacing), static_cast<int>(i) + 1));
  }
  return files;
}

DicomFixture::File
DicomFixture::MakeEnhanced(const std::vector<double> & distances) const
{
  auto         file = std::make_unique<DcmFileFormat>();
  DcmDataset & dataset = *file->getDataset();
  Put(dataset, DCM_SOPClassUID, UID_EnhancedCTImageStorage);
  FillIdentity(dataset, 1);
  Put(dataset, DCM_ImageType, "ORIGINAL\\PRIMARY\\VOLUME\\NONE");
  Put(dataset, DCM_NumberOfFrames, std::to_string(distances.size()));
  SetPixelAttributes(dataset, *this);

  DcmItem & shared = AddItem(dataset, DCM_SharedFunctionalGroupsSequence);
  Put(AddItem(shared, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient, DicomOrientation(direction));
  Put(AddItem(shared, DCM_PixelMeasuresSequence), DCM_PixelSpacing, DicomNumbers({ rowSpacing, columnSpacing }));
  std::vector<Uint16> pixels;
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    const PointType position = SlicePosition(distances[i]);
    DicomFixture    frame(*this);
    frame.slope = slope * (i % 2 == 0 ? 1 : 2); // each frame has its own rescale
    frame.intercept = intercept + static_cast<double>(i);
    DcmItem & own = AddItem(dataset, DCM_PerFrameFunctionalGroupsSequence);
    Put(AddItem(own, DCM_PlanePositionSequence),
        DCM_ImagePositionPatient,
        DicomNumbers({ position[0], position[1], position[2] }));
    DcmItem & rescale = AddItem(own, DCM_PixelValueTransformationSequence);
    Put(rescale, DCM_RescaleSlope, DicomNumbers({ frame.slope }));
    Put(rescale, DCM_RescaleIntercept, DicomNumbers({ frame.intercept }));
    const auto framePixels = frame.MakePixels(position);
    pixels.insert(pixels.end(), framePixels.begin(), framePixels.end());
  }
  Check(dataset.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size()), "pixels");
  return file;
}

DicomFixture::File
DicomFixture::MakeMosaic(bool isAscending) const
{
  const auto          tilesPerRow = static_cast<unsigned int>(std::ceil(std::sqrt(slices)));
  const unsigned int  margin = tilesPerRow - 1; // tiles
  const double        sign = isAscending ? 1.0 : -1.0;
  std::vector<Uint16> pixels(std::size_t(rows) * columns * tilesPerRow * tilesPerRow, 0);
  for (unsigned int tile = 0; tile < slices; ++tile)
  {
    const auto own = MakePixels(SlicePosition(sign * tile * sliceSpacing));
    for (unsigned int row = 0; row < rows; ++row)
    {
      const std::size_t start =
        (tile / tilesPerRow * rows + row) * columns * tilesPerRow + tile % tilesPerRow * columns;
      std::copy_n(&own[std::size_t(row) * columns], columns, &pixels[start]);
    }
  }
  // The position of a slice as large as the mosaic with the same center.
  File file =
    MakeSlice(SlicePosition(0.0, -0.5 * margin * columns * columnSpacing, -0.5 * margin * rows * rowSpacing), 1);
  DcmDataset & dataset = *file->getDataset();
  Put(dataset, DCM_ImageType, "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC");
  Put(dataset, DCM_SpacingBetweenSlices, DicomNumbers({ sliceSpacing }));
  dataset.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(columns * tilesPerRow));
  dataset.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(rows * tilesPerRow));
  Check(dataset.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size()), "pixels");
  std::vector<std::string> normal;
  for (unsigned int i = 0; i < 3; ++i)
  {
    normal.push_back(DicomNumbers({ sign * direction(i, 2) }));
  }
  AddPrivate(dataset,
             0x29,
             "SIEMENS CSA HEADER",
             0x10,
             CsaHeader({ { "NumberOfImagesInMosaic", { std::to_string(slices) } }, { "SliceNormalVector", normal } }));
  return file;
}

DicomFixture::File
DicomFixture::MakeLabelMap(const std::vector<PointType> & frames,
                           const std::vector<Uint16> &    labels,
                           unsigned int                   bits,
                           const std::vector<Uint16> &    segments) const
{
  auto         file = std::make_unique<DcmFileFormat>();
  DcmDataset & dataset = *file->getDataset();
  Put(dataset, DCM_SOPClassUID, "1.2.840.10008.5.1.4.1.1.66.7");
  FillIdentity(dataset, 900);
  Put(dataset, DCM_Modality, "SEG");
  Put(dataset, DCM_SeriesInstanceUID, seriesUID + ".900");
  Put(AddItem(dataset, DCM_ReferencedSeriesSequence), DCM_SeriesInstanceUID, seriesUID);
  Put(dataset, DCM_SegmentationType, "LABELMAP");
  Put(dataset, DCM_NumberOfFrames, std::to_string(frames.size()));
  SetPixelAttributes(dataset, *this);
  dataset.putAndInsertUint16(DCM_PixelRepresentation, 0);
  dataset.putAndInsertUint16(DCM_HighBit, static_cast<Uint16>(bits - 1));
  for (const DcmTagKey & tag : { DCM_BitsAllocated, DCM_BitsStored })
  {
    dataset.putAndInsertUint16(tag, static_cast<Uint16>(bits));
  }
  for (const Uint16 number : segments)
  {
    DcmItem & segment = AddItem(dataset, DCM_SegmentSequence);
    segment.putAndInsertUint16(DCM_SegmentNumber, number);
    Put(segment, DCM_SegmentLabel, "segment " + std::to_string(number));
    DcmItem & type = AddItem(segment, DCM_SegmentedPropertyTypeCodeSequence);
    Put(type, DCM_CodeValue, "71854001");
    Put(type, DCM_CodingSchemeDesignator, "SCT");
  }
  DcmItem & shared = AddItem(dataset, DCM_SharedFunctionalGroupsSequence);
  Put(AddItem(shared, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient, DicomOrientation(direction));
  Put(AddItem(shared, DCM_PixelMeasuresSequence), DCM_PixelSpacing, DicomNumbers({ rowSpacing, columnSpacing }));
  for (const PointType & position : frames)
  {
    DcmItem & own = AddItem(dataset, DCM_PerFrameFunctionalGroupsSequence);
    Put(AddItem(own, DCM_PlanePositionSequence),
        DCM_ImagePositionPatient,
        DicomNumbers({ position[0], position[1], position[2] }));
  }
  const std::vector<Uint8> bytes(labels.begin(), labels.end());
  Check(bits == 8 ? dataset.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size())
                  : dataset.putAndInsertUint16Array(DCM_PixelData, labels.data(), labels.size()),
        "labels");
  return file;
}

void
StoreAsUnknown(DcmItem & item, const std::vector<DcmTagKey> & tags)
{
  for (const DcmTagKey & tag : tags)
  {
    DcmDataset alone;
    Check(alone.insert(item.remove(tag)), "take");
    std::vector<Uint8>    bytes(1 << 20);
    DcmOutputBufferStream stream(bytes.data(), static_cast<offile_off_t>(bytes.size()));
    alone.transferInit();
    Check(alone.write(stream, EXS_LittleEndianImplicit, EET_ExplicitLength, nullptr), "encode");
    alone.transferEnd();
    void *       buffer = nullptr;
    offile_off_t length = 0;
    stream.flushBuffer(buffer, length);
    constexpr offile_off_t header = 8; // tag and length
    auto * const           unknown = new DcmOtherByteOtherWord(DcmTag(tag, EVR_UN));
    unknown->putUint8Array(bytes.data() + header, static_cast<unsigned long>(length - header));
    Check(item.insert(unknown), "store");
  }
}

void
StoreAllAsUnknown(DcmItem & item)
{
  std::vector<DcmTagKey> tags;
  for (DcmObject * next = item.nextInContainer(nullptr); next; next = item.nextInContainer(next))
  {
    tags.emplace_back(next->getGTag(), next->getETag());
  }
  StoreAsUnknown(item, tags);
}

std::string
CsaHeader(const std::vector<std::pair<std::string, std::vector<std::string>>> & elements)
{
  std::string bytes("SV10\4\3\2\1", 8);
  PutNumber(bytes, static_cast<std::uint32_t>(elements.size()));
  PutNumber(bytes, 77);
  for (auto [name, values] : elements)
  {
    name.resize(64);
    bytes += name;
    PutNumber(bytes, 1); // multiplicity
    bytes += std::string("US\0\0", 4);
    PutNumber(bytes, 10); // type
    PutNumber(bytes, static_cast<std::uint32_t>(values.size()));
    PutNumber(bytes, 77);
    for (const std::string & text : values)
    {
      const std::string value(text.c_str(), text.size() + 1);
      for (const std::size_t number : { value.size(), value.size(), std::size_t(77), value.size() })
      {
        PutNumber(bytes, static_cast<std::uint32_t>(number));
      }
      bytes += value + std::string((4 - value.size() % 4) % 4, '\0');
    }
  }
  return bytes + std::string(bytes.size() % 2, '\0');
}

void
AddPrivate(DcmItem & item, Uint16 group, const std::string & creator, Uint16 element, const std::string & bytes)
{
  Uint16    block = 0x10;
  DcmTagKey owner(group, block);
  item.putAndInsertString(DcmTag(owner, EVR_LO), "ANOTHER OWNER");
  owner.setElement(++block);
  item.putAndInsertString(DcmTag(owner, EVR_LO), creator.c_str());
  auto * const value = new DcmOtherByteOtherWord(DcmTag(group, static_cast<Uint16>(block << 8 | element), EVR_UN));
  value->putUint8Array(reinterpret_cast<const Uint8 *>(bytes.data()), static_cast<unsigned long>(bytes.size()));
  item.insert(value, OFTrue);
}

void
StateTransferSyntax(const std::string & path, const std::string & uid)
{
  std::ifstream     stream(path, std::ios::binary);
  std::string       bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::string padded = uid.size() % 2 == 0 ? uid : uid + '\0';
  const std::string stated("UI\x14\0"
                           "1.2.840.10008.1.2.",
                           22);
  const auto        place = bytes.find(stated);
  if (place == std::string::npos || padded.size() > 100)
  {
    throw std::runtime_error("no transfer syntax UID of 19 characters in " + path);
  }
  bytes.replace(place, 24, std::string("UI") + static_cast<char>(padded.size()) + '\0' + padded);
  constexpr std::size_t groupLength = 140; // value of (0002,0000)
  bytes[groupLength] = static_cast<char>(bytes[groupLength] + static_cast<char>(padded.size()) - 20);
  WriteText(path, bytes);
}

void
SaveDicom(DcmFileFormat & file, const std::string & path, E_TransferSyntax syntax)
{
  if (syntax == EXS_RLELossless)
  {
    DcmRLEEncoderRegistration::registerCodecs();
    Check(file.getDataset()->chooseRepresentation(syntax, nullptr), "compress");
  }
  Check(file.saveFile(path.c_str(), syntax), path);
}

void
SaveDicom(const DicomFixture::Files & files,
          const std::string &         folder,
          E_TransferSyntax            syntax,
          const std::string &         stem)
{
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    char number[16];
    std::snprintf(number, sizeof(number), "%04u", static_cast<unsigned int>(i + 1));
    SaveDicom(*files[i], folder + "/" + stem + number + ".dcm", syntax);
  }
}

void
CompressDicom(const std::string & path, const std::string & syntax)
{
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(gdcm::TransferSyntax::GetTSType(syntax.c_str()));
  if (!reader.Read())
  {
    throw std::runtime_error("cannot read " + path);
  }
  change.SetInput(reader.GetImage());
  if (!change.Change())
  {
    throw std::runtime_error("cannot compress " + path);
  }
  // gdcm::ImageWriter would replace the rescale parameters of each frame with common ones.
  gdcm::File & file = reader.GetFile();
  file.GetDataSet().Replace(change.GetOutput().GetDataElement());
  file.GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::GetTSType(syntax.c_str()));
  gdcm::Writer writer;
  writer.SetFileName(path.c_str());
  writer.SetFile(file);
  if (!writer.Write())
  {
    throw std::runtime_error("cannot write " + path);
  }
}

void
CompressSegmentation(const std::string & path, const std::string & syntax)
{
  const auto change = [&](const OFString & sopClass) {
    DcmFileFormat file;
    OFString      before;
    Check(file.loadFile(path.c_str()), "load");
    file.loadAllDataIntoMemory();
    file.getDataset()->findAndGetOFString(DCM_SOPClassUID, before);
    SetText(file, DCM_SOPClassUID, sopClass.c_str());
    Check(file.saveFile(path.c_str(), file.getDataset()->getOriginalXfer()), "save");
    return before;
  };
  const OFString sopClass = change(UID_MultiframeGrayscaleWordSecondaryCaptureImageStorage);
  CompressDicom(path, syntax);
  change(sopClass);
}

namespace
{
/** Frame number `frame` of single bits, moved to the start of a byte. */
std::string
BitsOfFrame(const std::string & all, std::size_t frame, std::size_t pixels)
{
  std::string bits((pixels + 7) / 8, '\0');
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const std::size_t from = frame * pixels + i;
    const int         bit = (all[from / 8] >> (from % 8)) & 1;
    bits[i / 8] = static_cast<char>(bits[i / 8] | bit << (i % 8));
  }
  return bits;
}

/** RFC 1951. */
std::string
Deflated(std::string bytes)
{
  std::string deflated(bytes.size() + 100, '\0');
  z_stream    stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef *>(&bytes[0]);
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef *>(&deflated[0]);
  stream.avail_out = static_cast<uInt>(deflated.size());
  const int status = deflate(&stream, Z_FINISH);
  deflated.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END)
  {
    throw std::runtime_error("cannot deflate");
  }
  return deflated;
}
} // namespace

void
ReplaceFrames(const std::string & path, std::vector<std::string> frames, const std::string & syntax)
{
  DcmFileFormat file;
  Check(file.loadFile(path.c_str()), "load");
  DcmElement * pixels = nullptr;
  Check(file.getDataset()->findAndGetElement(DCM_PixelData, pixels), "pixels");
  auto * const  sequence = new DcmPixelSequence(DCM_PixelSequenceTag);
  auto * const  table = new DcmPixelItem(DCM_PixelItemTag);
  DcmOffsetList offsets;
  sequence->insert(table);
  for (std::string & frame : frames)
  {
    Check(sequence->storeCompressedFrame(
            offsets, reinterpret_cast<Uint8 *>(&frame[0]), static_cast<Uint32>(frame.size()), 0),
          "store");
  }
  Check(table->createOffsetTable(offsets), "table");
  dynamic_cast<DcmPixelData &>(*pixels).putOriginalRepresentation(EXS_RLELossless, nullptr, sequence);
  Check(file.saveFile(path.c_str(), EXS_RLELossless), "save"); // encapsulated in the same way
  StateTransferSyntax(path, syntax);
}

void
DeflateDicomFrames(const std::string & path)
{
  DcmFileFormat file;
  Check(file.loadFile(path.c_str()), "load");
  DcmDataset & dataset = *file.getDataset();
  Uint16       rows = 0, columns = 0, bits = 0;
  Sint32       frames = 1;
  DcmElement * pixels = nullptr;
  Check(dataset.findAndGetUint16(DCM_Rows, rows), "rows");
  Check(dataset.findAndGetUint16(DCM_Columns, columns), "columns");
  Check(dataset.findAndGetUint16(DCM_BitsAllocated, bits), "bits");
  dataset.findAndGetSint32(DCM_NumberOfFrames, frames); // 0 if missing
  Check(dataset.findAndGetElement(DCM_PixelData, pixels), "pixels");
  std::string all(pixels->getLength(), '\0');
  Check(pixels->getPartialValue(&all[0], 0, pixels->getLength()), "read");
  std::vector<std::string> deflated;
  const unsigned           pixelsOfFrame = unsigned{ rows } * columns;
  for (Sint32 i = 0; i < std::max<Sint32>(frames, 1); ++i)
  {
    const auto        frame = static_cast<std::size_t>(i);
    const std::size_t bytes = std::size_t{ pixelsOfFrame } * bits / 8;
    deflated.push_back(Deflated(bits == 1 ? BitsOfFrame(all, frame, pixelsOfFrame) : all.substr(frame * bytes, bytes)));
  }
  ReplaceFrames(path, std::move(deflated), "1.2.840.10008.1.2.8.1");
}

void
Truncate(const std::string & path, std::size_t bytes)
{
  fs::resize_file(path, bytes);
}

std::string
MakeFolder(const std::string & path)
{
  fs::remove_all(path);
  fs::create_directories(path);
  return path;
}

void
WriteText(const std::string & path, const std::string & text)
{
  std::ofstream(path, std::ios::binary) << text;
}

namespace
{
/** A NRRD file of 2 x 2 x 2 float voxels, all 1 except for one. */
void
WriteNrrd(const std::string & path, float special)
{
  const float voxels[8] = { 1, 1, 1, 1, 1, special, 1, 1 };
  WriteText(path,
            "NRRD0004\ntype: float\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nendian: little\nencoding: raw\n\n" +
              std::string(reinterpret_cast<const char *>(voxels), sizeof(voxels)));
}

void
WriteSeriesFaults(const std::string & folder)
{
  const DicomFixture fixture;
  SaveDicom(fixture.MakeSeries(), MakeFolder(folder + "/regular"));
  DicomFixture resonance = fixture;
  resonance.modality = "MR";
  SaveDicom(resonance.MakeSeries(), MakeFolder(folder + "/magneticResonance"));

  auto files = fixture.MakeSeries();
  files.erase(files.begin() + 2, files.begin() + 4);
  SaveDicom(files, MakeFolder(folder + "/gap"));

  files = fixture.MakeSeries();
  files.push_back(fixture.MakeSlice(fixture.SlicePosition(2 * fixture.sliceSpacing), 7));
  SaveDicom(files, MakeFolder(folder + "/duplicateIdentical"));

  DicomFixture other = fixture;
  other.intensity = [](const DicomFixture::PointType & point) { return DicomFixture::Ramp(point) + 10; };
  files = fixture.MakeSeries();
  files.push_back(other.MakeSlice(fixture.SlicePosition(2 * fixture.sliceSpacing), 7));
  SaveDicom(files, MakeFolder(folder + "/duplicateConflicting"));

  files.clear();
  for (const double distance : { 0.0, 2.0, 4.0, 7.0, 10.0, 13.0 })
  {
    files.push_back(fixture.MakeSlice(fixture.SlicePosition(distance), static_cast<int>(files.size()) + 1));
  }
  SaveDicom(files, MakeFolder(folder + "/variableSpacing"));

  files.clear();
  for (unsigned int i = 0; i < fixture.slices; ++i)
  {
    files.push_back(fixture.MakeSlice(fixture.SlicePosition(2.0 * i, 0.0, 0.5 * i), static_cast<int>(i) + 1));
  }
  SaveDicom(files, MakeFolder(folder + "/shear"));
}

void
WriteGroups(const std::string & folder)
{
  const DicomFixture fixture;
  DicomFixture       sagittal = fixture;
  sagittal.direction.Fill(0.0);
  sagittal.direction(1, 0) = 1;
  sagittal.direction(2, 1) = -1;
  sagittal.direction(0, 2) = -1;
  MakeFolder(folder + "/mixedSeries");
  SaveDicom(fixture.MakeSeries(), folder + "/mixedSeries");
  SaveDicom(sagittal.MakeSeries(), folder + "/mixedSeries", EXS_LittleEndianExplicit, "other");

  auto deidentified = fixture.MakeSeries();
  SetText(deidentified, DCM_FrameOfReferenceUID, [&](std::size_t i) {
    return fixture.seriesUID + ".7." + std::to_string(i + 1);
  });
  SaveDicom(deidentified, MakeFolder(folder + "/mixedFrameOfReference"));
  deidentified.erase(deidentified.begin() + 2);
  SaveDicom(deidentified, MakeFolder(folder + "/framesApart"));

  DicomFixture scout = sagittal;
  scout.slices = 2;
  scout.seriesUID += ".2";
  scout.description = "SCOUT";
  auto scouts = scout.MakeSeries();
  SetText(scouts, DCM_ImageType, "ORIGINAL\\PRIMARY\\LOCALIZER");
  SaveDicom(scouts, MakeFolder(folder + "/localizer"));
  SaveDicom(fixture.MakeSeries(), MakeFolder(folder + "/withLocalizer"));
  SaveDicom(scouts, folder + "/withLocalizer", EXS_LittleEndianExplicit, "scout");

  DicomFixture second = fixture;
  second.seriesUID += ".3";
  second.seriesNumber = 2;
  second.description = "SECOND";
  SaveDicom(fixture.MakeSeries(), MakeFolder(folder + "/twoSeries"));
  SaveDicom(second.MakeSeries(), folder + "/twoSeries", EXS_LittleEndianExplicit, "second");

  const auto distances = fixture.RegularDistances();
  SaveDicom(
    *fixture.MakeEnhanced({ distances[3], distances[0], distances[5], distances[1], distances[4], distances[2] }),
    MakeFolder(folder + "/enhancedShuffled") + "/multi.dcm");
  SaveDicom(*fixture.MakeEnhanced({ distances[0], distances[1], distances[4], distances[5] }),
            MakeFolder(folder + "/enhancedGap") + "/multi.dcm");
}

void
WriteBadFiles(const std::string & folder)
{
  const DicomFixture fixture;
  SaveDicom(fixture.MakeSeries(), MakeFolder(folder + "/truncated"));
  const std::string cut = folder + "/truncated/im0003.dcm";
  Truncate(cut, fs::file_size(cut) - 40);

  const std::string cutHeader = MakeFolder(folder + "/truncatedHeader") + "/im0001.dcm";
  SaveDicom(fixture.MakeSeries(), folder + "/truncatedHeader");
  Truncate(cutHeader, 400);

  auto video = fixture.MakeSeries();
  SaveDicom(video, MakeFolder(folder + "/unsupportedTransferSyntax"));
  for (const auto & entry : fs::directory_iterator(folder + "/unsupportedTransferSyntax"))
  {
    // The last digits of "1.2.840.10008.1.2.1" become those of an unregistered encoding.
    std::fstream      stream(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
    std::string       bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    const std::size_t place = bytes.find("1.2.840.10008.1.2.1");
    stream.seekp(static_cast<std::streamoff>(place));
    stream << "1.2.840.10008.1.2.9";
  }

  MakeFolder(folder + "/empty");
  WriteText(MakeFolder(folder + "/text") + "/a.txt", "no image\n");
  WriteText(folder + "/text/b.csv", "1,2\n");
  SaveDicom(*fixture.MakeSlice(fixture.origin, 1), MakeFolder(folder + "/single") + "/slice.dcm");

  const auto color = fixture.MakeSlice(fixture.origin, 1);
  color->getDataset()->putAndInsertUint16(DCM_SamplesPerPixel, 3);
  SetText(*color, DCM_PhotometricInterpretation, "RGB");
  SaveDicom(*color, MakeFolder(folder + "/color") + "/color.dcm");

  const auto flat = fixture.MakeSlice(fixture.origin, 1);
  flat->getDataset()->findAndDeleteElement(DCM_ImagePositionPatient);
  SaveDicom(*flat, MakeFolder(folder + "/twoDimensional") + "/flat.dcm");
}

/** Inputs in the style of other programs. */
void
WriteOtherPrograms(const std::string & folder)
{
  const DicomFixture fixture;
  auto               unknown = fixture.MakeSeries();
  auto               mosaics = fixture.MakeSeries();
  auto               commas = fixture.MakeSeries();
  auto               interleaved = fixture.MakeSeries();
  for (std::size_t i = 0; i < fixture.slices; ++i)
  {
    StoreAllAsUnknown(*unknown[i]->getDataset());
    SetText(*mosaics[i], DCM_ImageType, "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC");
    SetText(*commas[i], DCM_PixelSpacing, "1,25\\0,75");
    SetText(*interleaved[i], DCM_ConvolutionKernel, i % 2 == 0 ? "B30f" : "B70f");
  }
  SaveDicom(unknown, MakeFolder(folder + "/unknownRepresentation"));
  SaveDicom(mosaics, MakeFolder(folder + "/mosaic"));
  SaveDicom(commas, MakeFolder(folder + "/comma"));
  SaveDicom(interleaved, MakeFolder(folder + "/interleaved"));
  const std::size_t slice = std::size_t(fixture.columns) * fixture.rows;
  SaveDicom(*fixture.MakeLabelMap({ fixture.origin }, std::vector<Uint16>(slice, 1), 8, { 1 }),
            MakeFolder(folder + "/labelMap") + "/map.dcm");
  const std::vector<DicomFixture::PointType> tilted{ fixture.origin, fixture.SlicePosition(2.0, 0.0, 0.5) };
  SaveDicom(*fixture.MakeLabelMap(tilted, std::vector<Uint16>(2 * slice, 1), 8, { 1 }), // of the series "shear"
            MakeFolder(folder + "/tiltedLabelMap") + "/map.dcm");

  DcmFileFormat contours;
  SetText(contours, DCM_SOPClassUID, UID_RTStructureSetStorage);
  SetText(contours, DCM_SOPInstanceUID, fixture.seriesUID + ".8");
  SaveDicom(contours, MakeFolder(folder + "/structureSet") + "/contours.dcm");
}

void
WriteImageFiles(const std::string & folder)
{
  WriteNrrd(folder + "/finite.nrrd", 2.0F);
  WriteNrrd(folder + "/nan.nrrd", std::nanf(""));
  WriteText(folder + "/short.nrrd",
            "NRRD0004\ntype: float\ndimension: 3\nsizes: 900 900 900\nendian: little\nencoding: raw\n\nabcd");
  WriteText(folder + "/text.nrrd", "no image\n");
  WriteText(folder + "/text.nii", "no image\n");
  WriteText(folder + "/text.mha", "no image\n");
  WriteText(folder + "/flat.nrrd", "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 2 2\nencoding: raw\n\nabcd");
  WriteText(folder + "/color.nrrd",
            "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 1 1 2\nkinds: RGB-color domain domain domain\n"
            "encoding: raw\n\nabcdef");
}
} // namespace

void
WriteFaultyInputs(const std::string & folder)
{
  MakeFolder(folder);
  WriteSeriesFaults(folder);
  WriteGroups(folder);
  WriteBadFiles(folder);
  WriteOtherPrograms(folder);
  WriteImageFiles(folder);
}
} // namespace shapeton
