#include "shapetonDicomSeriesWriter.h"
#include "shapetonDicomSeriesFolder.h"
#include "shapetonDicomText.h"

#include "shapetonSha256.h"
#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"

#include "itkImageRegionConstIterator.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <limits>
#include <vector>

namespace shapeton
{
namespace
{
using ShortImage = itk::Image<short, 3>;

constexpr int rescaleIntercept = -1024; // HU of the stored value 0
constexpr int largestValue = 31743;     // HU; see PhantomImageSource

// Number of Unicode characters of a UTF-8 text.
std::size_t
CountCharacters(const std::string & text)
{
  return std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; });
}

void
CheckText(const char * name, const std::string & text, std::size_t limit)
{
  if (CountCharacters(text) > limit)
  {
    throw InputError(std::string("the ") + name + " has more than " + std::to_string(limit) +
                     " characters, the most that DICOM allows; shorten it");
  }
  if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == '\x7F' || c == '\\'; }))
  {
    throw InputError(std::string("the ") + name +
                     " contains a backslash or a control character, which DICOM does not allow; remove it");
  }
}

void
CheckDescription(const DicomSeriesDescription & description)
{
  constexpr std::size_t longText = 10240; // value representation LT
  CheckText("patient's name", description.patientName, 64);
  CheckText("patient ID", description.patientID, 64);
  CheckText("study description", description.studyDescription, 64);
  CheckText("series description", description.seriesDescription, 64);
  CheckText("comment", description.comments, longText);
  const std::array<const char *, 8> positions{ "HFS", "HFP", "HFDR", "HFDL", "FFS", "FFP", "FFDR", "FFDL" };
  if (std::find(positions.begin(), positions.end(), description.patientPosition) == positions.end())
  {
    throw InputError("the patient position must be HFS, HFP, HFDR, HFDL, FFS, FFP, FFDR or FFDL, not \"" +
                     description.patientPosition + '"');
  }
  if (description.seriesNumber < 0)
  {
    throw InputError("the series number " + std::to_string(description.seriesNumber) + " is negative");
  }
}

void
CheckDirection(const ShortImage::DirectionType & direction)
{
  constexpr double                      tolerance = 1e-6;
  std::array<itk::Vector<double, 3>, 3> axes;
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int row = 0; row < 3; ++row)
    {
      axes[i][row] = direction(row, i);
    }
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = i; j < 3; ++j)
    {
      if (!(std::abs(axes[i] * axes[j] - (i == j ? 1.0 : 0.0)) <= tolerance))
      {
        throw InputError(
          "the image axes are not perpendicular unit vectors, which a CT series requires; resample the image");
      }
    }
  }
  if (itk::CrossProduct(axes[0], axes[1]) * axes[2] < 0.0)
  {
    throw InputError("the image axes are left-handed, which a CT series cannot represent; flip one axis of the image");
  }
}

