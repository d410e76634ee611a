#ifndef shapetonViewerScript_h
#define shapetonViewerScript_h

#include <string>

namespace shapeton
{
/** Script and style of the page in pieces that every compiler takes as literals, ended by nullptr. CMake joins them
 * from the folder `scripts` of the module. */
extern const char * const ViewerScript[];
extern const char * const ViewerStyle[];

inline std::string
ViewerText(const char * const pieces[])
{
  std::string text;
  for (; *pieces != nullptr; ++pieces)
  {
    text += *pieces;
  }
  return text;
}
} // namespace shapeton

#endif
