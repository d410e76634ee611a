#ifndef shapetonReadOptions_h
#define shapetonReadOptions_h

#include "shapetonCommandLine.h"
#include "shapetonOptions.h"

#include "itkPoint.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace shapeton
{
/** A number, or none for "auto". Throws ParameterError. \ingroup ShapetonCommandLine */
///@{
ShapetonCommandLine_EXPORT std::optional<double>
                           ReadNumber(const CommandLine & commandLine, const OptionInfo & info);
ShapetonCommandLine_EXPORT std::optional<std::int64_t>
                           ReadInteger(const CommandLine & commandLine, const OptionInfo & info);
///@}

/** Reads one option; overloads for the types of members. A number keeps its value if "auto" is given. Throws
 * ParameterError. \ingroup ShapetonCommandLine */
///@{
template <typename TOption>
void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, TOption & option)
{
  const std::string name = info.GetName();
  if constexpr (std::is_enum_v<TOption>)
  {
    option = static_cast<TOption>(info.PositionOf(commandLine.GetString(name)));
  }
  else if constexpr (std::is_same_v<TOption, bool>)
  {
    option = commandLine.GetFlag(name);
  }
  else if constexpr (std::is_integral_v<TOption>)
  {
    const auto number = ReadInteger(commandLine, info);
    if (std::is_unsigned_v<TOption> && number && *number < 0)
    {
      info.Check(static_cast<double>(*number));
    }
    option = static_cast<TOption>(number.value_or(option));
  }
  else if constexpr (std::is_same_v<TOption, double>)
  {
    option = ReadNumber(commandLine, info).value_or(option);
  }
  else
  {
    static_assert(std::is_same_v<TOption, std::string>, "an option of this type needs an overload");
    option = commandLine.GetString(name);
  }
}
/** A number or "auto". */
ShapetonCommandLine_EXPORT void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::optional<int> & option);
ShapetonCommandLine_EXPORT void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::optional<double> & option);
/** Two numbers, the lower one first, or nothing. */
ShapetonCommandLine_EXPORT void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::optional<std::array<double, 2>> & option);
/** Any number of points. */
ShapetonCommandLine_EXPORT void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::vector<itk::Point<double, 3>> & option);
/** Any number of numbers. */
ShapetonCommandLine_EXPORT void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::vector<int> & option);
ShapetonCommandLine_EXPORT void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::vector<double> & option);
///@}

/** Sets the options that the tool declares. Throws ParameterError. \ingroup ShapetonCommandLine */
template <typename TOptions>
void
ReadOptions(const CommandLine & commandLine, TOptions & options)
{
  TOptions::VisitOptions(options, [&commandLine](const OptionInfo & info, auto & option) {
    if (commandLine.Declares(info.GetName()))
    {
      ReadOption(commandLine, info, option);
    }
  });
}

/** Sets the options that are given and returns their names; "auto" and "preset", which 3D Slicer passes, stand for
 * none. Throws ParameterError. \ingroup ShapetonCommandLine */
template <typename TOptions>
std::vector<std::string>
ReadGivenOptions(const CommandLine & commandLine, TOptions & options)
{
  std::vector<std::string> given;
  TOptions::VisitOptions(options, [&](const OptionInfo & info, auto & option) {
    const std::string text = commandLine.Declares(info.GetName()) ? commandLine.GetString(info.GetName()) : "auto";
    if (text != "auto" && text != "preset" && commandLine.IsGiven(info.GetName()))
    {
      ReadOption(commandLine, info, option);
      given.emplace_back(info.GetName());
    }
  });
  return given;
}

/** Sets the options of a FilterWithOptions that the tool declares. \ingroup ShapetonCommandLine */
template <typename TFilter>
void
ReadOptionsOf(const CommandLine & commandLine, TFilter * filter)
{
  auto options = filter->GetOptions();
  ReadOptions(commandLine, options);
  filter->SetOptions(options);
}
} // namespace shapeton

#endif
