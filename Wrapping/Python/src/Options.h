#ifndef Options_h
#define Options_h

#include "Conversions.h"

#include "shapetonOptions.h"

#include <array>
#include <optional>

namespace shapeton::python
{
/** A struct of options as a parameter of a compiled function; Python passes a dictionary of the declared names. */
template <typename TOptions>
struct Given
{
  TOptions options;
};

template <typename TOption>
void
SetOption(const OptionInfo & info, TOption & option, const py::handle & value)
{
  if constexpr (std::is_enum_v<TOption>)
  {
    option = static_cast<TOption>(info.PositionOf(value.cast<std::string>()));
  }
  else
  {
    try
    {
      option = value.cast<TOption>();
    }
    catch (const py::cast_error &) // for example a negative number; the package has checked the type
    {
      throw ParameterError("the parameter \"" + std::string(info.GetName()) + "\": " + std::string(py::str(value)) +
                           " is out of range");
    }
  }
}
} // namespace shapeton::python

namespace pybind11::detail
{
template <typename TOptions>
struct type_caster<shapeton::python::Given<TOptions>>
{
  PYBIND11_TYPE_CASTER(shapeton::python::Given<TOptions>, const_name("Dict[str, Any]"));

  bool
  load(handle source, bool)
  {
    const auto given = reinterpret_borrow<dict>(source);
    TOptions::VisitOptions(value.options, [&given](const shapeton::OptionInfo & info, auto & option) {
      if (given.contains(info.GetName()))
      {
        shapeton::python::SetOption(info, option, given[info.GetName()]);
      }
    });
    return true;
  }
};
} // namespace pybind11::detail

#endif
