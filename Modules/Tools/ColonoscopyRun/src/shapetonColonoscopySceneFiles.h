#ifndef shapetonColonoscopySceneFiles_h
#define shapetonColonoscopySceneFiles_h

#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** Copies of results that parameters ask for, each a file of its own: 3D Slicer loads them as nodes of its scene, which
 * it cannot do with a folder. */
class ColonoscopySceneFiles
{
public:
  /** Throws ParameterError where a file cannot hold what is asked for, OutputError where one cannot be written. */
  explicit ColonoscopySceneFiles(CommandLine & commandLine);

  /** From the folder of the results; throws OutputError. */
  void
  Copy(const std::string & folder) const;

private:
  struct File
  {
    std::string source, copy;
  };
  std::vector<File> m_Files;
};
} // namespace shapeton

#endif
