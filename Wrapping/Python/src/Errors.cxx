#include "Errors.h"

#include "shapetonExceptions.h"
#include "shapetonShapetonDiffusionImageFilter.h"

#include <stdexcept>
#include <string>

namespace shapeton::python
{
namespace py = pybind11;

namespace
{
/** Without "ITK ERROR: Class(0x1234): ", which ITK's macros put in front. */
std::string
WordsOf(const itk::ExceptionObject & error)
{
  const std::string text = error.GetDescription();
  const auto        front = text.find("ERROR: ") == std::string::npos ? std::string::npos : text.find("): ");
  return front == std::string::npos ? text : text.substr(front + 3);
}
} // namespace

void
Update(itk::ProcessObject * filter)
{
  try
  {
    filter->UpdateLargestPossibleRegion();
  }
  catch (const Exception &)
  {
    throw;
  }
  catch (const ShapetonInputError & error)
  {
    throw InputError(error.GetDescription());
  }
  catch (const itk::ExceptionObject & error)
  {
    throw ParameterError(WordsOf(error));
  }
}

void
AddErrors(py::module_ & module)
{
  static py::exception<Exception>      base(module, "Error");
  static py::exception<ParameterError> parameterError(
    module, "ParameterError", py::make_tuple(base, py::handle(PyExc_ValueError)));
  static py::exception<InputError> inputError(module, "InputError", py::make_tuple(base, py::handle(PyExc_ValueError)));
  static py::exception<OutputError> outputError(module, "OutputError", py::make_tuple(base, py::handle(PyExc_OSError)));
  static py::exception<std::runtime_error> aborted(
    module, "Aborted", py::make_tuple(base, py::handle(PyExc_RuntimeError)));
  base.attr("__doc__") = "What all errors of Shapeton derive from.";
  parameterError.attr("__doc__") = "A parameter is out of range or contradicts another one; also a ValueError.";
  inputError.attr("__doc__") = "The input is missing, unreadable, malformed or unsuitable; also a ValueError.";
  outputError.attr("__doc__") = "A result cannot be written; also an OSError.";
  aborted.attr("__doc__") = "A progress function has returned False; also a RuntimeError.";

  py::register_exception_translator([](std::exception_ptr thrown) {
    try
    {
      if (thrown)
      {
        std::rethrow_exception(thrown);
      }
    }
    catch (const ParameterError & error)
    {
      parameterError(error.what());
    }
    catch (const InputError & error)
    {
      inputError(error.what());
    }
    catch (const OutputError & error)
    {
      outputError(error.what());
    }
    catch (const itk::ExceptionObject & error)
    {
      PyErr_SetString(PyExc_RuntimeError, WordsOf(error).c_str());
    }
    catch (const std::logic_error & error) // of the calling code, such as arrays of different sizes
    {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}
} // namespace shapeton::python
