#ifndef shapetonRemarks_h
#define shapetonRemarks_h

#include <string>
#include <vector>

namespace shapeton
{
/** Remarks for the user about a result, one line each, such as missing or doubtful findings. Parameters are named as
 * described in Exception.
 * \ingroup ShapetonCommon */
using Remarks = std::vector<std::string>;

/** Appends `more` to `remarks`. \ingroup ShapetonCommon */
inline void
AppendRemarks(Remarks & remarks, const Remarks & more)
{
  remarks.insert(remarks.end(), more.begin(), more.end());
}
} // namespace shapeton

#endif
