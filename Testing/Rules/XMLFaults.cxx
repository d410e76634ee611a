#include "XMLFaults.h"

namespace rules
{
std::string
NameOf(const XMLElement & element)
{
  const std::string name = element.TextOf("name");
  return name.empty() ? "<" + element.name + ">" : "<" + element.name + "> " + name;
}

void
XMLFaults::CheckAttributes(const XMLElement & element, const Attributes & allowed)
{
  for (const auto & [name, value] : element.attributes)
  {
    const auto known = allowed.find(name);
    if (known == allowed.end())
    {
      this->Add(element.line, "<" + element.name + "> has no attribute \"" + name + "\"");
    }
    else if (!known->second.empty() && !known->second.count(value))
    {
      this->Add(element.line,
                "attribute \"" + name + "\" of <" + element.name + "> is \"" + value + "\", not one of " +
                  Join(known->second));
    }
  }
}

void
XMLFaults::CheckChildren(const XMLElement & element, const Names & allowed, const Names & repeatable)
{
  if (!element.text.empty())
  {
    this->Add(element.line, "<" + element.name + "> contains unexpected text \"" + element.text + "\"");
  }
  Names seen;
  for (const XMLElement & child : element.children)
  {
    if (!allowed.count(child.name))
    {
      this->Add(child.line, "<" + child.name + "> is not allowed in <" + element.name + ">");
    }
    else if (!seen.insert(child.name).second && !repeatable.count(child.name))
    {
      this->Add(child.line, "<" + child.name + "> appears twice in <" + element.name + ">");
    }
    const bool isLeaf =
      !ParameterKinds().count(child.name) && child.name != "parameters" && child.name != "constraints";
    if (isLeaf && !child.children.empty())
    {
      this->Add(child.line, "<" + child.name + "> contains elements where only text is allowed");
    }
    if (isLeaf && child.name != "reference")
    {
      this->CheckAttributes(child, {}); // shapeton::CommandLine reads no alias of a flag
    }
  }
}

void
XMLFaults::RequireText(const XMLElement & element, const std::string & child)
{
  if (element.TextOf(child).empty())
  {
    this->Add(element.line, NameOf(element) + " lacks <" + child + ">");
  }
}

void
XMLFaults::RequireSentence(const XMLElement & element)
{
  this->RequireText(element, "description");
  const std::string text = element.TextOf("description");
  if (!text.empty() && text.back() != '.')
  {
    this->Add(element.line, "the <description> of " + NameOf(element) + " must end with a period");
  }
}

void
XMLFaults::RequireValue(const XMLElement & element, const std::string & child, const std::string & value)
{
  const std::string text = element.TextOf(child);
  if (!text.empty() && text != value)
  {
    this->Add(element.Find(child)->line, "<" + child + "> is \"" + text + "\", must be \"" + value + "\"");
  }
}
} // namespace rules
