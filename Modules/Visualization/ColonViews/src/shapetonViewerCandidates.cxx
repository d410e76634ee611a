#include "shapetonViewerCandidates.h"

#include "shapetonColonSegments.h"
#include "shapetonPolypMorphology.h"
#include "shapetonPolypSearch.h"

#include <cmath>

namespace shapeton
{
namespace
{
Json
NumberOrNull(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json
ForViewer(const PolypCandidate & one)
{
  return { { "candidate", std::to_string(one.number) },
           { "score", one.score },
           { "x", one.position.x() },
           { "y", one.position.y() },
           { "z", one.position.z() },
           { "u", NumberOrNull(one.uv.x()) },
           { "v", NumberOrNull(one.uv.y()) },
           { "segment", NameOfSegment(one.segment) },
           { "arcLength", NumberOrNull(one.arcLength) },
           { "diameter", one.diameter },
           { "height", one.height },
           { "plane", one.plane },
           { "morphology", MorphologyInWords(one) },
           { "meanAttenuation", NumberOrNull(one.meanAttenuation) },
           { "uncleansedAttenuation", NumberOrNull(one.uncleansedAttenuation) },
           { "tissue", NameOf(one.tissue) },
           { "remark", one.remark },
           { "recognizedAs", RecognizedAs(one) },
           { "otherCandidate", one.other && one.other->isSeen ? std::to_string(one.other->candidate) : "" } };
}
} // namespace

Json
CandidatesForViewer(const std::string & path)
{
  Json candidates = Json::array();
  for (const PolypCandidate & one : ReadPolypCandidates(path))
  {
    candidates.push_back(ForViewer(one));
  }
  return candidates;
}
} // namespace shapeton
