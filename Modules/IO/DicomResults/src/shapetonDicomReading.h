#ifndef shapetonDicomReading_h
#define shapetonDicomReading_h

#include "shapetonDicomCode.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <functional>
#include <string>
#include <vector>

// Attributes of untrusted files. Except for ReadContained(), these functions run in a contained process.

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

/** Item number `number` of a sequence, from 0; null if it does not exist. */
DcmItem *
ItemOf(DcmItem & item, const DcmTagKey & sequence, signed long number = 0);

/** The items of a sequence. */
std::vector<DcmItem *>
ItemsOf(DcmItem & item, const DcmTagKey & sequence);

/** Empty if missing. */
DicomCode
CodeOf(DcmItem & item, const DcmTagKey & sequence);

/** Loads a file of one of these classes, leaving long values on disk; throws std::runtime_error, also for a transfer
 * syntax unknown to DCMTK. */
void
LoadDicomObject(DcmFileFormat & file, const std::string & path, const std::vector<std::string> & sopClassUIDs);

/** Calls `service` on `request` in a contained process that may write `sharedBytes`; then calls `take` with these bytes
 * and the response. A failure becomes an InputError with the file name. */
void
ReadContained(const std::string &                                                          path,
              const std::string &                                                          request,
              std::size_t                                                                  sharedBytes,
              const std::function<std::string(const std::string &, char *)> &              service,
              const std::function<void(const std::string & response, const char * data)> & take);
} // namespace shapeton

#endif
