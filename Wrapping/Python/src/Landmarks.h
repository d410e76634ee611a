#ifndef Landmarks_h
#define Landmarks_h

#include "shapetonColonLandmarks.h"
#include "shapetonHaustralFolds.h"

#include <pybind11/pybind11.h>

#include <memory>

namespace shapeton::python
{
/** Result of find_folds(): a separate class, because HaustralFolds stores its labels as an image. */
struct FoundFolds
{
  HaustralFolds folds;
};

/** Result of find_landmarks(), with the wall to which it refers. */
struct FoundLandmarks
{
  std::shared_ptr<const FlatColon> flat;
  ColonLandmarks                   landmarks;
};

void
AddLandmarks(pybind11::module_ & module);
} // namespace shapeton::python

#endif
