#ifndef shapetonFileParserPath_h
#define shapetonFileParserPath_h

#include <string>

namespace shapeton
{
/** The path of the program ShapetonFileParser; see ContainedProcess. Throws std::runtime_error. */
std::string
FileParserPath();
} // namespace shapeton

#endif
