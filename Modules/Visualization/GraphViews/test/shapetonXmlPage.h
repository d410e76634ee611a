#ifndef shapetonXmlPage_h
#define shapetonXmlPage_h

#include "shapetonFileBytes.h"

#if __has_include("itk_expat.h") // in an ITK source tree
#  include "itk_expat.h"
#else
#  include <expat.h>
#endif

#include <map>
#include <string>
#include <vector>

/** The elements of an XML file by tag; fails if it is not well-formed. */
struct XmlPage
{
  using Attributes = std::map<std::string, std::string>;

  explicit XmlPage(const std::string & path) : text(shapeton::ReadFileBytes(path))
  {
    const XML_Parser parser = XML_ParserCreate("UTF-8");
    XML_SetUserData(parser, this);
    XML_SetStartElementHandler(parser, [](void * self, const XML_Char * name, const XML_Char ** attributes) {
      Attributes values;
      for (; *attributes != nullptr; attributes += 2)
      {
        values[attributes[0]] = attributes[1];
      }
      static_cast<XmlPage *>(self)->elements[name].push_back(values);
    });
    isWellFormed = XML_Parse(parser, text.data(), static_cast<int>(text.size()), 1) == XML_STATUS_OK;
    XML_ParserFree(parser);
  }

  std::size_t
  Count(const std::string & tag, const std::string & attribute, const std::string & value) const
  {
    std::size_t count = 0;
    const auto  found = elements.find(tag);
    for (std::size_t i = 0; found != elements.end() && i < found->second.size(); ++i)
    {
      const auto entry = found->second[i].find(attribute);
      count += entry != found->second[i].end() && entry->second == value ? 1 : 0;
    }
    return count;
  }

  std::string                                    text;
  std::map<std::string, std::vector<Attributes>> elements;
  bool                                           isWellFormed{ false };
};

#endif
