#ifndef shapetonDicomMeasurements_h
#define shapetonDicomMeasurements_h

#include "shapetonDicomReport.h"

#include <optional>

namespace shapeton
{
/** A number with its meaning and unit. \ingroup ShapetonDicomResults */
struct DicomMeasurement
{
  DicomCode name;
  /** A decimal number of at most 16 characters. */
  std::string digits;
  DicomCode   unit;
  /** Derivation from several values, such as the mean. */
  std::optional<DicomCode> derivation;
  /** Whether the observer measured it; otherwise the program is named as its algorithm. */
  bool isByObserver{ false };
  /** Whether it is shown as a line of this length (mm) along the rows of the slice that contains the group's center:
   * viewers such as OHIF treat such numbers as their own measurements. */
  bool isLine{ false };
};

/** A statement that is not a number: a code, or a text. \ingroup ShapetonDicomResults */
struct DicomEvaluation
{
  DicomCode                name;
  std::optional<DicomCode> code;
  std::string              text;
};

/** Measurements of one object: a segment, or a position without a segment. \ingroup ShapetonDicomResults */
struct DicomMeasurementGroup
{
  std::string trackingID;
  std::string trackingUID;
  DicomCode   finding;
  /** Finding sites; the first is anatomical. */
  std::vector<DicomCode> sites;
  /** Segment number in `segmentation`; 0 for none. */
  int           segment{ 0 };
  DicomInstance segmentation;
  /** LPS, mm. */
  std::array<double, 3>         center{ { 0.0, 0.0, 0.0 } };
  std::vector<DicomMeasurement> measurements;
  std::vector<DicomEvaluation>  evaluations;
  std::vector<std::string>      comments;
};

/** A measurement report (TID 1500). \ingroup ShapetonDicomResults */
struct DicomMeasurementReport
{
  /** Imaging procedure and imaged body part. */
  DicomCode                          procedure;
  DicomCode                          region;
  std::vector<DicomMeasurementGroup> groups;
  /** Evaluations of the whole examination. */
  std::vector<DicomEvaluation> evaluations;
  /** Name of the person who read the examination; if empty, the program is the observer. */
  std::string     observer;
  DicomCompletion completion{ DicomCompletion::Partial };
  /** Comments on the report. */
  std::vector<std::string> comments;
};

/** Writes a Comprehensive 3D SR of the template TID 1500: the observer, an image library of all slices, and a
 * measurement group per measured object (TID 1411, or TID 1501 for an object without a segment).
 *
 * The center of a group is written twice: first as a pixel position in the nearest slice, because viewers such as OHIF
 * need one, then as a point in space; a point outside the series has no pixel. The algorithm is named once per group,
 * or in comments if some numbers of the group are the observer's, because some viewers skip a number that names its own
 * algorithm.
 *
 * Output is deterministic. Throws OutputError.
 * \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomInstance
WriteDicomMeasurements(const DicomSource &            source,
                       const DicomMeasurementReport & report,
                       const DicomResultHeader &      header,
                       const std::string &            path);

/** The first items of a report: the language (English) and the observer, a person or, if `person` is empty, the
 * program. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT std::vector<DicomContent>
                            ContextOfReport(const DicomResultHeader & header, const std::string & person = {});
} // namespace shapeton

#endif
