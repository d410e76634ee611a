#include "shapetonReadOptions.h"

#include "shapetonExceptions.h"

#include <charconv>
#include <cmath>

namespace shapeton
{
namespace
{
template <typename TNumber>
std::optional<TNumber>
ReadNumberOrAuto(const CommandLine & commandLine, const OptionInfo & info)
{
  const std::string text = commandLine.GetString(info.GetName());
  if (text == "auto")
  {
    return std::nullopt;
  }
  TNumber            number{};
  const auto * const end = text.data() + text.size();
  const auto         parsed = std::from_chars(text.data(), end, number);
  RequireParameter(parsed.ec == std::errc() && parsed.ptr == end,
                   "the parameter \"" + std::string(info.GetName()) + "\": \"" + text + "\" is not " +
                     (std::is_integral_v<TNumber> ? "an integer" : "a number") + " or auto");
  return number;
}
} // namespace

std::optional<double>
ReadNumber(const CommandLine & commandLine, const OptionInfo & info)
{
  return ReadNumberOrAuto<double>(commandLine, info);
}

std::optional<std::int64_t>
ReadInteger(const CommandLine & commandLine, const OptionInfo & info)
{
  const auto       number = ReadNumber(commandLine, info); // 1e5 is an integer, too
  constexpr double mostExact = 9007199254740992.0;         // 2^53
  RequireParameter(!number || (*number == std::trunc(*number) && std::abs(*number) <= mostExact),
                   "the parameter \"" + std::string(info.GetName()) + "\": \"" + commandLine.GetString(info.GetName()) +
                     "\" is not an integer or auto");
  return number;
}

void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::optional<int> & option)
{
  option = ReadNumberOrAuto<int>(commandLine, info);
}

void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::optional<double> & option)
{
  option = ReadNumberOrAuto<double>(commandLine, info);
}

void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::optional<std::array<double, 2>> & option)
{
  const auto numbers = commandLine.GetDoubles(info.GetName());
  RequireParameter(numbers.empty() || (numbers.size() == 2 && numbers[0] < numbers[1]),
                   "the parameter \"" + std::string(info.GetName()) +
                     "\" requires two numbers, the lower one first, for example -160,240");
  option.reset();
  if (!numbers.empty())
  {
    option = { { numbers[0], numbers[1] } };
  }
}

void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::vector<itk::Point<double, 3>> & option)
{
  option.clear();
  for (const auto & point : commandLine.GetPoints(info.GetName()))
  {
    option.emplace_back(point.data());
  }
}

void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::vector<int> & option)
{
  option = commandLine.GetIntegers(info.GetName());
}

void
ReadOption(const CommandLine & commandLine, const OptionInfo & info, std::vector<double> & option)
{
  option = commandLine.GetDoubles(info.GetName());
}
} // namespace shapeton
