#ifndef shapetonJsonForward_h
#define shapetonJsonForward_h

#include <nlohmann/json_fwd.hpp>

namespace shapeton
{
/** A JSON document that keeps the order of its keys. Headers include this forward declaration; code that accesses a
 * document includes shapetonJson.h, which is slow to compile.
 * \ingroup ShapetonReport */
using Json = nlohmann::ordered_json;
} // namespace shapeton

#endif
