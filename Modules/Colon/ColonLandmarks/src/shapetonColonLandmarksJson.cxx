#include "shapetonColonLandmarks.h"

#include "shapetonJson.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shapeton
{
namespace
{

template <typename TVector>
Json
Numbers(const TVector & values)
{
  Json list = Json::array();
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    list.push_back(RoundedJson(values[i]));
  }
  return list;
}

const SegmentBorder *
FindBorder(const ColonSegments & segments, int number)
{
  for (const SegmentBorder & border : segments.borders)
  {
    if (border.number == number)
    {
      return &border;
    }
  }
  return nullptr;
}

/** Position of the loop on the map: the mean u, and v at the first vertex. */
Json
UvOfLoop(const ColonLandmarks & landmarks, const SegmentBorder & border)
{
  Eigen::Vector2d uv(0.0, landmarks.tube->Uv(border.loop.vertices.front()).y());
  for (const int vertex : border.loop.vertices)
  {
    uv[0] += landmarks.tube->Uv(vertex).x() / static_cast<double>(border.loop.vertices.size());
  }
  return Numbers(uv);
}

void
AddPlace(const ColonLandmarks & landmarks, const SegmentBorder & border, Json & json)
{
  json["position"] = Numbers(border.point);
  json["arcLength"] = RoundedJson(border.arcLength);
  json["uv"] = UvOfLoop(landmarks, border);
  json["loopLength"] = RoundedJson(border.loop.length);
  json["confidence"] = RoundedJson(border.confidence);
  const ColonHindrance hindrance =
    landmarks.hindered ? HindranceAt(*landmarks.hindered, border.arcLength) : ColonHindrance::None;
  if (hindrance != ColonHindrance::None)
  {
    json["notAssessable"] = HindranceToJson(hindrance);
  }
}

/** Evidence for the descending-sigmoid flexure; the published rule has none. */
void
AddEvidence(const ColonFlexures & flexures, int number, Json & json)
{
  constexpr int junction = 2; // number of the descending-sigmoid flexure, from 1 at the rectum
  if (number == junction && flexures.rule == FlexureRule::Ordered)
  {
    json["decidedBy"] = flexures.isJunctionFromBones ? "bone" : "course";
  }
}

Json
FlexuresToJson(const ColonLandmarks & landmarks)
{
  Json list = Json::array();
  for (const ColonFlexure & flexure : landmarks.flexures.flexures)
  {
    const SegmentBorder * border = FindBorder(landmarks.segments, flexure.number);
    Json                  json;
    json["number"] = flexure.number;
    json["name"] = NameOfFlexure(flexure.number);
    json["found"] = border != nullptr;
    if (border != nullptr)
    {
      AddPlace(landmarks, *border, json);
      AddEvidence(landmarks.flexures, flexure.number, json);
    }
    else
    {
      json["reason"] = flexure.reason.empty() ? "no loop around the wall was found at the flexure" : flexure.reason;
    }
    list.push_back(json);
  }
  return list;
}

Json
PelvisToJson(const std::optional<Pelvis> & pelvis)
{
  Json json;
  json["found"] = pelvis.has_value();
  if (pelvis)
  {
    json["leftCrest"] = Numbers(pelvis->leftCrest);
    json["rightCrest"] = Numbers(pelvis->rightCrest);
    json["promontory"] = Numbers(pelvis->promontory);
  }
  else
  {
    json["reason"] = "no CT was given, or the pelvis is not in view";
  }
  return json;
}

Json
CecumToJson(const ColonLandmarks & landmarks)
{
  const SegmentBorder * border = FindBorder(landmarks.segments, NumberOfColonSegments - 1);
  Json                  json;
  json["found"] = border != nullptr;
  if (border != nullptr)
  {
    AddPlace(landmarks, *border, json);
  }
  const bool atValve = landmarks.segments.isCecumAtValve;
  json["source"] = atValve ? "ileocecalValve" : "estimated";
  json["reason"] = border == nullptr ? "the hepatic flexure is unknown or too close to the end"
                   : atValve         ? "at the ileocecal valve"
                                     : "6 cm from the end of the centerline, the length of a cecum; no valve is known";
  return json;
}

Json
ValveToJson(const ColonLandmarks & landmarks)
{
  Json json;
  json["found"] = landmarks.valve.has_value();
  if (landmarks.valve)
  {
    const IleocecalValve & valve = *landmarks.valve;
    json["position"] = Numbers(valve.position);
    json["arcLength"] = RoundedJson(valve.arcLength);
    json["uv"] = Numbers(landmarks.valveUv);
    json["length"] = RoundedJson(valve.length);
    json["width"] = RoundedJson(valve.width);
    json["confidence"] = RoundedJson(valve.confidence);
  }
  else
  {
    json["reason"] = "the segmentation found none; its quality.json says why";
  }
  return json;
}

double
AreaOfFace(const ColonWallTube & tube, int face)
{
  const Eigen::Vector3d a = tube.Points().row(tube.Faces()(face, 0));
  const Eigen::Vector3d b = tube.Points().row(tube.Faces()(face, 1));
  const Eigen::Vector3d c = tube.Points().row(tube.Faces()(face, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

/** Names of the segments that lack a known border. */
Json
SegmentsNotFound(const ColonLandmarks & landmarks)
{
  const std::vector<int> & found = landmarks.segments.segmentOfFace;
  Json                     list = Json::array();
  for (int segment = 1; segment <= NumberOfColonSegments; ++segment)
  {
    if (std::find(found.begin(), found.end(), segment) == found.end())
    {
      list.push_back(NameOfSegment(segment));
    }
  }
  return list;
}

Json
SegmentsToJson(const ColonLandmarks & landmarks)
{
  std::array<double, NumberOfColonSegments + 1> area{};
  for (std::size_t face = 0; face < landmarks.segments.segmentOfFace.size(); ++face)
  {
    area[landmarks.segments.segmentOfFace[face]] += AreaOfFace(*landmarks.tube, static_cast<int>(face));
  }
  Json list = Json::array();
  for (int segment = 0; segment <= NumberOfColonSegments; ++segment)
  {
    if (area[segment] == 0.0)
    {
      continue;
    }
    const SegmentBorder * begin = FindBorder(landmarks.segments, segment - 1);
    const SegmentBorder * end = FindBorder(landmarks.segments, segment);
    Json                  json;
    json["number"] = segment;
    json["name"] = NameOfSegment(segment);
    json["begin"] = begin != nullptr ? RoundedJson(begin->arcLength) : Json(nullptr);
    json["end"] = end != nullptr ? RoundedJson(end->arcLength) : Json(nullptr);
    json["area"] = RoundedJson(area[segment]);
    if (const auto assessability = AssessabilityOfSegment(landmarks, segment))
    {
      json.update(AssessabilityToJson(*assessability));
    }
    list.push_back(json);
  }
  return list;
}

Json
NamesToJson(const TaeniaNames & names)
{
  Json json{ { "found", names.AreKnown() } };
  if (!names.AreKnown())
  {
    json["reason"] = names.reason;
  }
  json["agreement"] = Json::array();
  for (const TaeniaNameEvidence & one : names.evidence)
  {
    json["agreement"].push_back(
      { { "segment", NameOfSegment(one.segment) },
        { "libera",
          Json::array(
            { RoundedJson(one.agreement[0]), RoundedJson(one.agreement[1]), RoundedJson(one.agreement[2]) }) } });
  }
  return json;
}

Json
TaeniaeToJson(const ColonTaeniae & taeniae, const TaeniaNames & names)
{
  Json json;
  json["rule"] = NameOf(taeniae.rule);
  json["found"] = static_cast<int>(taeniae.taeniae.size());
  if (!taeniae.reason.empty())
  {
    json["reason"] = taeniae.reason;
    return json;
  }
  json["kept"] = taeniae.kept;
  json["energy"] = { { "joint", RoundedJson(taeniae.jointEnergy) },
                     { taeniae.rule == TaeniaRule::Published ? "thirds" : "fuzzyCMeans",
                       RoundedJson(taeniae.fuzzyEnergy) } };
  json["meanDisagreement"] = RoundedJson(taeniae.meanDisagreement);
  json["disagreeingShare"] = RoundedJson(taeniae.disagreeingShare);
  json["taeniae"] = Json::array();
  for (std::size_t t = 0; t < taeniae.taeniae.size(); ++t)
  {
    const ColonTaenia & taenia = taeniae.taeniae[t];
    double              length = 0.0;
    double              confidence = 0.0;
    for (std::size_t i = 0; i < taenia.points.size(); ++i)
    {
      length += i > 0 ? (taenia.points[i] - taenia.points[i - 1]).norm() : 0.0;
      confidence += taenia.confidence[i] / static_cast<double>(taenia.points.size());
    }
    json["taeniae"].push_back({ { "taenia", t + 1 },
                                { "name", NameOf(names.names[t]) },
                                { "length", RoundedJson(length) },
                                { "meanConfidence", RoundedJson(confidence) } });
  }
  json["names"] = NamesToJson(names);
  json["markers"] = Json::array();
  for (const UsedMarker & marker : taeniae.markers)
  {
    json["markers"].push_back({ { "position", Numbers(marker.point) },
                                { "taenia", marker.taenia },
                                { "distanceFromWall", RoundedJson(marker.distanceFromWall) },
                                { "distanceOfTaenia", RoundedJson(marker.distanceOfTaenia) } });
  }
  return json;
}
} // namespace

Json
ColonLandmarksToJson(const ColonLandmarks & landmarks)
{
  Json json;
  json["flexureRule"] = NameOf(landmarks.flexures.rule);
  json["mirrored"] = landmarks.flexures.isMirrored;
  json["backwards"] = landmarks.flexures.isBackwards;
  json["flexures"] = FlexuresToJson(landmarks);
  json["pelvis"] = PelvisToJson(landmarks.pelvis);
  json["cecum"] = CecumToJson(landmarks);
  json["ileocecalValve"] = ValveToJson(landmarks);
  json["segments"] = SegmentsToJson(landmarks);
  json["segmentsNotFound"] = SegmentsNotFound(landmarks);
  if (landmarks.hindered)
  {
    json["notAssessable"] = StretchesToJson(*landmarks.hindered);
  }
  json["surfaceFolds"] = { { "number", landmarks.folds.number },
                           { "leastCurvature", RoundedJson(landmarks.folds.leastCurvature) },
                           { "area", RoundedJson(landmarks.folds.area) } };
  json["taeniae"] = TaeniaeToJson(landmarks.taeniae, landmarks.taeniaNames);
  return json;
}
} // namespace shapeton
