#include "shapetonColonLandmarkDocument.h"

#include "shapetonExceptions.h"
#include "shapetonJson.h"

#include <cmath>

namespace shapeton
{
namespace
{
[[noreturn]] void
RefuseDocument(const Json::exception & error)
{
  throw InputError(std::string("landmarks.json was not written by ColonLandmarks (") + error.what() +
                   "); remove it and run again");
}
} // namespace

std::vector<ColonSegmentExtent>
SegmentsOf(const Json & landmarks, double lengthOfCenterline)
{
  constexpr int                   cecum = 6; // label of the last segment
  const double                    unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<ColonSegmentExtent> segments;
  try
  {
    for (const Json & one : landmarks.at("segments"))
    {
      ColonSegmentExtent segment;
      segment.label = one.at("number").get<int>();
      segment.name = one.at("name").get<std::string>();
      segment.area = one.at("area").get<double>();
      segment.begin = segment.label == 1 ? 0.0 : one.at("begin").is_null() ? unknown : one["begin"].get<double>();
      segment.end = segment.label == cecum    ? lengthOfCenterline
                    : one.at("end").is_null() ? unknown
                                              : one["end"].get<double>();
      if (std::isfinite(segment.begin) && std::isfinite(segment.end))
      {
        segments.push_back(segment);
      }
    }
  }
  catch (const Json::exception & error)
  {
    RefuseDocument(error);
  }
  return segments;
}

std::array<ColonFlexurePlace, 4>
FlexuresOf(const Json & landmarks)
{
  std::array<ColonFlexurePlace, 4> flexures;
  try
  {
    for (const Json & one : landmarks.at("flexures"))
    {
      const int number = one.at("number").get<int>();
      if (one.at("found").get<bool>() && number >= 1 && number <= 4)
      {
        flexures[number - 1] = { one.at("arcLength").get<double>(), one.at("confidence").get<double>() };
      }
    }
  }
  catch (const Json::exception & error)
  {
    RefuseDocument(error);
  }
  return flexures;
}

const ColonSegmentExtent *
FindSegment(const std::vector<ColonSegmentExtent> & segments, double arcLength)
{
  for (const ColonSegmentExtent & segment : segments)
  {
    const bool isBeforeEnd = arcLength < segment.end || (arcLength == segment.end && &segment == &segments.back());
    if (arcLength >= segment.begin && isBeforeEnd)
    {
      return &segment;
    }
  }
  return nullptr;
}
} // namespace shapeton
