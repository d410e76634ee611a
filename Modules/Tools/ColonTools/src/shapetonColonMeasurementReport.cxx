#include "shapetonColonReportsAsDicom.h"

#include "shapetonColonTerms.h"
#include "shapetonNumberText.h"

#include <cmath>

namespace shapeton
{
namespace
{
using namespace colonterms;

/** Adds a measurement; unknown values are omitted. */
void
Add(DicomMeasurementGroup &  group,
    const DicomCode &        name,
    double                   value,
    const DicomCode &        unit,
    std::optional<DicomCode> derivation = {})
{
  if (std::isfinite(value))
  {
    group.measurements.push_back({ name, NumberText(value, 6), unit, std::move(derivation) });
  }
}

DicomMeasurementGroup
GroupOf(const DicomSegment & segment, const ColonSegmentsAsDicom::Place & place)
{
  DicomMeasurementGroup group;
  group.trackingID = segment.trackingID;
  group.trackingUID = segment.trackingUID;
  group.finding = segment.type;
  if (segment.region)
  {
    group.sites = { *segment.region };
  }
  group.segment = place.number;
  group.segmentation = place.instance;
  group.center = place.center;
  Add(group, volume, place.volume, ml);
  return group;
}

DicomMeasurementGroup
GroupOf(const PolypCandidate & candidate, const ColonSegmentsAsDicom & segments)
{
  DicomMeasurementGroup group;
  group.trackingID = "candidate " + std::to_string(candidate.number);
  group.trackingUID = segments.TrackingUIDOfCandidate(candidate);
  group.finding = lesion;
  group.sites = { CodeOfSegment(candidate.segment) };
  const ColonSegmentsAsDicom::Place head = segments.PlaceOf(group.trackingUID);
  group.segment = head.number;
  group.segmentation = head.instance;
  group.center = { candidate.position[0], candidate.position[1], candidate.position[2] };
  Add(group, diameter, candidate.diameter, mm, maximum);
  Add(group, height, candidate.height, mm);
  Add(group, distanceFromAnus, candidate.arcLength, mm);
  Add(group, attenuation, candidate.attenuation, hounsfield, median);
  Add(group, certainty, 100.0 * candidate.score, percent);
  if (group.segment > 0)
  {
    Add(group, volume, 1000.0 * head.volume, mm3);
  }
  group.comments.emplace_back(CandidateNote);
  if (!candidate.remark.empty())
  {
    group.comments.push_back(candidate.remark);
  }
  return group;
}

/** Computed over the centerline points in the segment; NaN if there are none. */
double
MeanDiameter(const CurveSet & centerline, const ColonSegmentExtent & segment)
{
  const Eigen::VectorXd arcLength = PointValues(centerline, "arcLength", "the centerline");
  const Eigen::VectorXd radius = PointValues(centerline, "radius", "the centerline");
  double                sum = 0.0;
  int                   number = 0;
  for (const int vertex : centerline.curves.front())
  {
    if (arcLength[vertex] >= segment.begin && arcLength[vertex] <= segment.end && std::isfinite(radius[vertex]))
    {
      sum += 2.0 * radius[vertex];
      ++number;
    }
  }
  return sum / number;
}

void
AddExtent(const DicomExamination & exam, DicomMeasurementGroup & group)
{
  for (const ColonSegmentExtent & segment : exam.segments)
  {
    if (segment.name == group.trackingID)
    {
      Add(group, pathLength, segment.end - segment.begin, mm);
      Add(group, diameter, MeanDiameter(exam.centerline, segment), mm, mean);
    }
  }
}
} // namespace

DicomMeasurementReport
CandidatesForOhif(const DicomExamination & exam, const ColonSegmentsAsDicom & segments)
{
  DicomMeasurementReport report;
  report.procedure = ct;
  report.region = colon;
  report.comments = { DicomResearchNote, CandidateNote };
  for (const PolypCandidate & candidate : exam.candidates)
  {
    const std::string     number = std::to_string(candidate.number);
    DicomMeasurementGroup group = GroupOf(candidate, segments);
    group.trackingID = "Cornerstone3DTools@^0.1.0:Length:candidate " + number;
    group.sites.push_back({ CandidateCodePrefix + number, "99SHAPETON", "candidate " + number });
    group.measurements = { { length, NumberText(candidate.diameter, 6), mm, {}, false, true } };
    group.comments = { "candidate " + number };
    report.groups.push_back(group);
  }
  return report;
}

DicomMeasurementReport
MeasurementsOfColon(const DicomExamination & exam, const ColonSegmentsAsDicom & segments)
{
  DicomMeasurementReport report;
  report.procedure = ct;
  report.region = colon;
  report.comments.emplace_back(DicomResearchNote);
  for (const PolypCandidate & candidate : exam.candidates)
  {
    report.groups.push_back(GroupOf(candidate, segments));
  }
  for (const DicomSegment & segment : segments.Segments())
  {
    const ColonSegmentsAsDicom::Place place = segments.PlaceOf(segment.trackingUID);
    if (place.number > 0 && !(segment.type == lesion))
    {
      report.groups.push_back(GroupOf(segment, place));
      AddExtent(exam, report.groups.back());
    }
  }
  report.comments.insert(report.comments.end(), exam.warnings.begin(), exam.warnings.end());
  report.comments.insert(report.comments.end(), exam.missing.begin(), exam.missing.end());
  return report;
}
} // namespace shapeton
