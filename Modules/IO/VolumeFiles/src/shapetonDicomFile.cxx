#include "shapetonDicomFile.h"

#include "shapetonDicomAttributes.h"
#include "shapetonDicomMosaic.h"
#include "shapetonDicomTransferSyntax.h"
#include "shapetonStoredVoxels.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"
#include "dcmtk/dcmdata/dcpixseq.h"
#include "dcmtk/dcmdata/dcpxitem.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>

namespace shapeton
{
namespace
{
// Longer values stay on disk until they are accessed.
constexpr Uint32 MaximumEagerValue = 4096;

// Maximum decoded frame size in bytes for input of any size ...
constexpr std::uint64_t HarmlessFrameBytes = 64u << 20;
// ... and as a multiple of the input size. JPEG and RLE have lower ratios; only constant images in JPEG-LS or JPEG 2000
// exceed this limit.
constexpr std::uint64_t MaximumCompression = 2000;

// Cosines have about six digits; a larger error indicates an invalid rotation.
constexpr double CosineTolerance = 1e-3;

std::string
GetText(DcmItem & item, const DcmTagKey & tag)
{
  return DicomTextOf(item, tag).text;
}

/** An integer, or `missing`. */
int
GetInteger(DcmItem & item, const DcmTagKey & tag, int missing)
{
  try
  {
    const auto numbers = DicomNumbersOf(item, tag, 1);
    return !numbers.empty() && std::abs(numbers[0]) <= std::numeric_limits<std::int32_t>::max()
             ? static_cast<int>(numbers[0])
             : missing;
  }
  catch (const MalformedDicomValue &)
  {
    return missing;
  }
}

std::uint16_t
GetWord(DcmItem & item, const DcmTagKey & tag, std::uint16_t missing)
{
  Uint16 word = missing;
  return item.findAndGetUint16(tag, word).good() ? word : missing;
}

/** The first item of a sequence, or null. */
DcmItem *
GetItem(DcmItem * item, const DcmTagKey & sequence, signed long number = 0)
{
  DcmItem * found = nullptr;
  return item && item->findAndGetSequenceItem(sequence, found, number).good() ? found : nullptr;
}

/** Checks for the DICOM signature, because parsers guess the type of other files. */
enum class Signature
{
  none,
  /** Possibly a data set without a meta header. */
  dataSet,
  file
};

Signature
FindSignature(const std::string & path)
{
  std::ifstream stream(path, std::ios::binary);
  char          head[132] = {};
  stream.read(head, sizeof(head));
  if (stream.gcount() == sizeof(head) && std::string(head + 128, 4) == "DICM")
  {
    return Signature::file;
  }
  // Without a meta header the file starts with group 0002 or 0008, in either byte order.
  const bool isLittle = (head[0] == 2 || head[0] == 8) && head[1] == 0;
  const bool isBig = head[0] == 0 && (head[1] == 2 || head[1] == 8);
  return stream.gcount() >= 8 && (isLittle || isBig) ? Signature::dataSet : Signature::none;
}

// ---- frames ----

/** The location of a frame attribute: the functional group of the frame, the shared one, or the data set. */
class FrameAttributes
{
public:
  FrameAttributes(DcmItem & dataset, DcmItem * own, DcmItem * shared, bool isEnhanced)
    : m_Dataset(dataset), m_Own(own), m_Shared(shared), m_IsEnhanced(isEnhanced)
  {}

  /** The item that contains the attributes of a functional group. */
  DcmItem *
  Find(const DcmTagKey & group) const
  {
    if (!m_IsEnhanced)
    {
      return &m_Dataset;
    }
    DcmItem * const own = GetItem(m_Own, group);
    return own ? own : GetItem(m_Shared, group);
  }

  std::vector<double>
  Numbers(const DcmTagKey & group, const DcmTagKey & tag, std::size_t count) const
  {
    DcmItem * const item = this->Find(group);
    return item ? DicomNumbersOf(*item, tag, count) : std::vector<double>();
  }

