#include "shapetonArguments.h"
#include "shapetonParameterValue.h"
#include "shapetonPrintable.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace shapeton
{
namespace
{
using Parameter = ModuleDescription::Parameter;

bool
IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

// "-1", "-.5" and "-1,2,3" are values, "-g" is an option.
bool
IsNegativeNumber(const std::string & text)
{
  const std::size_t first = text.size() > 2 && text[1] == '.' ? 2 : 1;
  return text.size() > first && text[0] == '-' && IsDigit(text[first]);
}

bool
IsOption(const std::string & text)
{
  return text.size() > 1 && text[0] == '-' && !IsNegativeNumber(text);
}

bool
ReadBoolean(const std::string & option, const std::string & value)
{
  if (value != "true" && value != "false")
  {
    throw ParameterError(option + ": " + Quoted(value) + " is neither true nor false");
  }
  return value == "true";
}

/** 3D Slicer passes every option, including unchanged ones with their default. */
bool
IsDefault(const Parameter & parameter, const std::string & value)
{
  const bool mayBeEmpty = parameter.IsVector() || parameter.tag == "string";
  if (value.empty() && parameter.defaultValue.empty() && mayBeEmpty)
  {
    return true;
  }
  CheckValue(parameter, value);
  return !parameter.defaultValue.empty() &&
         CanonicalValue(parameter, value) == CanonicalValue(parameter, parameter.defaultValue);
}

/** Levenshtein distance of two texts. */
std::size_t
EditDistance(const std::string & a, const std::string & b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ replaced, row[j] + 1, row[j + 1] + 1 });
    }
  }
  return row.back();
}

/** Parses the arguments in one pass. */
class Parser
{
public:
  Parser(const ModuleDescription & module, const std::vector<std::string> & arguments)
    : m_Module(module), m_Arguments(arguments), m_Positionals(module.Positionals())
  {}

  Arguments
  Parse()
  {
    bool optionsEnded = false;
    while (m_Next < m_Arguments.size())
    {
      const std::string & argument = m_Arguments[m_Next++];
      if (argument == "--" && !optionsEnded)
      {
        optionsEnded = true;
      }
      else if (optionsEnded || !IsOption(argument))
      {
        this->TakePositional(argument);
      }
      else
      {
        this->TakeOption(argument);
      }
    }
    this->CheckPositionals();
    return std::move(m_Result);
  }

private:
  void
  TakePositional(const std::string & value)
  {
    if (m_NextPositional == m_Positionals.size())
    {
      throw ParameterError("unexpected argument " + Quoted(value) + "; --help shows the usage");
    }
    const Parameter & parameter = *m_Positionals[m_NextPositional];
    this->Store(parameter, value);
    m_NextPositional += parameter.multiple ? 0 : 1;
  }

  void
  TakeOption(const std::string & argument)
  {
    const auto equals = argument.compare(0, 2, "--") == 0 ? argument.find('=') : std::string::npos;
    m_Option = argument.substr(0, equals);
    m_HasValue = equals != std::string::npos;
    m_Value = m_HasValue ? argument.substr(equals + 1) : "";

    if (m_Option == "--quiet")
    {
      m_Result.quiet = this->TakeBoolean();
    }
    else if (m_Option == "--echo")
    {
      m_Result.echo = this->TakeBoolean();
    }
    else if (m_Option == "--processinformationaddress")
    {
      this->TakeAddress();
    }
    else if (m_Option == "--returnparameterfile")
    {
      m_Result.returnFile = this->TakeValue();
      if (m_Result.returnFile.empty())
      {
        throw ParameterError(m_Option + ": the name is empty");
      }
    }
    else
    {
      this->TakeParameter(this->FindParameter());
    }
  }

  /** A module host passes the address of a structure for progress, which only a module in its own process can use. */
  void
  TakeAddress()
  {
    const std::string value = this->TakeValue();
    if (value.empty() || value.find_first_not_of("0123456789") != std::string::npos)
    {
      throw ParameterError(m_Option + ": " + Quoted(value) + " is not an address, a whole number");
    }
  }

