#include "shapetonDicomSource.h"

#include "shapetonDicomAttributes.h"
#include "shapetonDicomReading.h"
#include "shapetonExceptions.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dcostrmb.h"
#include "dcmtk/dcmdata/dctk.h"

#include <stdexcept>

namespace shapeton
{
namespace
{
/** Attributes copied to results. */
const DcmTagKey taken[] = { DCM_SpecificCharacterSet,
                            DCM_TimezoneOffsetFromUTC,
                            DCM_PatientName,
                            DCM_PatientID,
                            DCM_IssuerOfPatientID,
                            DCM_PatientBirthDate,
                            DCM_PatientSex,
                            DCM_PatientAge,
                            DCM_PatientIdentityRemoved,
                            DCM_DeidentificationMethod,
                            DCM_DeidentificationMethodCodeSequence,
                            DCM_LongitudinalTemporalInformationModified,
                            DCM_ClinicalTrialSponsorName,
                            DCM_ClinicalTrialProtocolID,
                            DCM_ClinicalTrialProtocolName,
                            DCM_ClinicalTrialSiteID,
                            DCM_ClinicalTrialSiteName,
                            DCM_ClinicalTrialSubjectID,
                            DCM_StudyInstanceUID,
                            DCM_StudyDate,
                            DCM_StudyTime,
                            DCM_StudyID,
                            DCM_StudyDescription,
                            DCM_AccessionNumber,
                            DCM_ReferringPhysicianName,
                            DCM_AcquisitionDate,
                            DCM_AcquisitionTime,
                            DCM_ContentDate,
                            DCM_ContentTime,
                            DCM_LossyImageCompressionRatio,
                            DCM_LossyImageCompressionMethod,
                            DCM_SeriesDate,
                            DCM_SeriesTime };

void
Require(const OFCondition & condition)
{
  if (condition.bad())
  {
    throw std::runtime_error(std::string("its header cannot be read: ") + condition.text());
  }
}

std::string
BytesOf(DcmDataset & dataset)
{
  std::string           bytes(1 << 20, '\0'); // for headers without sequences of arbitrary length
  DcmOutputBufferStream stream(&bytes[0], static_cast<offile_off_t>(bytes.size()));
  dataset.transferInit();
  const OFCondition condition = dataset.write(stream, EXS_LittleEndianExplicit, EET_ExplicitLength, nullptr);
  dataset.transferEnd();
  Require(condition);
  void *       buffer = nullptr;
  offile_off_t length = 0;
  stream.flushBuffer(buffer, length);
  bytes.resize(static_cast<std::size_t>(length));
  return bytes;
}

/** Runs in the contained process. */
std::string
HeaderOf(const std::string & path)
{
  DcmFileFormat file;
  Require(
    file.loadFileUntilTag(path.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect, DCM_PixelData));
  DcmDataset header;
  for (const DcmTagKey & tag : taken)
  {
    DcmElement * element = nullptr;
    if (file.getDataset()->findAndGetElement(tag, element, OFFalse, OFTrue).good() && element)
    {
      Require(header.insert(element, OFTrue));
    }
  }
  return BytesOf(header);
}

std::string
ReadHeader(const std::string & path)
{
  constexpr ContainedProcess::Limits limits{ std::size_t{ 512 } << 20, 15, 600 };
  ContainedProcess                   process(DicomSourceService, 0, limits);
  try
  {
    return process.Call(path);
  }
  catch (const ContainedProcess::Failure & failure)
  {
    throw InputError(path + ": " + failure.what() + "; copy the file from its source again");
  }
}

void
RequireReferable(const DicomSeries & series, bool forPoints)
{
  for (const DicomSlice & slice : series.slices)
  {
    if (slice.sopClassUID.empty() || slice.sopInstanceUID.empty())
    {
      throw InputError(slice.file +
                       ": has no SOP Class or Instance UID, so results cannot reference it; copy the series from its "
                       "source again");
    }
  }
  const bool hasIdentity = !series.uid.empty() && !series.studyUID.empty() && !series.frameOfReferenceUID.empty();
  if (!hasIdentity && !forPoints)
  {
    throw InputError(
      series.slices.front().file +
      ": has no Series or Study Instance UID or no frame of reference, which results require; copy the series "
      "from its source again");
  }
}
} // namespace

ContainedService
MakeDicomSourceService()
{
  PrepareDicomParsing();
  return [](const std::string & path, char *) { return HeaderOf(path); };
}

DicomSource
ReadDicomSource(const std::string & path, const DicomSourceOptions & sourceOptions)
{
  VolumeReadOptions options;
  options.seriesUID = sourceOptions.seriesUID;
  options.deshear = sourceOptions.deshear || sourceOptions.forPoints;
  options.resampleGaps = options.dropDuplicates = options.allowSingleSlice = sourceOptions.forPoints;
  options.advice = sourceOptions.offersDeshear ? DicomRepairAdvice::Deshear : DicomRepairAdvice::None;
  const DicomScan scan = ScanDicom(path);
  DicomSource     source;
  source.series = SelectDicomSeries(scan, options);
  RequireReferable(source.series, sourceOptions.forPoints);
  source.grid = GridOfDicomSeries(source.series, sourceOptions.deshear);
  source.header = ReadHeader(source.series.slices.front().file);
  return source;
}
} // namespace shapeton
