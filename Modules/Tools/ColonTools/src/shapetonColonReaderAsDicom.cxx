#include "shapetonColonReportsAsDicom.h"

#include "shapetonColonTerms.h"
#include "shapetonNumberText.h"
#include "shapetonPlaceInWords.h"
#include "shapetonPrintable.h"

#include <cmath>

namespace shapeton
{
namespace
{
using namespace colonterms;

constexpr int digitsOfReading = 6; // significant

const DicomCode &
CodeOfMorphology(PolypMorphology shape)
{
  return shape == PolypMorphology::Flat ? flat : shape == PolypMorphology::Sessile ? sessile : pedunculated;
}

/** Size and distance; unknown values are omitted. Only the size may be the reader's. */
void
AddMeasurements(const ReaderLesion & lesion, DicomMeasurementGroup & group)
{
  const auto add = [&](const DicomCode & name, double value, bool isByReader) {
    if (std::isfinite(value))
    {
      group.measurements.push_back({ name, NumberText(value, digitsOfReading), mm, {}, isByReader });
    }
  };
  add(polypSize, lesion.Size(), lesion.IsSizeByReader());
  add(distanceFromAnus, lesion.arcLength, false);
}

void
AddMorphology(const ReaderLesion & lesion, DicomMeasurementGroup & group)
{
  if (lesion.Morphology() == PolypMorphology::Unknown)
  {
    return;
  }
  group.evaluations.push_back({ morphology, CodeOfMorphology(lesion.Morphology()), {} });
  if (!lesion.IsMorphologyByReader())
  {
    group.comments.emplace_back("morphology measured by the program");
  }
}

/** "candidate 1", "finding F1". */
std::string
NameOfLesion(const ReaderLesion & lesion)
{
  return (lesion.candidate ? "candidate " : "finding ") + lesion.id;
}

DicomMeasurementGroup
GroupOf(const ReaderLesion & lesion, const ColonSegmentsAsDicom & segments)
{
  DicomMeasurementGroup group;
  group.trackingID = NameOfLesion(lesion);
  group.trackingUID = lesion.candidate ? segments.TrackingUIDOfCandidate(*lesion.candidate)
                                       : segments.TrackingUIDAt(group.trackingID, lesion.place);
  group.finding = polyp;
  group.sites = { CodeOfSegment(lesion.segment) };
  const ColonSegmentsAsDicom::Place place = segments.PlaceOf(group.trackingUID);
  group.segment = place.number;
  group.segmentation = place.instance;
  group.center = { lesion.place[0], lesion.place[1], lesion.place[2] };
  AddMeasurements(lesion, group);
  AddMorphology(lesion, group);
  group.comments.emplace_back(lesion.candidate ? "a candidate of the program, accepted by the reader"
                                               : "found by the reader");
  if (!lesion.sameAs.empty())
  {
    group.comments.push_back("the same polyp as candidate " + lesion.sameAs + " of the first series");
  }
  if (const std::string note = Printable(lesion.statement.note); !note.empty())
  {
    group.comments.push_back("note of the reader: " + note);
  }
  return group;
}

DicomEvaluation
CategoryOf(const DicomCode & name, const std::string & category)
{
  return category.empty() ? DicomEvaluation{ name, {}, "no category entered" }
                          : DicomEvaluation{ name, CodeOfCategory(category), {} };
}

/** Counts, the reasons why the report is preliminary, unsure lesions, and the polyps of the other series. */
std::vector<std::string>
CommentsOn(const ColonReading & reading, std::size_t position, const std::string & whyPreliminary)
{
  std::vector<std::string> comments{ DicomResearchNote,
                                     "categories: C-RADS 2023, as entered by the reader",
                                     "polyps accepted in the examination: " + SizesOfAccepted(reading.lesions) };
  for (const ReaderLesion & lesion : LesionsWith(reading.lesions, ReaderVerdict::Polyp))
  {
    if (lesion.position != position)
    {
      comments.push_back("not in this report: " + NameOfLesion(lesion) +
                         ", which the reader accepted in the other series");
    }
  }
  for (const ReaderLesion & lesion : LesionsWith(reading.lesions, ReaderVerdict::Unsure))
  {
    comments.push_back("the reader is unsure about " + NameOfLesion(lesion));
  }
  for (const ReaderFinding & finding : reading.verdicts.extracolonic)
  {
    if (finding.position == position)
    {
      const std::string note = Printable(finding.statement.note);
      comments.push_back("extracolonic finding " + finding.id + " at " + PlaceInWords(finding.place) + " (LPS)" +
                         (note.empty() ? "" : ": " + note));
    }
  }
  if (!whyPreliminary.empty())
  {
    comments.push_back("preliminary: " + whyPreliminary);
  }
  if (const std::string note = Printable(reading.verdicts.assessment.note); !note.empty())
  {
    comments.push_back("note of the reader: " + note);
  }
  return comments;
}
} // namespace

DicomMeasurementReport
MeasurementsOfReader(const ColonReading & reading, std::size_t position, const ColonSegmentsAsDicom & segments)
{
  const ReaderAssessment & assessment = reading.verdicts.assessment;
  const std::string        why = WhyPreliminary(assessment, reading.lesions);
  DicomMeasurementReport   report;
  report.procedure = ct;
  report.region = colon;
  report.observer = reading.observer;
  report.completion = why.empty() ? DicomCompletion::Complete : DicomCompletion::Partial;
  report.evaluations = { CategoryOf(colonAssessment, assessment.colonic),
                         CategoryOf(extracolonicAssessment, assessment.extracolonic) };
  report.comments = CommentsOn(reading, position, why);
  for (const ReaderLesion & lesion : LesionsWith(reading.lesions, ReaderVerdict::Polyp))
  {
    if (lesion.position == position)
    {
      report.groups.push_back(GroupOf(lesion, segments));
    }
  }
  return report;
}
} // namespace shapeton
