#include "shapetonShapeSceneData.h"

#include "shapetonCsvTable.h"
#include "shapetonJson.h"
#include "itkMath.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shapeton
{
namespace
{
constexpr double      largestLength = 1e6;        // mm; chosen
constexpr double      lowestIntensity = -1024.0;  // HU, see PhantomImageSource
constexpr double      highestIntensity = 31743.0; // HU
constexpr std::size_t mostObjects = 10000;        // chosen; bounds the time
constexpr std::size_t mostPoints = 10000;         // of an object; chosen

// A value of the document with its path for messages.
class Node
{
public:
  Node(const Json & json, std::string path, const std::string & source)
    : m_Json(json), m_Path(std::move(path)), m_Source(source)
  {}

  [[noreturn]] void
  Fail(const std::string & what) const
  {
    throw InputError("the scene \"" + m_Source + "\": " + (m_Path.empty() ? "the document" : m_Path) + ' ' + what +
                     "; correct the scene");
  }

  bool
  Has(const char * key) const
  {
    return m_Json.contains(key);
  }

  Node
  operator[](const char * key) const
  {
    if (!this->Has(key))
    {
      this->Fail(std::string("lacks the key \"") + key + '"');
    }
    return Node(m_Json[key], m_Path.empty() ? key : m_Path + '.' + key, m_Source);
  }

  std::vector<Node>
  Elements() const
  {
    if (!m_Json.is_array())
    {
      this->Fail("must be a list" + this->NotThis());
    }
    std::vector<Node> elements;
    for (std::size_t i = 0; i < m_Json.size(); ++i)
    {
      elements.emplace_back(m_Json[i], m_Path + '[' + std::to_string(i) + ']', m_Source);
    }
    return elements;
  }

  void
  RequireObject() const
  {
    if (!m_Json.is_object())
    {
      this->Fail("must be an object in braces" + this->NotThis());
    }
  }

  void
  AllowKeys(const std::vector<std::string> & allowed) const
  {
    this->RequireObject();
    for (const auto & item : m_Json.items())
    {
      if (std::find(allowed.begin(), allowed.end(), item.key()) == allowed.end())
      {
        std::string list;
        for (const auto & key : allowed)
        {
          list += (list.empty() ? "" : ", ") + key;
        }
        this->Fail("has the unknown key \"" + item.key() + "\"; known keys are " + list);
      }
    }
  }

  std::string
  Text() const
  {
    if (!m_Json.is_string())
    {
      this->Fail("must be a string" + this->NotThis());
    }
    return m_Json.get<std::string>();
  }

  double
  Number(double lowest, double highest) const
  {
    if (!this->IsFinite() || m_Json.get<double>() < lowest || m_Json.get<double>() > highest)
    {
      this->Fail("must be a number from " + CsvTable::Number(lowest) + " to " + CsvTable::Number(highest) +
                 this->NotThis());
    }
    return m_Json.get<double>();
  }

  double
  Positive(double highest = largestLength) const
  {
    if (!this->IsFinite() || m_Json.get<double>() <= 0.0 || m_Json.get<double>() > highest)
    {
      this->Fail("must be a number above 0 and at most " + CsvTable::Number(highest) + this->NotThis());
    }
    return m_Json.get<double>();
  }

  shape::Vector
  Point() const
  {
    shape::Vector vector;
    const auto    elements = this->Three();
    std::transform(elements.begin(), elements.end(), vector.begin(), [](const Node & node) {
      return node.Number(-largestLength, largestLength);
    });
    return vector;
  }

  shape::Vector
  PositiveVector() const
  {
    shape::Vector vector;
    const auto    elements = this->Three();
    std::transform(elements.begin(), elements.end(), vector.begin(), [](const Node & node) { return node.Positive(); });
    return vector;
  }

private:
  bool
  IsFinite() const
  {
    return m_Json.is_number() && std::isfinite(m_Json.get<double>());
  }

  std::vector<Node>
  Three() const
  {
    auto elements = this->Elements();
    if (elements.size() != 3)
    {
      this->Fail("must be a list of three numbers, not " + std::to_string(elements.size()));
    }
    return elements;
  }

  std::string
  NotThis() const
  {
    constexpr std::size_t longest = 40;
    const std::string     text = m_Json.dump(-1, ' ', true, Json::error_handler_t::replace);
    return ", not " + (text.size() > longest ? text.substr(0, longest - 3) + "..." : text);
  }

  const Json &        m_Json;
  std::string         m_Path;
  const std::string & m_Source;
};

// ---- primitives ----

shape::Primitive
ParseSphere(const Node & node)
{
  return shape::Sphere{ node["radius"].Positive() };
}

shape::Primitive
ParseEllipsoid(const Node & node)
{
  return shape::Ellipsoid{ node["radii"].PositiveVector() };
}

shape::Primitive
ParseCube(const Node & node)
{
  const double half = 0.5 * node["side"].Positive();
  return shape::Box{ { { half, half, half } } };
}

shape::Primitive
ParseBox(const Node & node)
{
  const auto size = node["size"].PositiveVector();
  return shape::Box{ { { 0.5 * size[0], 0.5 * size[1], 0.5 * size[2] } } };
}

shape::Primitive
ParseCylinder(const Node & node)
{
  return shape::Cylinder{ node["radius"].Positive(), 0.5 * node["length"].Positive() };
}

shape::Primitive
ParseCapsule(const Node & node)
{
  const double half = 0.5 * node["length"].Positive();
  return shape::Tube{ { { { 0.0, 0.0, -half } }, { { 0.0, 0.0, half } } }, node["radius"].Positive() };
}

shape::Primitive
ParseTorus(const Node & node)
{
  const double ringRadius = node["ringRadius"].Positive();
  return shape::Torus{ ringRadius, node["tubeRadius"].Positive(ringRadius) };
}

shape::Primitive
ParseTube(const Node & node)
{
  shape::Tube tube{ {}, node["radius"].Positive() };
  const auto  points = node["points"].Elements();
  if (points.size() < 2 || points.size() > mostPoints)
  {
    node["points"].Fail("must be a list of 2 to " + std::to_string(mostPoints) + " points, not " +
                        std::to_string(points.size()));
  }
  for (const auto & point : points)
  {
    tube.points.push_back(point.Point());
  }
  return tube;
}

struct Kind
{
  const char *             name;
  std::vector<std::string> keys;
  shape::Primitive (*parse)(const Node &);
};

const std::vector<Kind> &
Kinds()
{
  static const std::vector<Kind> kinds{ { "sphere", { "radius" }, ParseSphere },
                                        { "ellipsoid", { "radii" }, ParseEllipsoid },
                                        { "cube", { "side" }, ParseCube },
                                        { "box", { "size" }, ParseBox },
                                        { "cylinder", { "radius", "length" }, ParseCylinder },
                                        { "capsule", { "radius", "length" }, ParseCapsule },
                                        { "torus", { "ringRadius", "tubeRadius" }, ParseTorus },
                                        { "tube", { "radius", "points" }, ParseTube } };
  return kinds;
}

const Kind &
FindKind(const Node & node)
{
  const std::string name = node.Text();
  std::string       list;
  for (const auto & kind : Kinds())
  {
    if (name == kind.name)
    {
      return kind;
    }
    list += (list.empty() ? "" : ", ") + std::string(kind.name);
  }
  node.Fail("must be one of " + list + ", not \"" + name + '"');
}

// ---- deformations ----

shape::Bend
ParseBend(const Node & node, const shape::Object & object)
{
  node.AllowKeys({ "kind", "angle" });
  const double angle = node["angle"].Positive(359.0) * itk::Math::pi_over_180;
  const double arcRadius = 2.0 * shape::HalfExtent(object.primitive)[2] / angle;
  if (shape::Envelope(object)[0] >= arcRadius)
  {
    node["angle"].Fail("bends the object into itself; the arc's radius, length / angle, must exceed its thickness");
  }
  return { arcRadius };
}

shape::Twist
ParseTwist(const Node & node, const shape::Object & object)
{
  node.AllowKeys({ "kind", "angle" });
  const double angle = node["angle"].Number(-3600.0, 3600.0) * itk::Math::pi_over_180;
  return { angle / (2.0 * shape::HalfExtent(object.primitive)[2]) };
}

shape::Bumps
ParseBumps(const Node & node, const shape::Object & object)
{
  node.AllowKeys({ "kind", "amplitude", "wavelength" });
  if (std::holds_alternative<shape::Ellipsoid>(object.primitive))
  {
    node.Fail("adds bumps to an ellipsoid, for which exact distances are not available; use a sphere");
  }
  const double waveNumber = 2.0 * itk::Math::pi / node["wavelength"].Positive();
  const double amplitude = node["amplitude"].Number(-largestLength, largestLength);
  if (std::abs(amplitude) * waveNumber >= 1.0)
  {
    node["amplitude"].Fail("must be less than wavelength / (2 pi), otherwise the surface is not connected");
  }
  return { amplitude, waveNumber };
}

shape::Deformation
ParseDeformation(const Node & node, const shape::Object & object)
{
  node.RequireObject();
  if (!object.deformations.empty() && std::holds_alternative<shape::Bend>(object.deformations.back()))
  {
    node.Fail("follows a bend; the bend must be last");
  }
  const std::string kind = node["kind"].Text();
  if (kind == "bend")
  {
    return ParseBend(node, object);
  }
  if (kind == "twist")
  {
    return ParseTwist(node, object);
  }
  if (kind == "bumps")
  {
    return ParseBumps(node, object);
  }
  node["kind"].Fail("must be bend, twist or bumps, not \"" + kind + '"');
}

// ---- objects ----

// Rodrigues' formula.
std::array<std::array<double, 3>, 3>
ParseRotation(const Node & node)
{
  node.AllowKeys({ "axis", "angle" });
  shape::Vector axis = node["axis"].Point();
  const double  length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  if (length < 1e-12)
  {
    node["axis"].Fail("must not be zero");
  }
  for (double & component : axis)
  {
    component /= length;
  }
  const double                         angle = node["angle"].Number(-360.0, 360.0) * itk::Math::pi_over_180;
  const double                         c = std::cos(angle);
  const double                         s = std::sin(angle);
  std::array<std::array<double, 3>, 3> rotation{};
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int j = (i + 1) % 3;
    const unsigned int k = (i + 2) % 3;
    rotation[i][i] = c + axis[i] * axis[i] * (1.0 - c);
    rotation[i][j] = axis[i] * axis[j] * (1.0 - c) - axis[k] * s;
    rotation[i][k] = axis[i] * axis[k] * (1.0 - c) + axis[j] * s;
  }
  return rotation;
}

// The default is 1 for the first object, 2 for the second, ...
unsigned char
ParseLabel(const Node & object, std::size_t index)
{
  if (!object.Has("label"))
  {
    if (index >= 255)
    {
      object.Fail("lacks the key \"label\", which is required beyond the first 255 objects");
    }
    return static_cast<unsigned char>(index + 1);
  }
  const double label = object["label"].Number(0.0, 255.0);
  if (label != std::floor(label))
  {
    object["label"].Fail("must be a whole number");
  }
  return static_cast<unsigned char>(label);
}

shape::Object
ParseObject(const Node & node, std::size_t index)
{
  node.RequireObject();
  const Kind &             kind = FindKind(node["kind"]);
  std::vector<std::string> keys{ "kind", "name", "center", "rotation", "intensity", "label", "deformations" };
  keys.insert(keys.end(), kind.keys.begin(), kind.keys.end());
  node.AllowKeys(keys);

  shape::Object object;
  object.primitive = kind.parse(node);
  object.name = node.Has("name") ? node["name"].Text() : kind.name + std::string(" ") + std::to_string(index + 1);
  if (node.Has("intensity"))
  {
    object.intensity = node["intensity"].Number(lowestIntensity, highestIntensity);
  }
  object.label = ParseLabel(node, index);
  if (node.Has("center"))
  {
    object.center = node["center"].Point();
  }
  if (node.Has("rotation"))
  {
    object.rotation = ParseRotation(node["rotation"]);
  }
  if (node.Has("deformations"))
  {
    for (const auto & deformation : node["deformations"].Elements())
    {
      object.deformations.push_back(ParseDeformation(deformation, object));
    }
  }
  shape::UpdateBounds(object);
  return object;
}
} // namespace

ShapeScene::Data
ParseShapeScene(const Json & document, const std::string & source)
{
  const Node root(document, "", source);
  root.AllowKeys({ "description", "units", "background", "objects" });
  if (root.Has("description"))
  {
    root["description"].Text();
  }
  ShapeScene::Data  scene;
  const std::string units = root["units"].Text();
  if (units != "mm" && units != "relative")
  {
    root["units"].Fail("must be mm or relative, not \"" + units + '"');
  }
  scene.relative = units == "relative";
  if (root.Has("background"))
  {
    scene.background = root["background"].Number(lowestIntensity, highestIntensity);
  }
  const auto objects = root["objects"].Elements();
  if (objects.size() > mostObjects)
  {
    root["objects"].Fail("has more than " + std::to_string(mostObjects) + " objects");
  }
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    scene.objects.push_back(ParseObject(objects[i], i));
  }
  return scene;
}
} // namespace shapeton
