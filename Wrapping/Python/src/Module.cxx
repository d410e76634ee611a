#include "Bindings.h"
#include "Errors.h"

#include "itkMultiThreaderBase.h"

namespace py = pybind11;
using namespace pybind11::literals;

PYBIND11_MODULE(_shapeton, module)
{
  module.doc() = "What the modules of the package are made of; see shapeton.";
  shapeton::python::AddErrors(module);
  module.def(
    "set_threads",
    [](unsigned int number) { itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(number); },
    "number"_a,
    "Sets how many threads all functions of this process use; results do not depend on it.");
  module.def("threads",
             &itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads,
             "How many threads the functions of this process use.");
  shapeton::python::AddVolumes(module);
  shapeton::python::AddHeat(module);
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
}