  void
  TakeParameter(const Parameter & parameter)
  {
    if (!parameter.multiple && !m_Seen.insert(&parameter).second)
    {
      throw ParameterError(parameter.Display() + " is given twice; give it once");
    }
    if (parameter.tag == "boolean")
    {
      m_Result.given[parameter.name] = { this->TakeBoolean() ? "true" : "false" };
      return;
    }
    const std::string value = this->TakeValue();
    if (parameter.multiple || !IsDefault(parameter, value))
    {
      this->Store(parameter, value);
    }
  }

  void
  Store(const Parameter & parameter, const std::string & value)
  {
    CheckValue(parameter, value);
    m_Result.given[parameter.name].push_back(value);
  }

  bool
  TakeBoolean() const
  {
    return !m_HasValue || ReadBoolean(m_Option, m_Value);
  }

  std::string
  TakeValue()
  {
    if (m_HasValue)
    {
      return m_Value;
    }
    if (m_Next == m_Arguments.size())
    {
      throw ParameterError(m_Option + " requires a value");
    }
    const std::string & value = m_Arguments[m_Next++];
    if (value.compare(0, 2, "--") == 0) // a missing value, not a file of that name
    {
      throw ParameterError(m_Option + " requires a value; a value that begins with two hyphens is written " + m_Option +
                           "=VALUE");
    }
    return value;
  }

  const Parameter &
  FindParameter() const
  {
    const auto & parameters = m_Module.parameters;
    const auto   parameter = std::find_if(parameters.begin(), parameters.end(), [this](const Parameter & p) {
      return (!p.longflag.empty() && m_Option == "--" + p.longflag) || (!p.flag.empty() && m_Option == '-' + p.flag);
    });
    if (parameter == parameters.end())
    {
      throw ParameterError("unknown option " + Quoted(m_Option) + this->SimilarOption() + " --help lists the options");
    }
    return *parameter;
  }

  /** Suggests the option that differs by at most two letters, for example because of British spelling or a typing
   * error.
   */
  std::string
  SimilarOption() const
  {
    constexpr std::size_t shortest = 5; // "--gam": shorter options are similar by chance
    constexpr std::size_t longest = 40; // longer than any option; limits the run time
    std::size_t           least = 3;
    std::string           hint = ";";
    for (const Parameter & parameter : m_Module.parameters)
    {
      const std::string option = "--" + parameter.longflag;
      const std::size_t letters = std::min(option.size(), m_Option.size());
      const bool        isCompared = letters >= shortest && m_Option.size() < longest;
      const std::size_t distance = isCompared ? EditDistance(option, m_Option) : least;
      if (distance < least)
      {
        least = distance;
        hint = "; did you mean " + option + '?';
      }
    }
    return hint;
  }

  void
  CheckPositionals() const
  {
    for (const auto * parameter : m_Positionals)
    {
      if (!m_Result.given.count(parameter->name))
      {
        throw ParameterError("the argument " + parameter->name + " is missing; --help shows the usage");
      }
    }
  }

  const ModuleDescription &        m_Module;
  const std::vector<std::string> & m_Arguments;
  std::size_t                      m_Next{ 0 };
  std::vector<const Parameter *>   m_Positionals;
  std::size_t                      m_NextPositional{ 0 };
  std::set<const Parameter *>      m_Seen;
  Arguments                        m_Result;

  // the current option
  std::string m_Option;
  std::string m_Value;
  bool        m_HasValue{ false };
};
} // namespace

std::string
FindQuestion(const std::vector<std::string> & arguments)
{
  for (const auto & argument : arguments)
  {
    if (argument == "--")
    {
      return "";
    }
    if (argument == "--help" || argument == "-h" || argument == "--version" || argument == "--xml")
    {
      return argument;
    }
  }
  return "";
}

Arguments
ParseArguments(const ModuleDescription & module, const std::vector<std::string> & arguments)
{
  return Parser(module, arguments).Parse();
}
} // namespace shapeton
