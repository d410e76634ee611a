#ifndef itkShapeSceneData_h
#define itkShapeSceneData_h

#include "itkShapeDistance.h"
#include "itkShapeScene.h"

#include <vector>

namespace itk
{
struct ShapeScene::Data
{
  bool                       relative{ false };
  double                     background{ 0.0 };
  std::vector<shape::Object> objects;
};

/** Reads and checks a scene document. Throws InputError that names `source` and the key. */
ShapeScene::Data
ParseShapeScene(const nlohmann::ordered_json & document, const std::string & source);
} // namespace itk

#endif
