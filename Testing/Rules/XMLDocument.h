#ifndef XMLDocument_h
#define XMLDocument_h

#include <string>
#include <utility>
#include <vector>

namespace rules
{
/** An XML element with its own text, trimmed, and the line on which it starts. */
struct XMLElement
{
  std::string                                      name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string                                      text;
  std::vector<XMLElement>                          children;
  int                                              line{ 0 };

  /** The first child of that name, or null. */
  const XMLElement *
  Find(const std::string & child) const;

  /** The text of the first child of that name, or nothing. */
  std::string
  TextOf(const std::string & child) const;

  /** The value of an attribute, or nothing. */
  std::string
  Attribute(const std::string & attribute) const;
};

/** Why a document is not well-formed, and where. */
struct XMLError
{
  int         line;
  std::string message;
};

/** The root element. Throws XMLError. */
XMLElement
ParseXML(const std::string & document);
} // namespace rules

#endif
