#ifndef Landmarks_h
#define Landmarks_h

#include "shapetonColonLandmarks.h"
#include "shapetonHaustralFolds.h"

#include <pybind11/pybind11.h>

#include <memory>

namespace shapeton::python
{
/** What find_folds() gives: a class of its own, because the labels of the module's class are a picture. */
struct FoundFolds
{
  HaustralFolds folds;
};

/** What find_landmarks() gives, with the wall that it refers to. */
struct FoundLandmarks
{
  std::shared_ptr<const FlatColon> flat;
  ColonLandmarks                   landmarks;
};

void
AddLandmarks(pybind11::module_ & module);
} // namespace shapeton::python

#endif
