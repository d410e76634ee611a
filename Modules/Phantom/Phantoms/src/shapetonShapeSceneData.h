#ifndef shapetonShapeSceneData_h
#define shapetonShapeSceneData_h

#include "shapetonShapeDistance.h"
#include "shapetonShapeScene.h"

#include <vector>

namespace shapeton
{
struct ShapeScene::Data
{
  bool                       relative{ false };
  double                     background{ 0.0 };
  std::vector<shape::Object> objects;
};

/** Reads and validates a scene document. Throws InputError with `source` and the key. */
ShapeScene::Data
ParseShapeScene(const nlohmann::ordered_json & document, const std::string & source);
} // namespace shapeton

#endif
