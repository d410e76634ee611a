#ifndef shapetonOutputPath_h
#define shapetonOutputPath_h

#include <functional>
#include <string>

namespace shapeton
{
/** Maps the final path of a file to the path to write to, for example a temporary one.
 * \ingroup ShapetonCommon */
using OutputPath = std::function<std::string(const std::string &)>;
} // namespace shapeton

#endif