void
CheckValues(const ShortImage * image)
{
  short lowest = std::numeric_limits<short>::max();
  short highest = std::numeric_limits<short>::min();
  for (itk::ImageRegionConstIterator<ShortImage> it(image, image->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    lowest = std::min(lowest, it.Get());
    highest = std::max(highest, it.Get());
  }
  if (lowest < rescaleIntercept || highest > largestValue)
  {
    throw InputError("the values " + std::to_string(lowest) + " to " + std::to_string(highest) +
                     " exceed the range -1024 to 31743 of a CT series; clamp or rescale them");
  }
}

void
CheckImage(const ShortImage * image)
{
  const auto & region = image->GetLargestPossibleRegion();
  if (image->GetBufferedRegion() != region)
  {
    throw InputError("the image is not completely in memory; update its largest possible region");
  }
  constexpr itk::SizeValueType greatest = 65535;
  if (region.GetSize(0) < 1 || region.GetSize(1) < 1 || region.GetSize(0) > greatest || region.GetSize(1) > greatest)
  {
    throw InputError("the slices have " + std::to_string(region.GetSize(0)) + " x " +
                     std::to_string(region.GetSize(1)) + " pixels; a CT series allows 1 to 65535 in each direction");
  }
  if (region.GetSize(2) < 2)
  {
    throw InputError("the image has fewer than two slices, so their distance is undefined");
  }
  CheckDirection(image->GetDirection());
  CheckValues(image);
}

// Strings and numbers common to all slices.
struct SeriesHeader
{
  std::string studyUID;
  std::string seriesUID;
  std::string frameOfReferenceUID;
  std::string orientation;
  std::string pixelSpacing;
  std::string sliceThickness;
  std::string windowCenter;
  std::string windowWidth;
  Uint16      bitsStored{ 16 };
};

std::string
IdentityOfImage(const ShortImage * image)
{
  const auto &             size = image->GetLargestPossibleRegion().GetSize();
  const std::size_t        slicePixels = size[0] * size[1];
  std::vector<std::string> parts;
  ShortImage::PointType    origin;
  image->TransformIndexToPhysicalPoint(image->GetLargestPossibleRegion().GetIndex(), origin);
  for (unsigned int i = 0; i < 3; ++i)
  {
    parts.push_back(std::to_string(size[i]));
    parts.push_back(DicomDecimal(image->GetSpacing()[i]));
    parts.push_back(DicomDecimal(origin[i]));
    for (unsigned int j = 0; j < 3; ++j)
    {
      parts.push_back(DicomDecimal(image->GetDirection()(i, j)));
    }
  }
  for (std::size_t slice = 0; slice < size[2]; ++slice)
  {
    const auto * const pixels = reinterpret_cast<const char *>(image->GetBufferPointer() + slice * slicePixels);
    parts.push_back(Sha256OfBytes(std::string(pixels, slicePixels * sizeof(short))));
  }
  return ConcatenateTexts(parts);
}

SeriesHeader
MakeSeriesHeader(const ShortImage * image, const DicomSeriesDescription & description)
{
  const std::string study =
    ConcatenateTexts({ description.patientID, description.studyDescription, std::to_string(description.seed) });
  const std::string series = ConcatenateTexts({ study,
                                                description.patientName,
                                                description.seriesDescription,
                                                description.comments,
                                                description.patientPosition,
                                                std::to_string(description.seriesNumber),
                                                IdentityOfImage(image) });
  SeriesHeader      header;
  header.studyUID = MakeDicomUID("study " + study);
  header.frameOfReferenceUID = MakeDicomUID("frame of reference " + study);
  header.seriesUID = MakeDicomUID("series " + series);

  const auto & direction = image->GetDirection();
  header.orientation = JoinDicomValues({ DicomDecimal(direction(0, 0)),
                                         DicomDecimal(direction(1, 0)),
                                         DicomDecimal(direction(2, 0)),
                                         DicomDecimal(direction(0, 1)),
                                         DicomDecimal(direction(1, 1)),
                                         DicomDecimal(direction(2, 1)) });
  const auto & spacing = image->GetSpacing();
  header.pixelSpacing = JoinDicomValues({ DicomDecimal(spacing[1]), DicomDecimal(spacing[0]) }); // row spacing first
  header.sliceThickness = DicomDecimal(spacing[2]);

  const short * const first = image->GetBufferPointer();
  const auto          range = std::minmax_element(first, first + image->GetLargestPossibleRegion().GetNumberOfPixels());
  const int           lowest = *range.first;
  const int           highest = *range.second;
  header.windowCenter = DicomDecimal(0.5 * (lowest + highest + 1));
  header.windowWidth = std::to_string(highest - lowest + 1);
  constexpr int usualBits = 12;
  header.bitsStored = highest - rescaleIntercept < 1 << usualBits ? usualBits : 16;
  return header;
}

// Inserts attributes and records the first failure.
class DatasetWriter
{
public:
  explicit DatasetWriter(DcmDataset & dataset) : m_Dataset(dataset) {}

  void
  Text(const DcmTagKey & tag, const std::string & value)
  {
    this->Check(value.empty() ? m_Dataset.insertEmptyElement(tag) : m_Dataset.putAndInsertString(tag, value.c_str()));
  }
  void
  Number(const DcmTagKey & tag, Uint16 value)
  {
    this->Check(m_Dataset.putAndInsertUint16(tag, value));
  }
  void
  Pixels(const std::vector<Uint16> & pixels)
  {
    this->Check(m_Dataset.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size()));
  }

private:
  void
  Check(const OFCondition & condition)
  {
    if (condition.bad())
    {
      throw OutputError(std::string("cannot create a DICOM header: ") + condition.text() + "; report this as a bug");
    }
  }
  DcmDataset & m_Dataset;
};

void
PutPatientAndStudy(DatasetWriter & writer, const DicomSeriesDescription & description, const SeriesHeader & header)
{
  writer.Text(DCM_SpecificCharacterSet, "ISO_IR 192");
  writer.Text(DCM_PatientName, description.patientName);
  writer.Text(DCM_PatientID, description.patientID);
  writer.Text(DCM_PatientBirthDate, "");
  writer.Text(DCM_PatientSex, "O");
  writer.Text(DCM_StudyInstanceUID, header.studyUID);
  writer.Text(DCM_StudyDate, "20000101");
  writer.Text(DCM_StudyTime, "120000");
  writer.Text(DCM_StudyID, "1");
  writer.Text(DCM_StudyDescription, description.studyDescription);
  writer.Text(DCM_AccessionNumber, "");
  writer.Text(DCM_ReferringPhysicianName, "");
}

void
PutSeriesAndEquipment(DatasetWriter & writer, const DicomSeriesDescription & description, const SeriesHeader & header)
{
  writer.Text(DCM_Modality, "CT");
  writer.Text(DCM_SeriesInstanceUID, header.seriesUID);
  writer.Text(DCM_SeriesNumber, std::to_string(description.seriesNumber));
  writer.Text(DCM_SeriesDate, "20000101");
  writer.Text(DCM_SeriesTime, "120000");
  writer.Text(DCM_SeriesDescription, description.seriesDescription);
  writer.Text(DCM_PatientPosition, description.patientPosition);
  writer.Text(DCM_FrameOfReferenceUID, header.frameOfReferenceUID);
  writer.Text(DCM_PositionReferenceIndicator, "");
  writer.Text(DCM_Manufacturer, DicomSeriesManufacturer);
  writer.Text(DCM_ManufacturerModelName, DicomSeriesModel);
}

