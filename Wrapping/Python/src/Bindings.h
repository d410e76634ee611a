#ifndef Bindings_h
#define Bindings_h

#include <pybind11/pybind11.h>

/** Registration functions of the module, one per subject. */
namespace shapeton::python
{
void
AddVolumes(pybind11::module_ & module);
void
AddHeat(pybind11::module_ & module);
void
AddHeatObjects(pybind11::module_ & module);
void
AddShapetons(pybind11::module_ & module);
void
AddSeeds(pybind11::module_ & module);
void
AddShapes(pybind11::module_ & module);
void
AddSurfaces(pybind11::module_ & module);
void
AddMetric(pybind11::module_ & module);
void
AddFlattening(pybind11::module_ & module);
void
AddColonModel(pybind11::module_ & module);
void
AddFlatColon(pybind11::module_ & module);
void
AddCandidates(pybind11::module_ & module);
void
AddRegistration(pybind11::module_ & module);
void
AddPhantoms(pybind11::module_ & module);
void
AddGraphs(pybind11::module_ & module);
} // namespace shapeton::python

#endif
