#include "shapetonModuleDescription.h"
#include "shapetonParameterValue.h"

#if __has_include("itk_expat.h") // in an ITK source tree
#  include "itk_expat.h"
#else
#  include <expat.h>
#endif

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>

namespace shapeton
{
namespace
{
using Parameter = ModuleDescription::Parameter;

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool
StartsWith(const std::string & text, const std::string & start)
{
  return text.compare(0, start.size(), start) == 0;
}

std::string
Trim(const std::string & text)
{
  const char * const blanks = " \t\r\n";
  const auto         first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string
WithoutHyphens(const std::string & text)
{
  return text.substr(std::min(text.find_first_not_of('-'), text.size()));
}

/** State of the expat parser. */
struct Reader
{
  ModuleDescription        module;
  Parameter                parameter;
  std::string              group;
  std::vector<std::string> path;
  std::string              text;

  // executable / parameters / <tag> / <child>
  bool
  InParameter() const
  {
    return path.size() >= 3 && path[1] == "parameters" && path[2] != "label" && path[2] != "description";
  }

  void
  SetHead(const std::string & tag, const std::string & value)
  {
    const std::map<std::string, std::string *> heads = { { "title", &module.title },
                                                         { "description", &module.description },
                                                         { "version", &module.version },
                                                         { "documentation-url", &module.documentationUrl } };
    if (const auto head = heads.find(tag); head != heads.end())
    {
      *head->second = value;
    }
  }

  void
  SetField(const std::string & tag, const std::string & value)
  {
    const std::map<std::string, std::string *> fields = {
      { "name", &parameter.name },       { "description", &parameter.description },
      { "flag", &parameter.flag },       { "longflag", &parameter.longflag },
      { "channel", &parameter.channel }, { "default", &parameter.defaultValue },
      { "minimum", &parameter.minimum }, { "maximum", &parameter.maximum }
    };
    if (tag == "element")
    {
      parameter.elements.push_back(value);
    }
    else if (tag == "index")
    {
      parameter.index = std::stoi(value);
    }
    else if (const auto field = fields.find(tag); field != fields.end())
    {
      *field->second = tag == "flag" || tag == "longflag" ? WithoutHyphens(value) : value;
    }
  }
};

void XMLCALL
OnStart(void * data, const char * tag, const char ** attributes)
{
  auto & reader = *static_cast<Reader *>(data);
  reader.path.emplace_back(tag);
  reader.text.clear();
  if (reader.path.size() == 3 && reader.InParameter())
  {
    reader.parameter = {};
    reader.parameter.tag = tag;
    reader.parameter.group = reader.group;
    for (; *attributes; attributes += 2)
    {
      reader.parameter.multiple |= !std::strcmp(attributes[0], "multiple") && !std::strcmp(attributes[1], "true");
      if (!std::strcmp(attributes[0], "fileExtensions"))
      {
        reader.parameter.extensions = SplitAtCommas(attributes[1]);
      }
    }
  }
}

void XMLCALL
OnEnd(void * data, const char * tag)
{
  auto &            reader = *static_cast<Reader *>(data);
  const std::string value = Trim(reader.text);
  reader.text.clear();
  if (reader.path.size() == 2)
  {
    reader.SetHead(tag, value);
  }
  else if (reader.path.size() == 3 && reader.InParameter())
  {
    if (reader.parameter.name.empty())
    {
      reader.parameter.name = reader.parameter.longflag;
    }
    reader.module.parameters.push_back(reader.parameter);
  }
  else if (reader.path.size() == 3 && reader.path[2] == "label")
  {
    reader.group = value;
  }
  else if (reader.path.size() > 3 && reader.InParameter())
  {
    reader.SetField(tag, value);
  }
  reader.path.pop_back();
}

void XMLCALL
OnText(void * data, const char * text, int length)
{
  static_cast<Reader *>(data)->text.append(text, length);
}
} // namespace

bool
Parameter::IsVector() const
{
  return EndsWith(tag, "-vector") || this->IsPoint();
}

bool
Parameter::IsInteger() const
{
  return StartsWith(tag, "integer");
}

bool
Parameter::IsPoint() const
{
  return tag == "point";
}

bool
Parameter::IsNumeric() const
{
  return this->IsInteger() || this->IsPoint() || StartsWith(tag, "double") || StartsWith(tag, "float");
}

bool
Parameter::IsPath() const
{
  const char * const tags[] = { "image",       "geometry",  "transform", "table",
                                "measurement", "pointfile", "file",      "directory" };
  return std::find(std::begin(tags), std::end(tags), tag) != std::end(tags);
}

std::string
Parameter::Display() const
{
  if (!longflag.empty())
  {
    return "--" + longflag;
  }
  return flag.empty() ? name : '-' + flag;
}

std::vector<const Parameter *>
ModuleDescription::Positionals() const
{
  std::vector<const Parameter *> positionals;
  for (const auto & parameter : parameters)
  {
    if (parameter.IsPositional())
    {
      positionals.push_back(&parameter);
    }
  }
  std::sort(positionals.begin(), positionals.end(), [](auto * a, auto * b) { return a->index < b->index; });
  return positionals;
}

ModuleDescription
ParseModuleDescription(const char * xml)
{
  Reader                                                        reader;
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
  XML_SetUserData(parser.get(), &reader);
  XML_SetElementHandler(parser.get(), OnStart, OnEnd);
  XML_SetCharacterDataHandler(parser.get(), OnText);
  if (XML_Parse(parser.get(), xml, static_cast<int>(std::strlen(xml)), 1) != XML_STATUS_OK)
  {
    throw std::logic_error(std::string("malformed module description: ") +
                           XML_ErrorString(XML_GetErrorCode(parser.get())));
  }
  return reader.module;
}
} // namespace shapeton