  std::string
  Text(const DcmTagKey & group, const DcmTagKey & tag) const
  {
    DcmItem * const item = this->Find(group);
    return item ? GetText(*item, tag) : std::string();
  }

private:
  DcmItem & m_Dataset;
  DcmItem * m_Own;
  DcmItem * m_Shared;
  bool      m_IsEnhanced;
};

bool
IsRotation(const double (&cosines)[6])
{
  const double * const row = cosines;
  const double * const column = cosines + 3;
  const auto           dot = [](const double * a, const double * b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  return std::abs(dot(row, row) - 1) <= CosineTolerance && std::abs(dot(column, column) - 1) <= CosineTolerance &&
         std::abs(dot(row, column)) <= CosineTolerance;
}

void
ReadGeometry(const FrameAttributes & attributes, DicomFrame & frame, std::string & refusal)
{
  const auto position = attributes.Numbers(DCM_PlanePositionSequence, DCM_ImagePositionPatient, 3);
  const auto orientation = attributes.Numbers(DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient, 6);
  const auto spacing = attributes.Numbers(DCM_PixelMeasuresSequence, DCM_PixelSpacing, 2);
  const auto thickness = attributes.Numbers(DCM_PixelMeasuresSequence, DCM_SliceThickness, 1);
  frame.thickness = !thickness.empty() && thickness[0] > 0 ? thickness[0] : 0.0;
  if (position.empty() || orientation.empty())
  {
    refusal = "a 2-D image (no Image Position and Orientation (Patient))";
    return;
  }
  std::copy(position.begin(), position.end(), frame.position);
  std::copy(orientation.begin(), orientation.end(), frame.orientation);
  if (!IsRotation(frame.orientation))
  {
    refusal = "Image Orientation (Patient) is not a pair of perpendicular unit vectors";
    return;
  }
  if (spacing.empty() || !(spacing[0] > 0) || !(spacing[1] > 0))
  {
    refusal = "Pixel Spacing is missing or not positive";
    return;
  }
  std::copy(spacing.begin(), spacing.end(), frame.spacing);
  frame.hasGeometry = true;
}

void
ReadRescale(const FrameAttributes & attributes, DicomPixelFormat & pixels, std::string & refusal)
{
  DcmItem * const item = attributes.Find(DCM_PixelValueTransformationSequence);
  if (!item)
  {
    return;
  }
  const auto slope = DicomNumbersOf(*item, DCM_RescaleSlope, 1);
  const auto intercept = DicomNumbersOf(*item, DCM_RescaleIntercept, 1);
  pixels.hasRescale = !slope.empty() || !intercept.empty();
  pixels.slope = slope.empty() ? 1.0 : slope[0];
  pixels.intercept = intercept.empty() ? 0.0 : intercept[0];
  if (pixels.slope == 0)
  {
    refusal = "Rescale Slope is 0";
  }
}

/** An attribute that distinguishes acquisitions and reconstructions: its tag in a plain image and in a functional group
 * of an enhanced image, or `noAttribute` where it does not exist. */
struct AcquisitionKey
{
  DcmTagKey plain;
  DcmTagKey group;
  DcmTagKey enhanced;
};

const DcmTagKey noAttribute(0xFFFF, 0xFFFF);

constexpr unsigned int ImageTypeKey = 5; // place of the image type in acquisitionKeys

const AcquisitionKey acquisitionKeys[DicomFrame::NumberOfAcquisitionKeys] = {
  { DCM_AcquisitionNumber, DCM_FrameContentSequence, DCM_FrameAcquisitionNumber },
  { DCM_TemporalPositionIdentifier, DCM_FrameContentSequence, DCM_TemporalPositionIndex },
  { DCM_EchoNumbers, DCM_MREchoSequence, DCM_EffectiveEchoTime },
  { DCM_DiffusionBValue, DCM_MRDiffusionSequence, DCM_DiffusionBValue },
  { noAttribute, DCM_FrameContentSequence, DCM_StackID },
  { DCM_ImageType, noAttribute, DCM_FrameType }, // the group depends on the modality
  { DCM_ConvolutionKernel, DCM_CTReconstructionSequence, DCM_ConvolutionKernel },
  { DCM_FilterType, DCM_CTReconstructionSequence, DCM_ReconstructionAlgorithm },
  { DCM_ReconstructionDiameter, DCM_CTReconstructionSequence, DCM_ReconstructionDiameter },
  { DCM_SliceThickness, DCM_PixelMeasuresSequence, DCM_SliceThickness },
  { DCM_KVP, DCM_CTXRayDetailsSequence, DCM_KVP },
  { DCM_ReconstructionAlgorithm, noAttribute, noAttribute },
  { DCM_ReconstructionTargetCenterPatient, DCM_CTReconstructionSequence, DCM_ReconstructionTargetCenterPatient },
  { DCM_RescaleType, DCM_PixelValueTransformationSequence, DCM_RescaleType },
  { DCM_DerivationDescription, DCM_DerivationImageSequence, DCM_DerivationDescription },
  { DCM_ContrastBolusAgent, noAttribute, noAttribute },
  { DCM_ProtocolName, noAttribute, noAttribute },
  { DCM_EchoTime, noAttribute, noAttribute },
  { DCM_SeriesNumber, noAttribute, noAttribute },
  { DCM_SeriesDescription, noAttribute, noAttribute }
};

void
ReadAcquisition(const FrameAttributes & attributes, bool isEnhanced, bool isMR, DicomFrame & frame)
{
  for (unsigned int i = 0; i < DicomFrame::NumberOfAcquisitionKeys; ++i)
  {
    const AcquisitionKey & key = acquisitionKeys[i];
    frame.acquisition[i] = isEnhanced ? attributes.Text(key.group, key.enhanced) : attributes.Text(DCM_Item, key.plain);
  }
  std::string & type = frame.acquisition[ImageTypeKey];
  if (isEnhanced)
  {
    type = attributes.Text(isMR ? DCM_MRImageFrameTypeSequence : DCM_CTImageFrameTypeSequence, DCM_FrameType);
  }
  frame.isLocalizer = type.find("LOCALIZER") != std::string::npos || type.find("SCOUT") != std::string::npos;
}

// ---- pixels ----

std::int64_t
SignExtended(std::int64_t value, unsigned int bits)
{
  const std::int64_t sign = std::int64_t(1) << (bits - 1);
  return ((value & (2 * sign - 1)) ^ sign) - sign;
}

/** The VR of Pixel Padding Value is US or SS and may differ from that of the pixels. */
void
ReadPadding(DcmItem & dataset, DicomPixelFormat & pixels)
{
  const int     value = GetInteger(dataset, DCM_PixelPaddingValue, 65536);
  const int     limit = GetInteger(dataset, DCM_PixelPaddingRangeLimit, value);
  constexpr int greatest = 65535;
  if (std::abs(value) > greatest || std::abs(limit) > greatest)
  {
    return;
  }
  const auto stored = [&pixels](std::int64_t integer) {
    return pixels.isSigned ? SignExtended(integer, 16) : integer & 0xFFFF;
  };
  pixels.hasPadding = true;
  pixels.paddingLow = std::min(stored(value), stored(limit));
  pixels.paddingHigh = std::max(stored(value), stored(limit));
}

std::string
ReadPixelFormat(DcmItem & dataset, DicomPixelFormat & pixels)
{
  pixels.bitsAllocated = GetWord(dataset, DCM_BitsAllocated, 0);
  pixels.bitsStored = GetWord(dataset, DCM_BitsStored, pixels.bitsAllocated);
  pixels.highBit = GetWord(dataset, DCM_HighBit, static_cast<std::uint16_t>(pixels.bitsStored - 1));
  pixels.isSigned = GetWord(dataset, DCM_PixelRepresentation, 0) == 1;
  if (pixels.bitsAllocated != 8 && pixels.bitsAllocated != 16)
  {
    return std::to_string(pixels.bitsAllocated) + " bits allocated for a pixel are not supported";
  }
  if (pixels.bitsStored < 1 || pixels.bitsStored > pixels.bitsAllocated || pixels.highBit >= pixels.bitsAllocated ||
      pixels.highBit + 1 < pixels.bitsStored)
  {
    return "Bits Stored and High Bit contradict Bits Allocated";
  }
  ReadPadding(dataset, pixels);
  return {};
}

std::string
GetRefusal(DcmItem & dataset, bool & isOtherObject, DicomMosaic & mosaic)
{
  const std::string photometric = GetText(dataset, DCM_PhotometricInterpretation);
  isOtherObject = true;
  const std::string sopClass = GetText(dataset, DCM_SOPClassUID);
  if (sopClass == UID_SegmentationStorage || sopClass == LabelMapSegmentationStorageUID)
  {
    return "a segmentation; read it with DicomResultsToColon";
  }
  if (dataset.tagExists(DCM_SegmentSequence))
  {
    return "a segmentation, not intensities";
  }
  const std::string missing = IsSiemensMosaic(dataset) ? ReadSiemensMosaic(dataset, mosaic) : std::string();
  if (!missing.empty())
  {
    return "a Siemens mosaic (the slices of a volume as tiles of one image) without " + missing +
           ", which its private attributes state before de-identification; convert the original to NIfTI, for example "
           "with dcm2niix";
  }
  if (dataset.tagExists(DCM_DoseGridScaling))
  {
    return "a dose grid, not intensities";
  }
  if (GetWord(dataset, DCM_SamplesPerPixel, 1) != 1 || photometric == "RGB" || photometric == "PALETTE COLOR" ||
      photometric.compare(0, 3, "YBR") == 0)
  {
    return "a color image (" + (photometric.empty() ? "several samples per pixel" : photometric) + ")";
  }
  isOtherObject = false;
  if (!photometric.empty() && photometric != "MONOCHROME1" && photometric != "MONOCHROME2")
  {
    return "Photometric Interpretation " + photometric + " is not supported";
  }
  if (dataset.tagExistsWithValue(DCM_ModalityLUTSequence))
  {
    return "its Modality LUT Sequence (a table of intensities) is not supported";
  }
  if (dataset.tagExists(DCM_FloatPixelData) || dataset.tagExists(DCM_DoubleFloatPixelData))
  {
    isOtherObject = true;
    return "floating-point pixel data are not supported";
  }
  return {};
}

/** Bytes of the encapsulated pixel data. */
std::uint64_t
CountFragmentBytes(DcmPixelSequence & sequence)
{
  std::uint64_t bytes = 0;
  for (unsigned long i = 1; i < sequence.card(); ++i)
  {
    DcmPixelItem * item = nullptr;
    if (sequence.getItem(item, i).good() && item)
    {
      bytes += item->getLength();
    }
  }
  return bytes;
}

std::string
CheckEncapsulated(DcmPixelData & pixelData, E_TransferSyntax syntax, std::uint64_t frames, std::uint64_t frameBytes)
{
  DcmPixelSequence *                 sequence = nullptr;
  E_TransferSyntax                   storedSyntax = syntax;
  const DcmRepresentationParameter * parameters = nullptr;
  pixelData.getOriginalRepresentationKey(storedSyntax, parameters);
  if (pixelData.getEncapsulatedRepresentation(storedSyntax, parameters, sequence).bad() || !sequence)
  {
    return "the compressed pixel data are missing";
  }
  const unsigned long fragments = sequence->card() > 0 ? sequence->card() - 1 : 0;
  if (fragments < frames)
  {
    return "it has " + std::to_string(fragments) + " of " + std::to_string(frames) + " compressed frames";
  }
  const std::uint64_t bytes = CountFragmentBytes(*sequence);
  if (frameBytes > HarmlessFrameBytes && frameBytes / MaximumCompression > bytes)
  {
    return "its " + std::to_string(bytes) + " compressed bytes are not sufficient for the image that the header states";
  }
  return {};
}

/** Compares the size in the header with the file size; returns a description of missing data. */
std::string
CheckPixelData(DcmDataset & dataset, const DicomFile & file, const DicomPixelFormat & pixels)
{
  DcmElement * element = nullptr;
  if (dataset.findAndGetElement(DCM_PixelData, element).bad() || !element)
  {
    return "it has no pixel data";
  }
  auto * const pixelData = dynamic_cast<DcmPixelData *>(element);
  if (!pixelData)
  {
    return "its pixel data are malformed";
  }
  const std::uint64_t tiles = std::uint64_t(file.tilesPerRow) * file.tilesPerRow;
  const std::uint64_t frames = file.tilesPerRow > 1 ? 1 : file.frames.size();
  const std::uint64_t frameBytes = tiles * file.rows * file.columns * (pixels.bitsAllocated / 8);
  const std::uint64_t needed = frameBytes * frames;
  const DcmXfer       syntax(dataset.getOriginalXfer());
  if (syntax.isEncapsulated())
  {
    return CheckEncapsulated(*pixelData, syntax.getXfer(), frames, frameBytes);
  }
  std::error_code     error;
  const std::uint64_t length = std::filesystem::file_size(file.path, error);
  const bool          isDeflated = syntax.getStreamCompression() == ESC_zlib;
  const std::uint64_t limit = error ? 0 : isDeflated ? length * MaximumDeflateRatio : length;
  const std::uint64_t present = std::min<std::uint64_t>(pixelData->getLength(dataset.getOriginalXfer()), limit);
  if (present < needed)
  {
    return "its pixel data have " + std::to_string(present) + " of " + std::to_string(needed) + " bytes";
  }
  return {};
}

// ---- the file ----

/** Whether functional groups describe the frames of an image. Some scanners add such groups to plain slices (CT or MR
 * Image Storage), which have complete attributes. */
bool
IsEnhanced(DcmDataset & dataset)
{
  const std::string sopClass = GetText(dataset, DCM_SOPClassUID);
  const bool        isPlain = sopClass == UID_CTImageStorage || sopClass == UID_MRImageStorage ||
                       dataset.tagExistsWithValue(DCM_ImagePositionPatient);
  return (dataset.tagExists(DCM_PerFrameFunctionalGroupsSequence) ||
          dataset.tagExists(DCM_SharedFunctionalGroupsSequence)) &&
         !(isPlain && GetInteger(dataset, DCM_NumberOfFrames, 1) <= 1);
}

void
ReadFrames(DcmDataset & dataset, std::uint64_t count, DicomFile & file)
{
  const bool      isEnhanced = IsEnhanced(dataset);
  DcmItem * const shared = GetItem(&dataset, DCM_SharedFunctionalGroupsSequence);
  DicomFrame      common;
  std::string     refusal = ReadPixelFormat(dataset, common.pixels);
  for (std::uint64_t i = 0; i < count && refusal.empty(); ++i)
  {
    DicomFrame            frame = common;
    DcmItem * const       own = GetItem(&dataset, DCM_PerFrameFunctionalGroupsSequence, static_cast<signed long>(i));
    const FrameAttributes attributes(dataset, own, shared, isEnhanced);
    ReadGeometry(attributes, frame, refusal);
    ReadRescale(attributes, frame.pixels, refusal);
    ReadAcquisition(attributes, isEnhanced, file.modality == "MR", frame);
    file.frames.push_back(frame);
  }
  if (file.refusal.empty() && !refusal.empty())
  {
    file.refusal = refusal;
    file.isOtherObject = file.frames.empty() || !file.frames.back().hasGeometry;
  }
}

/** The number of frames described by the file. */
std::uint64_t
CountFrames(DcmDataset & dataset, DicomFile & file)
{
  const int claimed = GetInteger(dataset, DCM_NumberOfFrames, 1);
  if (claimed <= 1 && !IsEnhanced(dataset))
  {
    return 1;
  }
  if (!IsEnhanced(dataset))
  {
    file.refusal = "a multi-frame image whose frames have no position (no functional groups)";
    file.isOtherObject = true;
    file.unplacedFrames = static_cast<unsigned int>(claimed) - 1;
    return 1;
  }
  DcmSequenceOfItems * sequence = nullptr;
  dataset.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, sequence);
  const unsigned long described = sequence ? sequence->card() : 0;
  if (file.refusal.empty() && (claimed < 1 || static_cast<unsigned long>(claimed) != described))
  {
    file.truncation = "it describes " + std::to_string(described) + " of " + std::to_string(claimed) + " frames";
  }
  return std::min<std::uint64_t>(described, claimed < 1 ? 0 : static_cast<std::uint64_t>(claimed));
}

/** Replaces the only frame of a mosaic by its tiles. The stated position is that of a slice as large as the mosaic with
 * the same center (nibabel, MosaicWrapper). */
void
SplitMosaic(DcmItem & dataset, const DicomMosaic & mosaic, DicomFile & file)
{
  if (mosaic.tiles < 2 || !file.refusal.empty() || file.frames.size() != 1 || !file.frames.front().hasGeometry)
  {
    return;
  }
  const auto   distances = DicomNumbersOf(dataset, DCM_SpacingBetweenSlices, 1);
  DicomFrame   frame = file.frames.front();
  const double distance = !distances.empty() && distances[0] > 0 ? distances[0] : frame.thickness;
  if (file.rows % mosaic.tilesPerRow != 0 || file.columns % mosaic.tilesPerRow != 0 || !(distance > 0))
  {
    file.refusal = "a Siemens mosaic whose rows, columns or slice distance do not match its " +
                   std::to_string(mosaic.tiles) + " slices";
    file.isOtherObject = true;
    return;
  }
  const double margin[2] = { (file.columns - file.columns / mosaic.tilesPerRow) / 2.0,
                             (file.rows - file.rows / mosaic.tilesPerRow) / 2.0 };
  file.tilesPerRow = mosaic.tilesPerRow;
  file.rows = static_cast<std::uint16_t>(file.rows / mosaic.tilesPerRow);
  file.columns = static_cast<std::uint16_t>(file.columns / mosaic.tilesPerRow);
  const itk::Vector<double, 3> row(frame.orientation);
  const itk::Vector<double, 3> column(frame.orientation + 3);
  itk::Vector<double, 3>       step = itk::CrossProduct(row, column);
  step *= (step * itk::Vector<double, 3>(mosaic.normal) < 0 ? -distance : distance) / step.GetNorm();
  file.frames.clear();
  for (unsigned int tile = 0; tile < mosaic.tiles; ++tile)
  {
    DicomFrame slice = frame;
    for (unsigned int i = 0; i < 3; ++i)
    {
      slice.position[i] +=
        margin[0] * frame.spacing[1] * row[i] + margin[1] * frame.spacing[0] * column[i] + tile * step[i];
    }
    file.frames.push_back(slice);
  }
}

void
ReadIdentity(DcmFileFormat & format, DcmDataset & dataset, DicomFile & file)
{
  file.studyUID = GetText(dataset, DCM_StudyInstanceUID);
  file.sopClassUID = GetText(dataset, DCM_SOPClassUID);
  file.sopInstanceUID = GetText(dataset, DCM_SOPInstanceUID);
  file.seriesUID = GetText(dataset, DCM_SeriesInstanceUID);
  file.frameOfReferenceUID = GetText(dataset, DCM_FrameOfReferenceUID);
  file.patientID = GetText(dataset, DCM_PatientID);
  file.studyDate = GetText(dataset, DCM_StudyDate);
  const DicomText description = DicomTextOf(dataset, DCM_SeriesDescription);
  file.description = description.text;
  file.isUndecodable = !description.isDecoded;
  file.modality = GetText(dataset, DCM_Modality);
  file.patientPosition = GetText(dataset, DCM_PatientPosition);
  file.seriesNumber = GetInteger(dataset, DCM_SeriesNumber, 0);
  file.instanceNumber = GetInteger(dataset, DCM_InstanceNumber, 0);
  file.isInverted = GetText(dataset, DCM_PhotometricInterpretation) == "MONOCHROME1";

  const DicomEncoding encoding = DicomEncodingOf(format);
  file.transferSyntax = encoding.name;
  file.isUnsupportedTransferSyntax = !encoding.isSupported;
  file.isDerived = GetText(dataset, DCM_ImageType).rfind("DERIVED", 0) == 0; // the first of its values
  file.isLossy = IsLossy(dataset.getOriginalXfer()) || GetText(dataset, DCM_LossyImageCompression) == "01";
}

void
ReadImage(DcmDataset & dataset, DicomFile & file, bool isIncomplete)
{
  file.kind = DicomFile::Kind::image;
  file.isMultiFrame = IsEnhanced(dataset);
  file.rows = GetWord(dataset, DCM_Rows, 0);
  file.columns = GetWord(dataset, DCM_Columns, 0);
  DicomMosaic mosaic;
  file.refusal = GetRefusal(dataset, file.isOtherObject, mosaic);
  if (file.refusal.empty() && (file.rows == 0 || file.columns == 0))
  {
    file.refusal = "it has no rows or no columns";
    file.isOtherObject = true;
  }
  try
  {
    ReadFrames(dataset, CountFrames(dataset, file), file);
    SplitMosaic(dataset, mosaic, file);
  }
  catch (const MalformedDicomValue & malformed)
  {
    file.malformedValue = file.refusal.empty() ? malformed.what() : "";
    file.frames.clear();
  }
  if (file.refusal.empty() && file.truncation.empty() && !file.isUnsupportedTransferSyntax && !file.frames.empty())
  {
    file.truncation = CheckPixelData(dataset, file, file.frames.front().pixels);
  }
  if (file.truncation.empty() && isIncomplete && !file.isUnsupportedTransferSyntax)
  {
    file.truncation = "the file is truncated within its data, or malformed";
  }
}

/** The name of an object without an image. */
std::string
ObjectName(DcmFileFormat & format, DcmDataset & dataset)
{
  std::string uid = GetText(dataset, DCM_SOPClassUID);
  if (uid.empty())
  {
    uid = GetText(*format.getMetaInfo(), DCM_MediaStorageSOPClassUID);
  }
  return uid.empty() ? std::string() : std::string(dcmFindNameOfUID(uid.c_str(), uid.c_str()));
}
} // namespace

std::string
DicomFrame::NameOfAcquisitionKey(unsigned int key)
{
  const DcmTagKey & plain = acquisitionKeys[key].plain;
  return DcmTag(plain == noAttribute ? acquisitionKeys[key].enhanced : plain).getTagName();
}

DicomFile
ParseDicomFile(const std::string & path)
{
  DicomFile file;
  file.path = path;
  const Signature signature = FindSignature(path);
  if (signature == Signature::none)
  {
    return file;
  }
  DcmFileFormat     format;
  const std::string fault = LoadDicomFile(format, path, MaximumEagerValue);
  DcmDataset &      dataset = *format.getDataset();
  const std::string object = ObjectName(format, dataset);
  const bool        isImage = dataset.tagExists(DCM_Rows) && dataset.tagExists(DCM_Columns);
  if (isImage)
  {
    ReadIdentity(format, dataset, file);
    ReadImage(dataset, file, !fault.empty());
  }
  else if (!fault.empty())
  {
    file.kind = DicomFile::Kind::damaged;
    file.what = std::string("the file is truncated within its header, or malformed (") + fault + ")";
  }
  else if (!object.empty() || signature == Signature::file)
  {
    file.kind = DicomFile::Kind::notImage;
    file.what = object.empty() ? "of unknown kind" : object;
  }
  return file;
}
} // namespace shapeton
