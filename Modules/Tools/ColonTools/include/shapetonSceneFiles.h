#ifndef shapetonSceneFiles_h
#define shapetonSceneFiles_h

#include "ShapetonColonToolsExport.h"

#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** \class SceneFiles
 * \brief Copies of results as single files, each named by a parameter, because 3D Slicer loads files, not folders, as
 * nodes of its scene.
 * \ingroup ShapetonColonTools
 */
class ShapetonColonTools_EXPORT SceneFiles
{
public:
  struct Choice
  {
    /** Output parameter of the tool. */
    std::string parameter;
    /** File in the folder; the copy has the same extension. */
    std::string name;
  };

  /** Throws ParameterError for a name with another extension, OutputError if a copy cannot be written. */
  SceneFiles(CommandLine & commandLine, const std::vector<Choice> & choices);

  /** Copies the result `name`, stored at `path`, if it was requested. Throws OutputError. */
  void
  Copy(const std::string & name, const std::string & path) const;

  /** Copies all requested files from the folder. Throws OutputError. */
  void
  CopyFrom(const std::string & folder) const;

private:
  struct Asked
  {
    std::string name;
    std::string copy;
  };
  std::vector<Asked> m_Asked;
};
} // namespace shapeton

#endif
