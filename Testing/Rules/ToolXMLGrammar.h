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
/** Allowed values of each attribute; an empty set allows any value. */
using Attributes = std::map<std::string, Names>;

extern const Names Booleans;

/** Attributes that Slicer's parser reads for each kind of parameter. Other attributes are faults. */
const std::map<std::string, Attributes> &
ParameterKinds();

/** Element type of a parameter kind: "double" for "double-vector". */
std::string
ElementKind(const std::string & kind);

/** Whether the kind is numeric, such as "double-vector" or "integer". */
bool
IsNumeric(const std::string & kind);

bool
IsVector(const std::string & kind);

bool
IsEnumeration(const std::string & kind);

/** Whether the kind is a plain value, not a file or a point. */
bool
IsSimple(const std::string & kind);

bool
IsCamelCase(const std::string & text);

/** Parses the whole text as a number of that kind. */
std::optional<double>
ToNumber(const std::string & text, const std::string & kind);

/** Splits the text at commas. */
std::vector<std::string>
Split(const std::string & text);

/** Joins the names as "a, b". */
std::string
Join(const Names & names);
} // namespace rules

#endif
