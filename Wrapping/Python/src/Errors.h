#ifndef Errors_h
#define Errors_h

#include <pybind11/pybind11.h>

#include "itkProcessObject.h"

namespace shapeton::python
{
/** The exceptions of the library as classes of Python, with the same words. */
void
AddErrors(pybind11::module_ & module);

/** Runs a filter. Whatever it finds wrong with its settings or its input becomes ParameterError or InputError, in the
 * filter's words alone. */
void
Update(itk::ProcessObject * filter);
} // namespace shapeton::python

#endif
