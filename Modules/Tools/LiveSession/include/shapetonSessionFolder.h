#ifndef shapetonSessionFolder_h
#define shapetonSessionFolder_h

#include "ShapetonLiveSessionExport.h"

#include <filesystem>
#include <string>

namespace shapeton
{
/** \class SessionFolder
 * \brief The only folder in which a live session reads and writes files that its page names.
 *
 * \ingroup ShapetonLiveSession */
class ShapetonLiveSession_EXPORT SessionFolder
{
public:
  /** Throws InputError if the folder does not exist. */
  explicit SessionFolder(const std::string & path);

  /** Absolute, without symbolic links. */
  const std::filesystem::path &
  GetPath() const
  {
    return m_Path;
  }

  /** The absolute path of a relative name. Throws ParameterError for an absolute name, a part "." or "..", a control
   * character, a name of more than 255 bytes, and a part that is a symbolic link, which may point outside the folder.
   */
  std::filesystem::path
  PathOf(const std::string & name) const;

private:
  std::filesystem::path m_Path;
};
} // namespace shapeton

#endif