void
PutImage(DatasetWriter &                writer,
         const DicomSeriesDescription & description,
         const SeriesHeader &           header,
         const ShortImage *             image,
         std::size_t                    slice)
{
  const auto &          region = image->GetLargestPossibleRegion();
  ShortImage::IndexType index = region.GetIndex();
  index[2] += static_cast<itk::IndexValueType>(slice);
  ShortImage::PointType position;
  image->TransformIndexToPhysicalPoint(index, position);

  const std::string number = std::to_string(slice + 1);
  writer.Text(DCM_SOPClassUID, UID_CTImageStorage);
  writer.Text(DCM_SOPInstanceUID, MakeDicomUID("image " + header.seriesUID + ' ' + number));
  writer.Text(DCM_ImageType, "ORIGINAL\\PRIMARY\\AXIAL");
  writer.Text(DCM_InstanceNumber, number);
  writer.Text(DCM_AcquisitionNumber, "1");
  writer.Text(DCM_ImageLaterality, "U"); // not a paired body part
  writer.Text(DCM_AcquisitionDate, "20000101");
  writer.Text(DCM_AcquisitionTime, "120000");
  writer.Text(DCM_ContentDate, "20000101");
  writer.Text(DCM_ContentTime, "120000");
  if (!description.comments.empty())
  {
    writer.Text(DCM_ImageComments, description.comments);
  }
  writer.Text(DCM_ImagePositionPatient,
              JoinDicomValues({ DicomDecimal(position[0]), DicomDecimal(position[1]), DicomDecimal(position[2]) }));
  writer.Text(DCM_ImageOrientationPatient, header.orientation);
  writer.Text(DCM_PixelSpacing, header.pixelSpacing);
  writer.Text(DCM_SliceThickness, header.sliceThickness);
  writer.Text(DCM_KVP, "");
  writer.Text(DCM_RescaleIntercept, std::to_string(rescaleIntercept));
  writer.Text(DCM_RescaleSlope, "1");
  writer.Text(DCM_RescaleType, "HU");
  writer.Text(DCM_WindowCenter, header.windowCenter);
  writer.Text(DCM_WindowWidth, header.windowWidth);

  writer.Number(DCM_SamplesPerPixel, 1);
  writer.Text(DCM_PhotometricInterpretation, "MONOCHROME2");
  writer.Number(DCM_Rows, static_cast<Uint16>(region.GetSize(1)));
  writer.Number(DCM_Columns, static_cast<Uint16>(region.GetSize(0)));
  writer.Number(DCM_BitsAllocated, 16);
  writer.Number(DCM_BitsStored, header.bitsStored);
  writer.Number(DCM_HighBit, header.bitsStored - 1);
  writer.Number(DCM_PixelRepresentation, 0);

  const std::size_t   slicePixels = region.GetSize(0) * region.GetSize(1);
  const short * const first = image->GetBufferPointer() + slice * slicePixels;
  std::vector<Uint16> pixels(slicePixels);
  std::transform(first, first + slicePixels, pixels.begin(), [](short value) {
    return static_cast<Uint16>(value - rescaleIntercept);
  });
  writer.Pixels(pixels);
}

void
SaveSlice(DcmFileFormat & file, const std::string & folder, const std::string & name)
{
  const std::string path = folder + '/' + name;
  errno = 0;
  const OFCondition condition = file.saveFile(path.c_str(), EXS_LittleEndianExplicit);
  if (condition.bad())
  {
    ThrowCannotWrite(path, errno, condition.text());
  }
}
} // namespace

std::string
DicomSliceName(std::size_t number)
{
  const std::string digits = std::to_string(number);
  return "IM" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits + ".dcm";
}

void
WriteDicomSlices(const ShortImage *             image,
                 const std::string &            folder,
                 const DicomSeriesDescription & description,
                 const std::function<void()> &  beforeSlice)
{
  CheckDescription(description);
  CheckImage(image);
  const SeriesHeader header = MakeSeriesHeader(image, description);
  const std::size_t  slices = image->GetLargestPossibleRegion().GetSize(2);
  for (std::size_t slice = 0; slice < slices; ++slice)
  {
    beforeSlice();
    DcmFileFormat file;
    DatasetWriter writer(*file.getDataset());
    PutPatientAndStudy(writer, description, header);
    PutSeriesAndEquipment(writer, description, header);
    PutImage(writer, description, header, image, slice);
    SaveSlice(file, folder, DicomSliceName(slice + 1));
  }
}

void
WriteDicomSeries(const ShortImage * image, const std::string & folder, const DicomSeriesDescription & description)
{
  WriteDicomSlices(image, folder, description, [] {});
}
} // namespace shapeton
