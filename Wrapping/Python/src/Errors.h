#ifndef Errors_h
#define Errors_h

#include <pybind11/pybind11.h>

#include "itkProcessObject.h"

#include <string>

namespace shapeton::python
{
/** Translates the parameter names in a message of the library to Python: `the parameter "seriesUID"` becomes `the
 * parameter "series_uid"`. */
std::string
InPython(const std::string & message);

/** Registers the exceptions of the library as Python classes, with the same messages. */
void
AddErrors(pybind11::module_ & module);

/** Runs a filter. Errors in its settings or input are rethrown as ParameterError or InputError with the filter's
 * message only. */
void
Update(itk::ProcessObject * filter);
} // namespace shapeton::python

#endif
