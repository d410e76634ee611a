#include "shapetonColonFlattening.h"

#include "shapetonExceptions.h"
#include "shapetonJson.h"

#include <cmath>
#include <cstdio>

namespace shapeton
{
namespace
{
/** Rounds to 9 significant digits. */
Json
Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", value);
  return std::isfinite(value) ? Json::parse(text) : Json(nullptr);
}

Json
QuantilesToJson(const FlatDistortion & distortion, const std::vector<char> & isCap)
{
  const DistortionQuantiles quantiles = QuantilesOfDilatation(distortion, isCap);
  Json                      json;
  json["median"] = Number(quantiles.median);
  json["p95"] = Number(quantiles.p95);
  json["p99"] = Number(quantiles.p99);
  return json;
}

Json
QualityToJson(const TriangleQuality & quality)
{
  Json json;
  json["mean"] = Number(quality.mean);
  json["shareBelowThreshold"] = Number(quality.shareBelowThreshold);
  json["histogram"] = quality.histogram;
  return json;
}

Json
HandleToJson(const SurfaceHandle & handle)
{
  Json json;
  json["genus"] = handle.genus;
  json["place"] = { Number(handle.place.x()), Number(handle.place.y()), Number(handle.place.z()) };
  json["flatPlace"] = { Number(handle.flatPlace.x()), Number(handle.flatPlace.y()) };
  json["radius"] = Number(handle.radius);
  return json;
}

Json
CapToJson(const PouchCap & cap)
{
  Json json;
  json["neck"] = Number(cap.neck);
  json["area"] = Number(cap.area);
  json["place"] = { Number(cap.place.x()), Number(cap.place.y()), Number(cap.place.z()) };
  return json;
}

CurveSet
HandlesAsPoints(const std::vector<SurfaceHandle> & handles)
{
  const auto   number = static_cast<Eigen::Index>(handles.size());
  CurveSet     points;
  SurfaceArray genus{ "genus", SurfaceArray::ValueMatrix(number, 1), true };
  SurfaceArray uv{ "uv", SurfaceArray::ValueMatrix(number, 2), false };
  SurfaceArray radius{ "radius", SurfaceArray::ValueMatrix(number, 1), false };
  points.V.resize(number, 3);
  for (Eigen::Index i = 0; i < number; ++i)
  {
    const SurfaceHandle & handle = handles[i];
    points.V.row(i) = handle.place.transpose();
    points.curves.push_back({ static_cast<int>(i) });
    genus.values(i, 0) = handle.genus;
    uv.values.row(i) = handle.flatPlace.transpose();
    radius.values(i, 0) = Number(handle.radius);
  }
  points.pointArrays = { genus, uv, radius };
  return points;
}
} // namespace

Json
ColonFlatteningToJson(const ColonFlattening & flattening)
{
  Json json;
  json["faces"] = flattening.surface.NumberOfFaces();
  json["genusBefore"] = flattening.genusBefore;
  json["genusAfter"] = flattening.genusAfter;
  json["metric"] = WordOf(&ColonFlatteningOptions::metric, flattening.metric);
  json["time"] = Number(flattening.time);
  json["eigenpairs"] = flattening.eigenpairs > 0 ? Json(flattening.eigenpairs) : Json(nullptr);
  json["drownedEdges"] = flattening.drownedEdges;
  json["modulusU"] = Number(flattening.map.modulusU);
  json["modulusV"] = Number(flattening.map.modulusV);
  json["modulusGap"] = Number(flattening.map.Gap());
  json["circumference"] = Number(flattening.map.circumference);
  json["length"] = Number(flattening.map.length);
  json["flips"] = flattening.distortion.flips;
  json["flipsAwayFromHandles"] = flattening.flipsAwayFromHandles;
  json["solves"] = flattening.solves;
  json["ears"] = flattening.ears;
  json["caps"] = Json::array();
  for (const PouchCap & cap : flattening.caps)
  {
    json["caps"].push_back(CapToJson(cap));
  }
  json["cutOffAreaFraction"] = Number(flattening.cutOffAreaFraction);
  const std::vector<char> isCap = FacesOfCaps(flattening.surface);
  json["dilatation"] = QuantilesToJson(flattening.distortion, isCap);
  json["dilatationInSpace"] = QuantilesToJson(flattening.distortionInSpace, isCap);
  json["triangleQuality"] = QualityToJson(flattening.quality);
  json["triangleQualityInSpace"] = QualityToJson(flattening.qualityInSpace);
  json["handles"] = Json::array();
  for (const SurfaceHandle & handle : flattening.handles.handles)
  {
    json["handles"].push_back(HandleToJson(handle));
  }
  json["falseAlarms"] = flattening.handles.falseAlarms;
  json["rectumFrom"] = flattening.rectumFrom;
  json["narrowestRadius"] = flattening.narrowestRadius > 0.0 ? Number(flattening.narrowestRadius) : Json(nullptr);
  return json;
}

void
WriteHandles(const std::vector<SurfaceHandle> &                       handles,
             const std::vector<std::pair<std::string, std::string>> & facts,
             const std::string &                                      path)
{
  CurveSet points = HandlesAsPoints(handles);
  points.facts = facts;
  WriteCurves(points, path);
}

std::vector<Eigen::Vector3d>
OnlyCurve(const CurveSet & curves, const std::string & what)
{
  if (curves.curves.size() != 1 || curves.curves.front().size() < 2)
  {
    throw InputError(what + " has " + std::to_string(curves.curves.size()) +
                     " curves or a single point; use a file with one curve");
  }
  std::vector<Eigen::Vector3d> points;
  for (const int v : curves.curves.front())
  {
    points.emplace_back(curves.V.row(v).transpose());
  }
  return points;
}
} // namespace shapeton
