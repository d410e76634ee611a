#include "ParameterSetRules.h"

#include "ParameterRules.h"

#include <algorithm>

namespace rules
{
namespace
{
void
CheckUniqueness(const Parameters & parameters, XMLFaults & faults)
{
  Names names;
  Names flags;
  for (const XMLElement * parameter : parameters)
  {
    if (!names.insert(parameter->TextOf("name")).second)
    {
      faults.Add(parameter->line, NameOf(*parameter) + ": the name is taken");
    }
    if (parameter->Find("flag") && !flags.insert(parameter->TextOf("flag")).second)
    {
      faults.Add(parameter->line, NameOf(*parameter) + ": <flag> " + parameter->TextOf("flag") + " is taken");
    }
  }
}

/** Indices must be consecutive and start at 0; only the last positional argument may take several values. */
void
CheckPositions(const Parameters & parameters, XMLFaults & faults)
{
  std::map<int, const XMLElement *> positions;
  for (const XMLElement * parameter : parameters)
  {
    if (!parameter->Find("index"))
    {
      continue;
    }
    const int index = static_cast<int>(ToNumber(parameter->TextOf("index"), "integer").value_or(-1));
    if (!positions.emplace(index, parameter).second)
    {
      faults.Add(parameter->line, NameOf(*parameter) + ": <index> " + std::to_string(index) + " is taken");
    }
  }
  int expected = 0;
  for (const auto & [index, parameter] : positions)
  {
    if (index != expected++)
    {
      faults.Add(parameter->line, NameOf(*parameter) + ": the indices must be consecutive and start at 0");
      return;
    }
    if (parameter->Attribute("multiple") == "true" && expected != static_cast<int>(positions.size()))
    {
      faults.Add(parameter->line, NameOf(*parameter) + ": only the last positional argument may be multiple");
    }
  }
}

void
CheckReferences(const Parameters & parameters, XMLFaults & faults)
{
  Names names;
  for (const XMLElement * parameter : parameters)
  {
    names.insert(parameter->TextOf("name"));
  }
  const auto check = [&](const XMLElement & place, const std::string & name) {
    if (!name.empty() && !names.count(name))
    {
      faults.Add(place.line, "the reference to \"" + name + "\" does not match any parameter");
    }
  };
  for (const XMLElement * parameter : parameters)
  {
    check(*parameter, parameter->Attribute("reference"));
    for (const XMLElement & child : parameter->children)
    {
      if (child.name == "reference")
      {
        faults.CheckAttributes(child, { { "role", {} }, { "parameter", {} } });
        check(child, child.Attribute("parameter"));
      }
    }
  }
}

const XMLElement *
FindParameter(const Parameters & parameters, const std::string & name)
{
  const auto found = std::find_if(parameters.begin(), parameters.end(), [&](const XMLElement * parameter) {
    return parameter->TextOf("name") == name;
  });
  return found == parameters.end() ? nullptr : *found;
}

void
CheckThreads(const XMLElement & root, const Parameters & parameters, XMLFaults & faults)
{
  const XMLElement * threads = FindParameter(parameters, "threads");
  if (!threads)
  {
    faults.Add(root.line, "the option threads is missing");
  }
  else if (threads->name != "integer" || threads->TextOf("default") != "0" || !threads->Find("longflag") ||
           LimitOf(*threads, "minimum") != 0.0)
  {
    faults.Add(threads->line, "threads must be an <integer> option with the default 0 and the minimum 0");
  }
}

/** A tool that has an input of this kind, or one of these options, must have all of the options. A tool that refers to
 * the slices of a series selects it by seriesUID; it may move its slices by deshear, but not add or drop slices. */
void
CheckInputOptions(const XMLElement &                         root,
                  const Parameters &                         parameters,
                  const std::string &                        element,
                  const std::string &                        what,
                  const std::map<std::string, std::string> & options,
                  XMLFaults &                                faults)
{
  const auto takesIt = [&](const XMLElement * parameter) {
    const std::string name = parameter->TextOf("name");
    return (options.count(name) && name != "seriesUID" && name != "deshear") ||
           (parameter->name == element && parameter->TextOf("channel") == "input");
  };
  if (std::none_of(parameters.begin(), parameters.end(), takesIt))
  {
    return;
  }
  for (const auto & [name, kind] : options)
  {
    const XMLElement * parameter = FindParameter(parameters, name);
    if (!parameter)
    {
      faults.Add(root.line, "a tool that takes a " + what + " must have the option " + name);
    }
    else if (parameter->name != kind || !parameter->Find("longflag"))
    {
      faults.Add(parameter->line, name + " must be a <" + kind + "> option");
    }
  }
}

/** A tool that reads a volume must have the options to select the series and to repair it. */
void
CheckVolumeOptions(const XMLElement & root, const Parameters & parameters, XMLFaults & faults)
{
  CheckInputOptions(root,
                    parameters,
                    "image",
                    "volume",
                    { { "seriesUID", "string" },
                      { "resampleGaps", "boolean" },
                      { "deshear", "boolean" },
                      { "dropDuplicates", "boolean" } },
                    faults);
}

/** A tool that reads a surface must have the options to select part, component and unit. */
void
CheckSurfaceOptions(const XMLElement & root, const Parameters & parameters, XMLFaults & faults)
{
  CheckInputOptions(root,
                    parameters,
                    "geometry",
                    "surface",
                    { { "part", "string" }, { "component", "integer" }, { "unit", "string-enumeration" } },
                    faults);
}
} // namespace

void
CheckParameterSet(const XMLElement & root, const Parameters & parameters, XMLFaults & faults)
{
  CheckUniqueness(parameters, faults);
  CheckPositions(parameters, faults);
  CheckReferences(parameters, faults);
  CheckThreads(root, parameters, faults);
  CheckVolumeOptions(root, parameters, faults);
  CheckSurfaceOptions(root, parameters, faults);
}
} // namespace rules
