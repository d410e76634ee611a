#include "Errors.h"

#include "shapetonExceptions.h"
#include "shapetonParticleDiffusionImageFilter.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <stdexcept>
#include <string>

namespace shapeton::python
{
namespace py = pybind11;

namespace
{
/** Strips "ITK ERROR: Class(0x1234): ", the prefix of ITK's macros. */
std::string
WordsOf(const itk::ExceptionObject & error)
{
  const std::string text = error.GetDescription();
  const auto        front = text.find("ERROR: ") == std::string::npos ? std::string::npos : text.find("): ");
  return front == std::string::npos ? text : text.substr(front + 3);
}

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
  static const std::regex parameter("the parameter \"\\w+\"");
  static const std::regex border("([a-z0-9])([A-Z])"); // between two words of a name
  std::string             text;
  auto                    rest = message.begin();
  for (std::sregex_iterator match(message.begin(), message.end(), parameter), end; match != end; ++match)
  {
    std::string name = std::regex_replace(match->str(), border, "$1_$2");
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    text.append(rest, (*match)[0].first).append(name);
    rest = (*match)[0].second;
  }
  return text.append(rest, message.end());
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
  static py::handle parameterError;
  static py::handle inputError;
  static py::handle outputError;
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
    catch (const itk::ExceptionObject & error)
    {
      PyErr_SetString(PyExc_RuntimeError, WordsOf(error).c_str());
    }
    catch (const std::logic_error & error) // errors of the caller, such as arrays of different sizes
    {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}
} // namespace shapeton::python
