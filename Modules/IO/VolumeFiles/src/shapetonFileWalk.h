#ifndef shapetonFileWalk_h
#define shapetonFileWalk_h

#include <string>
#include <vector>

namespace shapeton
{
/** The regular files below a folder, sorted, or the file itself. Symbolic links are followed; a file or folder
 * reached by several paths is listed once. Throws InputError if a file or folder cannot be read. */
std::vector<std::string>
ListFiles(const std::string & path);
} // namespace shapeton

#endif
