#include "shapetonSlicerMarkups.h"

#include "shapetonJson.h"
#include "shapetonExceptions.h"

#include <optional>

namespace shapeton
{
namespace
{
[[noreturn]] void
Refuse(const std::string & path, const std::string & fault, const std::string & advice)
{
  throw InputError("\"" + path + "\" " + fault + "; " + advice);
}

/** The string value of a key, "" if it is missing. Throws Json::type_error if it is not a string. */
std::string
TextOf(const Json & object, const char * key)
{
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? std::string() : found->get<std::string>();
}

std::optional<Markup::Kind>
KindOf(const std::string & type)
{
  if (type == "Fiducial" || type == "Line" || type == "Angle")
  {
    return Markup::Kind::Points;
  }
  if (type == "Curve")
  {
    return Markup::Kind::Curve;
  }
  if (type == "ClosedCurve")
  {
    return Markup::Kind::ClosedCurve;
  }
  return std::nullopt;
}

/** Factors that convert the coordinates of a markup to LPS in mm. */
Eigen::Vector3d
FactorOf(const Json & markup, const std::string & path)
{
  const std::string system = markup.contains("coordinateSystem") ? TextOf(markup, "coordinateSystem") : "LPS";
  std::string       unit = "mm";
  if (const auto units = markup.find("coordinateUnits"); units != markup.end())
  {
    unit = units->is_array() ? units->at(0).get<std::string>() : units->get<std::string>();
  }
  if (system != "LPS" && system != "RAS")
  {
    Refuse(path, "has coordinates in \"" + system + "\"", "save them as LPS or RAS");
  }
  if (unit != "mm" && unit != "um")
  {
    Refuse(path, "has coordinates in \"" + unit + "\"", "save them in mm");
  }
  const double scale = unit == "um" ? 1e-3 : 1.0;
  const double sign = system == "RAS" ? -scale : scale;
  return { sign, sign, scale };
}

bool
IsPlaced(const Json & point)
{
  const std::string status = TextOf(point, "positionStatus");
  return status.empty() || status == "defined";
}

void
AddPoint(Markup & markup, const Json & point, const Eigen::Vector3d & factor, const std::string & path)
{
  const Json & position = point.at("position");
  if (!position.is_array() || position.size() != 3)
  {
    Refuse(path, "has a control point whose position is not three numbers", "correct it");
  }
  const Eigen::Vector3d p(position[0].get<double>(), position[1].get<double>(), position[2].get<double>());
  markup.points.push_back(p.cwiseProduct(factor));
  markup.labels.push_back(TextOf(point, "label"));
  markup.descriptions.push_back(TextOf(point, "description"));
}

std::optional<Markup>
MarkupOf(const Json & json, const std::string & path)
{
  const auto kind = KindOf(json.at("type").get<std::string>());
  if (!kind)
  {
    return std::nullopt;
  }
  Markup markup;
  markup.kind = *kind;
  markup.name = TextOf(json, "name");
  const Eigen::Vector3d factor = FactorOf(json, path);
  const auto            points = json.find("controlPoints");
  for (const Json & point : points == json.end() ? Json::array() : *points)
  {
    if (IsPlaced(point))
    {
      AddPoint(markup, point, factor, path);
    }
  }
  if (const auto display = json.find("display"); display != json.end() && display->contains("selectedColor"))
  {
    markup.color = display->at("selectedColor").get<std::array<double, 3>>();
  }
  return markup;
}

std::vector<Markup>
MarkupsOf(const Json & document, const std::string & path)
{
  const bool isObject = document.is_object() && document.contains("@schema") && document.contains("markups");
  if (!isObject || document["@schema"].get<std::string>().find("markups-schema-v1.") == std::string::npos)
  {
    Refuse(path, "does not contain markups of 3D Slicer, schema version 1", "save the points in Slicer as .mrk.json");
  }
  std::vector<Markup> markups;
  std::size_t         points = 0;
  for (const Json & json : document["markups"])
  {
    if (auto markup = MarkupOf(json, path))
    {
      points += markup->points.size();
      markups.push_back(std::move(*markup));
    }
  }
  if (points == 0)
  {
    Refuse(path, "contains no placed points", "place points in Slicer and save them");
  }
  return markups;
}
} // namespace

std::vector<Markup>
ReadMarkups(const std::string & path)
{
  const Json document = ReadJson(path);
  try
  {
    return MarkupsOf(document, path);
  }
  catch (const Json::exception & error)
  {
    Refuse(path, std::string("violates the schema of 3D Slicer's markups (") + error.what() + ")", "correct it");
  }
}
} // namespace shapeton
