#ifndef shapetonJsonForward_h
#define shapetonJsonForward_h

#include <nlohmann/json_fwd.hpp>

namespace shapeton
{
/** A JSON document that keeps the order of its keys. Headers include this file, which declares it; what looks into a
 * document includes shapetonJson.h, which takes a second more to compile.
 * \ingroup Report */
using Json = nlohmann::ordered_json;
} // namespace shapeton

#endif
