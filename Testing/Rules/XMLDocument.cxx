#include "XMLDocument.h"

#include <expat.h>

#include <memory>

namespace rules
{
namespace
{
struct Builder
{
  XML_Parser parser;
  /** The document, then the open elements from the root down. */
  std::vector<XMLElement> open{ XMLElement{} };
};

std::string
Trim(const std::string & text)
{
  const char * const blanks = " \t\r\n";
  const auto         first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

void XMLCALL
OnStart(void * data, const char * name, const char ** attributes)
{
  auto &     builder = *static_cast<Builder *>(data);
  XMLElement element;
  element.name = name;
  element.line = static_cast<int>(XML_GetCurrentLineNumber(builder.parser));
  for (; *attributes; attributes += 2)
  {
    element.attributes.emplace_back(attributes[0], attributes[1]);
  }
  builder.open.push_back(std::move(element));
}

void XMLCALL
OnEnd(void * data, const char *)
{
  auto &     builder = *static_cast<Builder *>(data);
  XMLElement element = std::move(builder.open.back());
  element.text = Trim(element.text);
  builder.open.pop_back();
  builder.open.back().children.push_back(std::move(element));
}

void XMLCALL
OnText(void * data, const char * text, int length)
{
  static_cast<Builder *>(data)->open.back().text.append(text, length);
}
} // namespace

const XMLElement *
XMLElement::Find(const std::string & child) const
{
  for (const XMLElement & element : children)
  {
    if (element.name == child)
    {
      return &element;
    }
  }
  return nullptr;
}

std::string
XMLElement::TextOf(const std::string & child) const
{
  const XMLElement * element = this->Find(child);
  return element ? element->text : std::string();
}

std::string
XMLElement::Attribute(const std::string & attribute) const
{
  for (const auto & [name, value] : attributes)
  {
    if (name == attribute)
    {
      return value;
    }
  }
  return {};
}

XMLElement
ParseXML(const std::string & document)
{
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
  Builder                                                       builder{ parser.get() };
  XML_SetUserData(parser.get(), &builder);
  XML_SetElementHandler(parser.get(), OnStart, OnEnd);
  XML_SetCharacterDataHandler(parser.get(), OnText);
  if (XML_Parse(parser.get(), document.data(), static_cast<int>(document.size()), 1) != XML_STATUS_OK)
  {
    throw XMLError{ static_cast<int>(XML_GetCurrentLineNumber(parser.get())),
                    XML_ErrorString(XML_GetErrorCode(parser.get())) };
  }
  return builder.open.front().children.front();
}
} // namespace rules
