#ifndef ToolXMLGrammar_h
#define ToolXMLGrammar_h

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rules
{
using Names = std::set<std::string>;
/** Attribute to its values; an empty set allows any value. */
using Attributes = std::map<std::string, Names>;

extern const Names Booleans;

/** What Slicer's parser reads of each kind of parameter. An attribute it ignores is a mistake as well. */
const std::map<std::string, Attributes> &
ParameterKinds();

/** "double-vector" to "double". */
std::string
ElementKind(const std::string & kind);

/** "double-vector", "integer". */
bool
IsNumeric(const std::string & kind);

bool
IsVector(const std::string & kind);

bool
IsEnumeration(const std::string & kind);

/** A value of a command line, not a file or a point. */
bool
IsSimple(const std::string & kind);

bool
IsCamelCase(const std::string & text);

/** The whole text as a number of that kind. */
std::optional<double>
ToNumber(const std::string & text, const std::string & kind);

/** At commas. */
std::vector<std::string>
Split(const std::string & text);

/** "a, b". */
std::string
Join(const Names & names);
} // namespace rules

#endif
