#include "ToolXMLRules.h"

#include "ParameterRules.h"
#include "ParameterSetRules.h"

namespace rules
{
namespace
{
const Names HeadElements{ "category",    "title",    "description",      "version", "documentation-url", "license",
                          "contributor", "location", "acknowledgements", "index",   "parameters" };
const Names RequiredHeadElements{ "category", "title", "version", "license", "contributor" };

void
CheckGroup(const XMLElement & group, Parameters & parameters, XMLFaults & faults)
{
  faults.CheckAttributes(group, { { "advanced", Booleans } });
  faults.RequireText(group, "label");
  faults.RequireSentence(group);
  Names kinds{ "label", "description" };
  for (const auto & kind : ParameterKinds())
  {
    kinds.insert(kind.first);
  }
  Names repeatable = kinds;
  repeatable.erase("label");
  repeatable.erase("description");
  faults.CheckChildren(group, kinds, repeatable);
  const auto before = parameters.size();
  for (const XMLElement & child : group.children)
  {
    if (repeatable.count(child.name))
    {
      parameters.push_back(&child);
      CheckParameter(child, faults);
    }
  }
  if (parameters.size() == before)
  {
    faults.Add(group.line, "<parameters> does not contain any parameter");
  }
}

void
CheckExecutable(const XMLElement & root, const std::string & version, XMLFaults & faults)
{
  if (root.name != "executable")
  {
    faults.Add(root.line, "the root element must be <executable>, not <" + root.name + ">");
    return;
  }
  faults.CheckAttributes(root, {});
  faults.CheckChildren(root, HeadElements, { "parameters" });
  for (const std::string & name : RequiredHeadElements)
  {
    faults.RequireText(root, name);
  }
  faults.RequireSentence(root);
  faults.RequireValue(root, "version", version);
  faults.RequireValue(root, "license", "Apache-2.0");
  Parameters parameters;
  for (const XMLElement & child : root.children)
  {
    if (child.name == "parameters")
    {
      CheckGroup(child, parameters, faults);
    }
  }
  CheckParameterSet(root, parameters, faults);
}
} // namespace

Faults
CheckToolXML(const std::string & xml, const std::string & file, const std::string & version)
{
  XMLFaults faults(file);
  if (xml.compare(0, 6, "<?xml ") != 0)
  {
    faults.Add(1, "must begin with <?xml version=\"1.0\" encoding=\"utf-8\"?>");
  }
  try
  {
    CheckExecutable(ParseXML(xml), version, faults);
  }
  catch (const XMLError & error)
  {
    faults.Add(error.line, "is not well-formed: " + error.message);
  }
  return faults.Get();
}
} // namespace rules
