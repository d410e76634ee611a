#include "shapetonSessionCommands.h"

#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonSessionFrames.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace shapeton
{
namespace
{
/** Options of the walk that a command may set. */
const std::vector<std::string> changeable{ "p",         "intensityWindow", "smoothing",
                                           "shapetons", "distance",        "directionSampling",
                                           "pathRule",  "placement",       "seed" };

bool
IsAmong(const std::vector<std::string> & names, const std::string & name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void
Refuse(const std::string & key, const std::string & wanted)
{
  throw ParameterError("the key \"" + key + "\" must be " + wanted);
}

const Json &
ValueOf(const Json & command, const std::string & key)
{
  const auto value = command.find(key);
  if (value == command.end())
  {
    throw ParameterError("the command lacks the key \"" + key + "\"");
  }
  return *value;
}

template <typename TOption>
void
SetOption(const OptionInfo & info, const Json & value, TOption & option)
{
  if constexpr (std::is_enum_v<TOption>)
  {
    if (!value.is_string())
    {
      Refuse(info.GetName(), "a word");
    }
    option = static_cast<TOption>(info.PositionOf(value.get<std::string>()));
  }
  else if constexpr (std::is_arithmetic_v<TOption>)
  {
    if (!value.is_number() || (std::is_integral_v<TOption> && std::trunc(value.get<double>()) != value.get<double>()))
    {
      Refuse(info.GetName(), std::is_integral_v<TOption> ? "an integer" : "a number");
    }
    info.Check(value.get<double>());
    option = static_cast<TOption>(value.get<double>());
  }
}

void
SetOption(const OptionInfo & info, const Json & value, std::optional<std::array<double, 2>> & option)
{
  if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number() ||
      !(value[0].get<double>() < value[1].get<double>()))
  {
    Refuse(info.GetName(), "two numbers, the lower one first");
  }
  option = { { value[0].get<double>(), value[1].get<double>() } };
}

Json
JsonOfOption(const OptionInfo &, const std::optional<std::array<double, 2>> & option)
{
  return option ? Json(*option) : Json();
}
Json
JsonOfOption(const OptionInfo &, const std::optional<double> & option)
{
  return option ? Json(*option) : Json();
}
template <typename TOption>
Json
JsonOfOption(const OptionInfo & info, const TOption & option)
{
  if constexpr (std::is_enum_v<TOption>)
  {
    return info.GetWords().at(static_cast<std::size_t>(option));
  }
  else
  {
    return option;
  }
}
} // namespace

void
RequireKeys(const Json & command, const std::vector<std::string> & keys)
{
  for (const auto & [key, value] : command.items())
  {
    RequireParameter(key == "do" || key == "id" || IsAmong(keys, key),
                     "the command has the unknown parameter \"" + key + "\"");
  }
}

double
NumberOf(const Json & command, const std::string & key, double least, double most)
{
  const Json & value = ValueOf(command, key);
  if (!value.is_number() || !(value.get<double>() >= least && value.get<double>() <= most))
  {
    Refuse(key, "a number from " + CsvTable::Number(least) + " to " + CsvTable::Number(most));
  }
  return value.get<double>();
}

std::uint64_t
CountOf(const Json & command, const std::string & key, std::uint64_t least, std::uint64_t most)
{
  const double number = NumberOf(command, key, static_cast<double>(least), static_cast<double>(most));
  if (std::trunc(number) != number)
  {
    Refuse(key, "an integer");
  }
  return static_cast<std::uint64_t>(number);
}

std::string
WordOf(const Json & command, const std::string & key)
{
  const Json & value = ValueOf(command, key);
  if (!value.is_string())
  {
    Refuse(key, "a text");
  }
  return value.get<std::string>();
}

bool
FlagOf(const Json & command, const std::string & key)
{
  const auto value = command.find(key);
  if (value == command.end())
  {
    return false;
  }
  if (!value->is_boolean())
  {
    Refuse(key, "true or false");
  }
  return value->get<bool>();
}

namespace
{
template <std::size_t VLength>
std::array<double, VLength>
NumbersOf(const Json & list, const std::string & key)
{
  constexpr double            farthest = 1e6; // mm
  std::array<double, VLength> numbers{};
  bool                        isGood = list.is_array() && list.size() == VLength;
  for (std::size_t i = 0; i < VLength && isGood; ++i)
  {
    isGood = list[i].is_number() && std::abs(list[i].get<double>()) <= farthest;
    numbers[i] = isGood ? list[i].get<double>() : 0.0;
  }
  if (!isGood)
  {
    Refuse(key, std::to_string(VLength) + " numbers of at most 1e6");
  }
  return numbers;
}
} // namespace

itk::Point<double, 3>
PointOf(const Json & command, const std::string & key)
{
  return itk::Point<double, 3>(NumbersOf<3>(ValueOf(command, key), key).data());
}

std::vector<Ball>
BallsOf(const Json & command, const std::string & key)
{
  constexpr std::size_t most = 4096;
  const Json &          list = ValueOf(command, key);
  if (!list.is_array() || list.empty() || list.size() > most)
  {
    Refuse(key, "a list of 1 to 4096 balls");
  }
  std::vector<Ball> balls;
  for (const Json & one : list)
  {
    const auto numbers = NumbersOf<4>(one, key);
    if (!(numbers[3] > 0.0))
    {
      Refuse(key, "a list of balls with positive radius");
    }
    balls.push_back({ itk::Point<double, 3>(numbers.data()), numbers[3] });
  }
  return balls;
}

std::string
ResultNameOf(const Json & command, const std::string & key)
{
  constexpr std::size_t longest = 64;
  const std::string     name = WordOf(command, key);
  const auto            isLetter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  const auto isAllowed = [&](char c) { return isLetter(c) || c == '_' || c == '-' || c == '.'; };
  if (name.empty() || name.size() > longest || !isLetter(name.front()) ||
      !std::all_of(name.begin(), name.end(), isAllowed))
  {
    Refuse(key, "a name of at most 64 letters, digits, \"_\", \"-\" and \".\"");
  }
  return name;
}

void
SetOptions(const Json & command, ParticleDiffusionOptions & options)
{
  RequireKeys(command, changeable);
  ParticleDiffusionOptions changed = options;
  bool                     isAny = false;
  ParticleDiffusionOptions::VisitOptions(changed, [&](const OptionInfo & info, auto & option) {
    const auto value = command.find(info.GetName());
    if (value != command.end())
    {
      SetOption(info, *value, option);
      isAny = true;
    }
  });
  RequireParameter(isAny, "the command sets no option");
  options = changed;
}

Json
JsonOfOptions(const ParticleDiffusionOptions & options)
{
  Json json = Json::object();
  ParticleDiffusionOptions::VisitOptions(options, [&](const OptionInfo & info, const auto & option) {
    if (IsAmong(changeable, info.GetName()))
    {
      json[info.GetName()] = JsonOfOption(info, option);
    }
  });
  return json;
}
} // namespace shapeton
