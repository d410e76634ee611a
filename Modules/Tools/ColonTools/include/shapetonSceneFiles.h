#ifndef shapetonSceneFiles_h
#define shapetonSceneFiles_h

#include "ColonToolsExport.h"

#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** \class SceneFiles
 * \brief Copies of results in a folder, each a file that a parameter names: 3D Slicer loads them as nodes of its scene,
 * which it cannot do with a folder.
 * \ingroup ColonTools
 */
class ColonTools_EXPORT SceneFiles
{
public:
  struct Choice
  {
    /** An output of the tool. */
    std::string parameter;
    /** The file in the folder; the copy has its extension. */
    std::string name;
  };

  /** Throws ParameterError where a name has another extension, OutputError where a copy cannot be written. */
  SceneFiles(CommandLine & commandLine, const std::vector<Choice> & choices);

  /** Copies the result `name`, which lies at `path`, where it is asked for. Throws OutputError. */
  void
  Copy(const std::string & name, const std::string & path) const;

  /** Copies from the folder all that are asked for. Throws OutputError. */
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
