#ifndef Errors_h
#define Errors_h

#include <pybind11/pybind11.h>

#include "itkProcessObject.h"

#include <string>

namespace shapeton::python
{
/** A message or a remark of the library with the names that parameters have in Python: `the parameter "seriesUID"`
 * becomes `the parameter "series_uid"`. */
std::string
InPython(const std::string & message);

/** The exceptions of the library as classes of Python, with the same words. */
void
AddErrors(pybind11::module_ & module);

/** Runs a filter. Whatever it finds wrong with its settings or its input becomes ParameterError or InputError, in the
 * filter's words alone. */
void
Update(itk::ProcessObject * filter);
} // namespace shapeton::python

#endif
