#ifndef shapetonDicomMeasurements_h
#define shapetonDicomMeasurements_h

#include "shapetonDicomReport.h"

#include <optional>

namespace shapeton
{
/** A number with what it means. \ingroup DicomResults */
struct DicomMeasurement
{
  DicomCode name;
  /** A decimal number of at most 16 characters. */
  std::string digits;
  DicomCode   unit;
  /** How it was derived from several ones, such as their mean. */
  std::optional<DicomCode> derivation;
};

/** What was measured of one thing: a segment, or a part of the patient that has none. \ingroup DicomResults */
struct DicomMeasurementGroup
{
  std::string              trackingID;
  std::string              trackingUID;
  DicomCode                finding;
  std::optional<DicomCode> site;
  /** In DicomMeasurementReport::segmentation; 0 for none. */
  int segment{ 0 };
  /** Its middle, LPS, mm. */
  std::optional<std::array<double, 3>> center;
  std::vector<DicomMeasurement>        measurements;
  std::vector<std::string>             comments;
};

/** A measurement report (TID 1500). \ingroup DicomResults */
struct DicomMeasurementReport
{
  /** By what the images were made, and the part of the body that they show. */
  DicomCode                          procedure;
  DicomCode                          region;
  DicomInstance                      segmentation;
  std::vector<DicomMeasurementGroup> groups;
  /** On all of it. */
  std::vector<std::string> comments;
};

/** Writes a Comprehensive 3D SR of the template TID 1500: an observer that is a program, an image library of all
 * slices, a group (TID 1411) for each thing that was measured. Equal input gives equal bytes. Throws OutputError.
 * \ingroup DicomResults */
DicomResults_EXPORT DicomInstance
WriteDicomMeasurements(const DicomSource &            source,
                       const DicomMeasurementReport & report,
                       const DicomResultHeader &      header,
                       const std::string &            path);

/** What a report says first: that its language is English, and who observed. \ingroup DicomResults */
DicomResults_EXPORT std::vector<DicomContent>
                    ContextOfReport(const DicomResultHeader & header);
} // namespace shapeton

#endif
