#include "Errors.h"

#include "shapetonDevice.h"
#include "shapetonExceptions.h"
#include "shapetonParticleDiffusionImageFilter.h"

#include <cctype>
#include <stdexcept>
#include <string>

namespace shapeton::python
{
namespace py = pybind11;

namespace
{
/** An exception class with process lifetime: its static holder must not be destroyed after interpreter
 * shutdown. */
py::handle
AddError(py::module_ & module, const char * name, const py::handle & bases, const char * words)
{
  py::exception<Exception> error(module, name, bases);
  error.attr("__doc__") = words;
  return error.release();
}

/** The exception with the message of the library and Python's parameter names. */
void
Raise(const py::handle & kind, const Exception & error)
{
  PyErr_SetString(kind.ptr(), InPython(error.what()).c_str());
}
} // namespace

std::string
InPython(const std::string & message)
{
  return SpellParameters(message, [](const std::string & name, bool hasValue) {
    std::string words;
    for (std::size_t i = 0; i < name.size(); ++i)
    {
      const auto letter = static_cast<unsigned char>(name[i]);
      const bool isNewWord =
        i > 0 && std::isupper(letter) != 0 && std::isupper(static_cast<unsigned char>(name[i - 1])) == 0;
      words += (isNewWord ? "_" : "") + std::string(1, static_cast<char>(std::tolower(letter)));
    }
    return "the parameter \"" + words + "\"" + (hasValue ? " = " : "");
  });
}

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
  catch (const itk::MemoryAllocationError &)
  {
    throw std::bad_alloc();
  }
  catch (const itk::ExceptionObject & error)
  {
    throw ParameterError(WithoutItkPrefix(error.GetDescription()));
  }
}

void
AddErrors(py::module_ & module)
{
  static py::handle parameterError;
  static py::handle inputError;
  static py::handle outputError;
  static py::handle deviceError;
  const py::handle  base = AddError(module, "Error", PyExc_Exception, "Base class of all exceptions of Shapeton.");
  parameterError = AddError(module,
                            "ParameterError",
                            py::make_tuple(base, py::handle(PyExc_ValueError)),
                            "A parameter is out of range or contradicts another one; also a ValueError.");
  inputError = AddError(module,
                        "InputError",
                        py::make_tuple(base, py::handle(PyExc_ValueError)),
                        "The input is missing, unreadable, malformed or unsuitable; also a ValueError.");
  outputError = AddError(module,
                         "OutputError",
                         py::make_tuple(base, py::handle(PyExc_OSError)),
                         "A result cannot be written; also an OSError.");
  deviceError = AddError(module,
                         "DeviceError",
                         py::make_tuple(base, py::handle(PyExc_RuntimeError)),
                         "A requested GPU is not available or failed; also a RuntimeError.");
  AddError(module,
           "Aborted",
           py::make_tuple(base, py::handle(PyExc_RuntimeError)),
           "A progress function returned False; also a RuntimeError.");

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
      Raise(parameterError, error);
    }
    catch (const InputError & error)
    {
      Raise(inputError, error);
    }
    catch (const OutputError & error)
    {
      Raise(outputError, error);
    }
    catch (const DeviceError & error)
    {
      Raise(deviceError, error);
    }
    catch (const DeviceFailure & error)
    {
      PyErr_SetString(deviceError.ptr(), error.what());
    }
    catch (const itk::ExceptionObject & error)
    {
      PyErr_SetString(PyExc_RuntimeError, WithoutItkPrefix(error.GetDescription()).c_str());
    }
    catch (const std::logic_error & error) // errors of the caller, such as arrays of different sizes
    {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}
} // namespace shapeton::python
