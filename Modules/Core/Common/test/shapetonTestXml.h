#ifndef shapetonTestXml_h
#define shapetonTestXml_h

#if __has_include("itk_expat.h") // in an ITK source tree
#  include "itk_expat.h"
#else
#  include <expat.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace basetest
{
struct XmlElement
{
  std::string                        tag;
  std::map<std::string, std::string> attributes;
  std::string                        text; ///< text without that of its children
};

/** A page or picture as parsed by a strict browser; fails if it is not well-formed. */
struct XmlPage
{
  explicit XmlPage(const std::string & content) : bytes(content)
  {
    const XML_Parser parser = XML_ParserCreate("UTF-8");
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
      parser,
      [](void * page, const char * tag, const char ** attributes) {
        auto & here = *static_cast<XmlPage *>(page);
        here.open.push_back(here.elements.size());
        here.elements.push_back({ tag, {}, {} });
        for (; *attributes; attributes += 2)
        {
          here.elements.back().attributes[attributes[0]] = attributes[1];
        }
      },
      [](void * page, const char *) { static_cast<XmlPage *>(page)->open.pop_back(); });
    XML_SetCharacterDataHandler(parser, [](void * page, const char * text, int size) {
      auto & here = *static_cast<XmlPage *>(page);
      here.elements[here.open.back()].text.append(text, size);
    });
    const auto status = XML_Parse(parser, bytes.data(), static_cast<int>(bytes.size()), 1);
    EXPECT_EQ(status, XML_STATUS_OK) << XML_ErrorString(XML_GetErrorCode(parser)) << " in line "
                                     << XML_GetCurrentLineNumber(parser) << " of:\n"
                                     << bytes.substr(0, 300);
    XML_ParserFree(parser);
  }

  /** The text of each element of a tag. */
  std::vector<std::string>
  TextsOf(const std::string & tag) const
  {
    std::vector<std::string> texts;
    for (const auto & element : elements)
    {
      if (element.tag == tag)
      {
        texts.push_back(element.text);
      }
    }
    return texts;
  }

  /** How many elements of a tag have this attribute. */
  std::size_t
  Count(const std::string & tag, const std::string & attribute, const std::string & value) const
  {
    return static_cast<std::size_t>(std::count_if(elements.begin(), elements.end(), [&](const XmlElement & element) {
      const auto found = element.attributes.find(attribute);
      return element.tag == tag && found != element.attributes.end() && found->second == value;
    }));
  }

  std::string              bytes;
  std::vector<XmlElement>  elements; ///< in the order of their start tags
  std::vector<std::size_t> open;
};
} // namespace basetest

#endif
