#include "shapetonShapeScene.h"
#include "shapetonShapeSceneData.h"

#include "shapetonJson.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace shapeton
{
namespace
{
#include "shapetonShapePresets.h"

shape::Vector
ToUnits(const ShapeScene::PointType & point, double unitLength)
{
  return { { point[0] / unitLength, point[1] / unitLength, point[2] / unitLength } };
}

// Rounds distances so that faces through voxel centers are independent of the last bits of a sine.
double
Round(double distance)
{
  constexpr double grid = 1073741824.0; // 2^30
  return std::nearbyint(distance * grid) / grid;
}

std::string
ListOfPresets()
{
  std::string list;
  for (const auto & name : ShapeScene::GetPresetNames())
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}
} // namespace

ShapeScene::ShapeScene() : m_Data(std::make_shared<const Data>()) {}

const std::vector<std::string> &
ShapeScene::GetPresetNames()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto & preset : shapePresets)
    {
      list.push_back(preset.first);
    }
    return list;
  }();
  return names;
}

ShapeScene
ShapeScene::Load(const std::string & presetOrFile)
{
  for (const auto & preset : shapePresets)
  {
    if (preset.first == presetOrFile)
    {
      return FromJson(Json::parse(preset.second), preset.first);
    }
  }
  const std::filesystem::path path(presetOrFile);
  std::error_code             error;
  if (path.extension() != ".json" && !std::filesystem::is_regular_file(path, error))
  {
    throw ParameterError("the shape \"" + presetOrFile + "\" is neither a JSON file nor one of " + ListOfPresets());
  }
  return FromJson(ReadJson(presetOrFile), presetOrFile);
}

ShapeScene
ShapeScene::FromJson(const nlohmann::ordered_json & document, const std::string & source)
{
  ShapeScene scene;
  scene.m_Data = std::make_shared<const Data>(ParseShapeScene(document, source));
  return scene;
}

bool
ShapeScene::IsRelative() const
{
  return m_Data->relative;
}

void
ShapeScene::SetUnitLength(double millimeters)
{
  m_UnitLength = millimeters;
}

double
ShapeScene::GetBackground() const
{
  return m_Data->background;
}

std::size_t
ShapeScene::GetNumberOfObjects() const
{
  return m_Data->objects.size();
}

ShapeScene::Object
ShapeScene::GetObject(std::size_t object) const
{
  const shape::Object & data = m_Data->objects.at(object);
  Object                result{ data.name, data.intensity, data.label, {}, data.boundingRadius * m_UnitLength };
  for (unsigned int i = 0; i < 3; ++i)
  {
    result.boundingCenter[i] = data.boundingCenter[i] * m_UnitLength;
  }
  return result;
}

double
ShapeScene::SignedDistance(std::size_t object, const PointType & point) const
{
  return Round(m_UnitLength * shape::SignedDistance(m_Data->objects[object], ToUnits(point, m_UnitLength)));
}

unsigned char
ShapeScene::GetLabel(const PointType & point) const
{
  for (std::size_t object = m_Data->objects.size(); object-- > 0;)
  {
    if (this->SignedDistance(object, point) <= 0.0)
    {
      return m_Data->objects[object].label;
    }
  }
  return 0;
}
} // namespace shapeton
