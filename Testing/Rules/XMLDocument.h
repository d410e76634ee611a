#ifndef XMLDocument_h
#define XMLDocument_h

#include <string>
#include <utility>
#include <vector>

namespace rules
{
/** An XML element with its trimmed text and its first line. */
struct XMLElement
{
  std::string                                      name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string                                      text;
  std::vector<XMLElement>                          children;
  int                                              line{ 0 };

  /** Returns the first child of that name, or null. */
  const XMLElement *
  Find(const std::string & child) const;

  /** Returns the text of the first child of that name, or an empty string. */
  std::string
  TextOf(const std::string & child) const;

  /** Returns the value of an attribute, or an empty string. */
  std::string
  Attribute(const std::string & attribute) const;
};

/** Syntax error of a document and its position. */
struct XMLError
{
  int         line;
  std::string message;
};

/** Parses a document and returns the root element. Throws XMLError. */
XMLElement
ParseXML(const std::string & document);
} // namespace rules

#endif
