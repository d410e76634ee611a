#include "shapetonSlicerMarkups.h"

#include "shapetonJson.h"
#include "shapetonExceptions.h"

#include <stdexcept>

namespace shapeton
{
namespace
{
// The extension that Slicer itself writes; its readers check only the end of it.
const char * const schema = "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
                            "Schema/markups-schema-v1.0.3.json#";

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

const char *
TypeOf(Markup::Kind kind)
{
  return kind == Markup::Kind::Points ? "Fiducial" : kind == Markup::Kind::Curve ? "Curve" : "ClosedCurve";
}

void
Check(const Markup & markup)
{
  const auto isOneForEach = [&](const std::vector<std::string> & texts) {
    return texts.empty() || texts.size() == markup.points.size();
  };
  if (!isOneForEach(markup.labels) || !isOneForEach(markup.descriptions))
  {
    throw std::invalid_argument("the markup " + markup.name + " must have one label and description for each point");
  }
  for (const Eigen::Vector3d & point : markup.points)
  {
    if (!point.allFinite())
    {
      throw std::invalid_argument("a point of the markup " + markup.name + " is not finite");
    }
  }
  for (const double channel : markup.color)
  {
    if (!(channel >= 0.0 && channel <= 1.0))
    {
      throw std::invalid_argument("the color of the markup " + markup.name + " is not in 0 to 1");
    }
  }
}

Json
ControlPointOf(const Markup & markup, std::size_t i)
{
  const std::string     number = std::to_string(i + 1);
  const Eigen::Vector3d p = markup.points[i];
  Json                  point;
  point["id"] = number;
  point["label"] = markup.labels.empty() ? markup.name + '-' + number : markup.labels[i];
  point["description"] = markup.descriptions.empty() ? "" : markup.descriptions[i];
  point["associatedNodeID"] = "";
  point["position"] = { p.x(), p.y(), p.z() };
  point["orientation"] = { -1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0 };
  point["selected"] = true;
  point["locked"] = false;
  point["visibility"] = true;
  point["positionStatus"] = "defined";
  return point;
}

/** Selected points are shown in the selected color, and initially all points are selected. */
Json
DisplayOf(const Markup & markup)
{
  const bool isCurve = markup.kind != Markup::Kind::Points;
  Json       display;
  display["visibility"] = true;
  display["opacity"] = 1.0;
  display["color"] = markup.color;
  display["selectedColor"] = markup.color;
  display["propertiesLabelVisibility"] = isCurve;
  display["pointLabelsVisibility"] = !isCurve;
  constexpr double textScale = 2.5; // percent of the view
  display["textScale"] = textScale;
  display["glyphType"] = "Sphere3D";
  display["glyphSize"] = isCurve ? 1.0 : 4.0; // mm
  display["useGlyphScale"] = false;
  display["lineThickness"] = 0.5;
  return display;
}

Json
JsonOf(const Markup & markup)
{
  Json json;
  json["type"] = TypeOf(markup.kind);
  json["name"] = markup.name;
  json["coordinateSystem"] = "LPS";
  json["coordinateUnits"] = "mm";
  json["locked"] = false;
  json["fixedNumberOfControlPoints"] = false;
  json["labelFormat"] = "%N-%d";
  json["controlPoints"] = Json::array();
  for (std::size_t i = 0; i < markup.points.size(); ++i)
  {
    json["controlPoints"].push_back(ControlPointOf(markup, i));
  }
  json["display"] = DisplayOf(markup);
  return json;
}
} // namespace

void
WriteMarkups(const std::vector<Markup> & markups, const std::string & path)
{
  RequireParameter(EndsWith(path, ".mrk.json"),
                   "\"" + path + "\" is not the name of a markups file; use the extension .mrk.json");
  Json document;
  document["@schema"] = schema;
  document["markups"] = Json::array();
  for (const Markup & markup : markups)
  {
    Check(markup);
    document["markups"].push_back(JsonOf(markup));
  }
  WriteJson(document, path);
}

Markup
MarkupOfCurve(const CurveSet & curves, std::size_t curve, Markup::Kind kind, double spacing)
{
  if (curve >= curves.curves.size() || !(spacing > 0.0))
  {
    throw std::invalid_argument("a markup requires an existing curve and a positive spacing");
  }
  const std::vector<int> & vertices = curves.curves[curve];
  const auto               pointOf = [&](std::size_t i) -> Eigen::Vector3d { return curves.V.row(vertices[i]); };
  const bool               isClosed = kind == Markup::Kind::ClosedCurve;
  std::size_t              count = vertices.size();
  if (isClosed && count > 1 && pointOf(0) == pointOf(count - 1))
  {
    --count;
  }
  Markup markup;
  markup.kind = kind;
  double length = 0.0; // since the last control point
  for (std::size_t i = 0; i < count; ++i)
  {
    // A vertex is kept if the next one is farther from the last control point than the spacing.
    const bool   isLast = i + 1 == count;
    const double step = isLast ? 0.0 : (pointOf(i + 1) - pointOf(i)).norm();
    if (kind == Markup::Kind::Points || i == 0 || (isLast && !isClosed) || length + step > spacing ||
        (isLast && length + (pointOf(0) - pointOf(i)).norm() > spacing))
    {
      markup.points.push_back(pointOf(i));
      length = 0.0;
    }
    length += step;
  }
  return markup;
}
} // namespace shapeton
