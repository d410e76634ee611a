#include "shapetonColonReportsAsDicom.h"

#include "shapetonColonTerms.h"
#include "shapetonNumberText.h"
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

DicomMeasurementGroup
GroupOf(const ReaderLesion & lesion, const ColonSegmentsAsDicom & segments)
{
  DicomMeasurementGroup group;
  group.trackingID = (lesion.candidate ? "candidate " : "finding ") + lesion.id;
  group.trackingUID = lesion.candidate ? segments.TrackingUIDOfCandidate(*lesion.candidate)
                                       : segments.TrackingUIDAt(group.trackingID, lesion.place);
  group.finding = polyp;
  group.site = CodeOfSegment(lesion.segment);
  group.segment = segments.NumberOf(group.trackingUID);
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
  return { name, {}, category.empty() ? "no category entered" : category + " (C-RADS), as entered by the reader" };
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
  report.segmentation = segments.Instance();
  report.observer = reading.observer;
  report.completion = why.empty() ? DicomCompletion::Complete : DicomCompletion::Partial;
  for (const ReaderLesion & lesion : LesionsWith(reading.lesions, ReaderVerdict::Polyp))
  {
    if (lesion.position == position)
    {
      report.groups.push_back(GroupOf(lesion, segments));
    }
  }
  report.evaluations = { CategoryOf(colonAssessment, assessment.colonic),
                         CategoryOf(extracolonicAssessment, assessment.extracolonic) };
  report.comments.emplace_back(DicomResearchNote);
  report.comments.push_back("polyps accepted in the examination: " + SizesOfAccepted(reading.lesions));
  if (!why.empty())
  {
    report.comments.push_back("preliminary: " + why);
  }
  for (const ReaderLesion & lesion : LesionsWith(reading.lesions, ReaderVerdict::Unsure))
  {
    report.comments.push_back("the reader is unsure about candidate " + lesion.id);
  }
  if (const std::string note = Printable(assessment.note); !note.empty())
  {
    report.comments.push_back("note of the reader: " + note);
  }
  return report;
}
} // namespace shapeton
