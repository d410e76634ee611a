#include "Bindings.h"
#include "Conversions.h"
#include "Errors.h"
#include "Threads.h"

PYBIND11_MODULE(_shapeton, module)
{
  using namespace pybind11::literals;
  module.doc() = "Compiled core of the package; see shapeton.";
  shapeton::python::AddErrors(module);
  shapeton::python::AddThreads(module);
  shapeton::python::AddVolumes(module);
  shapeton::python::AddHeat(module);
  shapeton::python::AddHeatObjects(module);
  shapeton::python::AddShapetons(module);
  shapeton::python::AddSeeds(module);
  shapeton::python::AddShapes(module);
  shapeton::python::AddSurfaces(module);
  shapeton::python::AddMetric(module);
  shapeton::python::AddFlattening(module);
  shapeton::python::AddColonModel(module);
  shapeton::python::AddFlatColon(module);
  shapeton::python::AddCandidates(module);
  shapeton::python::AddRegistration(module);
  shapeton::python::AddPhantoms(module);
  shapeton::python::AddGraphs(module);
  module.def("_set_progress_period", &shapeton::python::SetProgressPeriod, "milliseconds"_a);
}
