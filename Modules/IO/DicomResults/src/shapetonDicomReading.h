#ifndef shapetonDicomReading_h
#define shapetonDicomReading_h

#include "shapetonContainedProcess.h"
#include "shapetonDicomCode.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <functional>
#include <string>
#include <vector>

// Attributes of untrusted files. Except for ReadContained(), the functions run in a contained process.

namespace shapeton
{
/** One line of UTF-8, at most 256 bytes; empty if missing. */
std::string
TextOf(DcmItem & item, const DcmTagKey & tag);

/** The given number of finite values; throws std::runtime_error with the attribute and its value. */
std::vector<double>
NumbersOf(DcmItem & item, const DcmTagKey & tag, std::size_t count);

/** An integer from 0 to 65535; throws std::runtime_error as NumbersOf() does. */
int
WordOf(DcmItem & item, const DcmTagKey & tag);

/** Item `number` of a sequence, counted from 0; null if it does not exist. */
DcmItem *
ItemOf(DcmItem & item, const DcmTagKey & sequence, signed long number = 0);

/** The items of a sequence. */
std::vector<DcmItem *>
ItemsOf(DcmItem & item, const DcmTagKey & sequence);

/** Empty if missing. */
DicomCode
CodeOf(DcmItem & item, const DcmTagKey & sequence);

/** Loads a file of one of these classes, leaving long values on disk; throws std::runtime_error, for example for a
 * transfer syntax unknown to DCMTK. */
void
LoadDicomObject(DcmFileFormat & file, const std::string & path, const std::vector<std::string> & sopClassUIDs);

/** \name Services of this library in the contained process, and their names */
///@{
constexpr const char * DicomReportService = "DicomReport";
constexpr const char * DicomSegmentationService = "DicomSegmentation";
constexpr const char * DicomSegmentPixelService = "DicomSegmentPixels";
constexpr const char * DicomSourceService = "DicomSource";
ContainedService
MakeDicomReportService();
ContainedService
MakeDicomSegmentationService();
ContainedService
MakeDicomSegmentPixelService();
ContainedService
MakeDicomSourceService();
///@}

/** Calls a service for a file; the service may write up to `sharedBytes` bytes; then calls `take` with its response and
 * these bytes. A failure becomes an InputError with the file name. */
void
ReadContained(const std::string &                                                          path,
              const char *                                                                 service,
              std::size_t                                                                  sharedBytes,
              const std::function<void(const std::string & response, const char * data)> & take);

/** The service that answers ReadContained() by `parse`. */
ContainedService
  MakeDicomService(std::string (*parse)(const std::string & path, std::size_t sharedBytes, char * shared));
} // namespace shapeton

#endif
