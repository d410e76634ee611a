#ifndef shapetonDicomReading_h
#define shapetonDicomReading_h

#include "shapetonDicomCode.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <functional>
#include <string>
#include <vector>

// Attributes of untrusted files: what follows runs in a contained process, but for ReadContained().

namespace shapeton
{
/** One line of UTF-8, at most 256 bytes; empty where there is none. */
std::string
TextOf(DcmItem & item, const DcmTagKey & tag);

/** So many finite numbers; throws std::runtime_error that names the attribute and its value. */
std::vector<double>
NumbersOf(DcmItem & item, const DcmTagKey & tag, std::size_t count);

/** A whole number from 0 to 65535; throws std::runtime_error as NumbersOf() does. */
int
WordOf(DcmItem & item, const DcmTagKey & tag);

/** Item number `number` of a sequence, from 0; null where there is none. */
DcmItem *
ItemOf(DcmItem & item, const DcmTagKey & sequence, signed long number = 0);

/** The items of a sequence. */
std::vector<DcmItem *>
ItemsOf(DcmItem & item, const DcmTagKey & sequence);

/** Empty where there is none. */
DicomCode
CodeOf(DcmItem & item, const DcmTagKey & sequence);

/** Loads a file of one of these classes, long values left on disk; throws std::runtime_error, also for a transfer
 * syntax that DCMTK does not know. */
void
LoadDicomObject(DcmFileFormat & file, const std::string & path, const std::vector<std::string> & sopClassUIDs);

/** Calls `service` on `request` in a contained process that may write `sharedBytes`, which `take` then gets with the
 * response. A failure becomes an InputError that names the file. */
void
ReadContained(const std::string &                                                          path,
              const std::string &                                                          request,
              std::size_t                                                                  sharedBytes,
              const std::function<std::string(const std::string &, char *)> &              service,
              const std::function<void(const std::string & response, const char * data)> & take);
} // namespace shapeton

#endif
