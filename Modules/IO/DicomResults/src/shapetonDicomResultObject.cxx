#include "shapetonDicomResultObject.h"

#include "shapetonDicomText.h"
#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonOperatingSystem.h"
#include "shapetonSha256.h"

#include "dcmtk/dcmdata/dcistrmb.h"
#include "dcmtk/dcmdata/dcrleerg.h"

#include <algorithm>
#include <ctime>
#include <regex>
#include <set>

namespace shapeton
{
namespace
{
/** Required attributes, possibly empty. */
const DcmTagKey expected[] = {
  DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate,       DCM_PatientSex, DCM_StudyInstanceUID,
  DCM_StudyDate,   DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID,    DCM_AccessionNumber
};

/** The dates of a source, in order of preference. */
const std::pair<DcmTagKey, DcmTagKey> dates[] = { { DCM_AcquisitionDate, DCM_AcquisitionTime },
                                                  { DCM_ContentDate, DCM_ContentTime },
                                                  { DCM_SeriesDate, DCM_SeriesTime },
                                                  { DCM_StudyDate, DCM_StudyTime } };

std::string
StoredTextOf(DcmItem & item, const DcmTagKey & tag)
{
  OFString text;
  item.findAndGetOFStringArray(tag, text);
  return text.c_str();
}

/** Date and time of a source. Content Date and Time must not be empty; if the source has no date, they are set to 1900,
 * the earliest year that some readers accept. */
std::pair<std::string, std::string>
TimeOf(DcmDataset & dataset)
{
  const std::string midnight = "000000";
  for (const auto & [dateTag, timeTag] : dates)
  {
    if (const std::string date = StoredTextOf(dataset, dateTag); !date.empty())
    {
      const std::string time = StoredTextOf(dataset, timeTag);
      return { date, time.empty() ? midnight : time };
    }
  }
  return { "19000101", midnight };
}

/** The current date and time, at an offset from UTC such as "+0130"; local time for any other text. */
std::pair<std::string, std::string>
CurrentTime(const std::string & offset)
{
  const std::time_t now = std::time(nullptr);
  const bool        hasOffset = std::regex_match(offset, std::regex("[+-][0-9]{4}"));
  if (!hasOffset)
  {
    return { LocalTimeText(now, "%Y%m%d"), LocalTimeText(now, "%H%M%S") };
  }
  constexpr int     perMinute = 60, perHour = 3600; // seconds
  const int         seconds = perHour * std::stoi(offset.substr(1, 2)) + perMinute * std::stoi(offset.substr(3, 2));
  const std::time_t there = now + (offset[0] == '-' ? -seconds : seconds);
  return { UniversalTimeText(there, "%Y%m%d"), UniversalTimeText(there, "%H%M%S") };
}

/** Designators of private coding schemes ("99...") in a data set. */
std::set<std::string>
PrivateSchemesOf(DcmDataset & dataset)
{
  std::set<std::string> schemes;
  DcmStack              stack;
  while (dataset.nextObject(stack, OFTrue).good())
  {
    auto * const element = dynamic_cast<DcmElement *>(stack.top());
    OFString     scheme;
    if (element && element->getTag() == DCM_CodingSchemeDesignator && element->getOFString(scheme, 0).good() &&
        scheme.compare(0, 2, "99") == 0)
    {
      schemes.insert(scheme.c_str());
    }
  }
  return schemes;
}

void
SaveFile(DcmFileFormat & file, const std::string & path, E_TransferSyntax syntax)
{
  errno = 0;
  const OFCondition condition = file.saveFile(path.c_str(), syntax);
  if (condition.bad())
  {
    ThrowCannotWrite(path, errno, condition.text());
  }
}

/** Reads the attributes copied from the source. */
void
ReadHeader(const DicomSource & source, DcmDataset & dataset)
{
  std::string          bytes = source.header;
  DcmInputBufferStream stream;
  stream.setBuffer(&bytes[0], static_cast<offile_off_t>(bytes.size()));
  stream.setEos();
  dataset.transferInit();
  const OFCondition condition = dataset.read(stream, EXS_LittleEndianExplicit);
  dataset.transferEnd();
  if (condition.bad())
  {
    throw InputError("the header of the source series cannot be read: " + std::string(condition.text()) +
                     "; inspect it with DicomSeriesInspector");
  }
}

void
ConvertHeaderToUtf8(DcmDataset & dataset)
{
  const OFCondition condition = dataset.convertToUTF8();
  if (condition.bad())
  {
    throw InputError("the header of the source series cannot be converted to UTF-8: " + std::string(condition.text()) +
                     "; inspect it with DicomSeriesInspector");
  }
}
} // namespace

bool
IsAscii(const std::string & text)
{
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string
PatientIDOf(const DicomSource & source)
{
  DcmDataset header;
  ReadHeader(source, header);
  ConvertHeaderToUtf8(header);
  return StoredTextOf(header, DCM_PatientID);
}

DicomResultObject::DicomResultObject(const DicomSource &       source,
                                     const char *              sopClassUID,
                                     const std::string &       modality,
                                     const DicomResultHeader & header)
  : m_Source(source), m_SopClassUID(sopClassUID)
{
  this->PutSourceHeader();
  this->PutDates(header.dates);
  m_LossyRatio = this->Take(DCM_LossyImageCompressionRatio);
  m_LossyMethod = this->Take(DCM_LossyImageCompressionMethod);
  this->Root()
    .Text(DCM_SOPClassUID, m_SopClassUID)
    .Text(DCM_Modality, modality)
    .Text(DCM_SeriesNumber, std::to_string(header.seriesNumber))
    .Text(DCM_SeriesDescription, header.seriesDescription)
    .Text(DCM_InstanceNumber, "1")
    .Text(DCM_Manufacturer, "Shapeton")
    .Text(DCM_ManufacturerModelName, header.tool)
    .Text(DCM_DeviceSerialNumber, "0")
    .Text(DCM_SoftwareVersions, header.version);
  if (!header.bodyPart.empty() && modality != "SR" && modality != "M3D") // not an attribute of reports and surfaces
  {
    this->Root().Text(DCM_BodyPartExamined, header.bodyPart);
  }
}

void
DicomResultObject::PutSourceHeader()
{
  DcmDataset & dataset = *m_File.getDataset();
  ReadHeader(m_Source, dataset);
  for (const DcmTagKey & tag : expected)
  {
    if (!dataset.tagExists(tag))
    {
      this->Root().Text(tag, "");
    }
  }
}

void
DicomResultObject::ConvertToUtf8()
{
  ConvertHeaderToUtf8(*m_File.getDataset());
}

void
DicomResultObject::PutDates(DicomResultDates wanted)
{
  DcmDataset & dataset = *m_File.getDataset();
  const auto [date, time] =
    wanted == DicomResultDates::Now ? CurrentTime(StoredTextOf(dataset, DCM_TimezoneOffsetFromUTC)) : TimeOf(dataset);
  this->Take(DCM_AcquisitionDate);
  this->Take(DCM_AcquisitionTime);
  for (const DcmTagKey & tag : { DCM_SeriesDate, DCM_ContentDate, DCM_InstanceCreationDate })
  {
    this->Root().Text(tag, date);
  }
  for (const DcmTagKey & tag : { DCM_SeriesTime, DCM_ContentTime, DCM_InstanceCreationTime })
  {
    this->Root().Text(tag, time);
  }
}

/** The value of a source attribute that is not copied to all results. */
std::string
DicomResultObject::Take(const DcmTagKey & tag)
{
  const std::string value = StoredTextOf(*m_File.getDataset(), tag);
  m_File.getDataset()->findAndDeleteElement(tag);
  return value;
}

void
DicomResultObject::PutLossiness()
{
  this->Root().Text(DCM_LossyImageCompression, m_Source.series.isLossy ? "01" : "00");
  if (m_Source.series.isLossy && !m_LossyRatio.empty())
  {
    this->Root()
      .Text(DCM_LossyImageCompressionRatio, m_LossyRatio)
      .Text(DCM_LossyImageCompressionMethod, m_LossyMethod);
  }
}

void
DicomResultObject::PutFrameOfReference()
{
  this->Root()
    .Text(DCM_FrameOfReferenceUID, m_Source.series.frameOfReferenceUID)
    .Text(DCM_PositionReferenceIndicator, "");
}

void
DicomResultObject::PutContentQualification()
{
  this->Root().Text(DCM_ContentQualification, "RESEARCH");
}

void
DicomResultObject::PutReferencedSeries()
{
  DicomItem   series = this->Root().Add(DCM_ReferencedSeriesSequence).Text(DCM_SeriesInstanceUID, m_Source.series.uid);
  std::string last;
  for (const DicomSlice & slice : m_Source.series.slices)
  {
    if (slice.sopInstanceUID != last) // the frames of one instance are consecutive
    {
      last = slice.sopInstanceUID;
      series.Add(DCM_ReferencedInstanceSequence)
        .Text(DCM_ReferencedSOPClassUID, slice.sopClassUID)
        .Text(DCM_ReferencedSOPInstanceUID, slice.sopInstanceUID);
    }
  }
}

DicomItem
DicomResultObject::PutSharedPlane()
{
  const itk::ImageBase<3> & grid = *m_Source.grid;
  const auto &              axes = grid.GetDirection();
  const auto &              spacing = grid.GetSpacing();
  DicomItem                 shared = this->Root().Add(DCM_SharedFunctionalGroupsSequence);
  shared.Add(DCM_PlaneOrientationSequence)
    .Decimals(DCM_ImageOrientationPatient, { axes(0, 0), axes(1, 0), axes(2, 0), axes(0, 1), axes(1, 1), axes(2, 1) });
  const double thickness = m_Source.series.slices.front().thickness;
  shared.Add(DCM_PixelMeasuresSequence)
    .Decimals(DCM_PixelSpacing, { spacing[1], spacing[0] }) // row spacing first
    .Decimals(DCM_SpacingBetweenSlices, { spacing[2] })
    .Decimals(DCM_SliceThickness, { thickness > 0.0 ? thickness : spacing[2] });
  return shared;
}

/** Names private coding schemes, whose designators are not unique worldwide. */
void
DicomResultObject::PutCodingSchemes()
{
  for (const std::string & scheme : PrivateSchemesOf(*m_File.getDataset()))
  {
    const std::string owner = scheme == "99SHAPETON" ? "Shapeton" : "unknown";
    this->Root()
      .Add(DCM_CodingSchemeIdentificationSequence)
      .Text(DCM_CodingSchemeDesignator, scheme)
      .Text(DCM_CodingSchemeName, "Private codes of " + owner)
      .Text(DCM_CodingSchemeResponsibleOrganization, owner);
  }
}

DicomInstance
DicomResultObject::Save(const std::string & path, E_TransferSyntax syntax)
{
  this->PutCodingSchemes();
  // UIDs are derived from the bytes of the object before UIDs are added, and from its encoding.
  const std::string none = "2.25.0";
  this->Root().Text(DCM_SeriesInstanceUID, none).Text(DCM_SOPInstanceUID, none);
  SaveFile(m_File, path, EXS_LittleEndianExplicit);
  const bool        isPlain = syntax == EXS_LittleEndianExplicit;
  const std::string digest = Sha256OfFile(path) + (isPlain ? "" : DcmXfer(syntax).getXferName());
  const std::string series = MakeDicomUID("series " + digest);
  const std::string instance = MakeDicomUID("instance " + digest);
  this->Root().Text(DCM_SeriesInstanceUID, series).Text(DCM_SOPInstanceUID, instance);
  if (syntax == EXS_RLELossless)
  {
    DcmRLEEncoderRegistration::registerCodecs();
    const OFCondition condition = m_File.getDataset()->chooseRepresentation(syntax, nullptr);
    if (condition.bad())
    {
      throw OutputError("the pixels of \"" + path + "\" cannot be compressed: " + condition.text());
    }
  }
  SaveFile(m_File, path, syntax);
  return { m_SopClassUID, instance, series };
}

void
PutReferenceToSlice(DicomItem item, const DicomSlice & slice)
{
  item.Text(DCM_ReferencedSOPClassUID, slice.sopClassUID).Text(DCM_ReferencedSOPInstanceUID, slice.sopInstanceUID);
  if (slice.isMultiFrame)
  {
    item.Text(DCM_ReferencedFrameNumber, std::to_string(slice.frame + 1));
  }
}

void
PutDerivation(DicomItem frame, const DicomSlice & slice, const DicomCode & processing)
{
  DicomItem derivation = frame.Add(DCM_DerivationImageSequence);
  derivation.Code(DCM_DerivationCodeSequence, processing);
  DicomItem image = derivation.Add(DCM_SourceImageSequence);
  PutReferenceToSlice(image, slice);
  image.Text(DCM_SpatialLocationsPreserved, "YES")
    .Code(DCM_PurposeOfReferenceCodeSequence, { "121322", "DCM", "Source image for image processing operation" });
}
} // namespace shapeton
