#ifndef shapetonRemarks_h
#define shapetonRemarks_h

#include <string>
#include <vector>

namespace shapeton
{
/** What a user should know about a result that is no failure, such as what is missing or doubtful: one line for each. A
 * parameter is named as Exception says.
 * \ingroup Base */
using Remarks = std::vector<std::string>;

/** Puts `more` behind `remarks`. \ingroup Base */
inline void
AppendRemarks(Remarks & remarks, const Remarks & more)
{
  remarks.insert(remarks.end(), more.begin(), more.end());
}
} // namespace shapeton

#endif
