#ifndef shapetonOutputFiles_h
#define shapetonOutputFiles_h

#include "shapetonRemovalAtDeath.h"

#include <filesystem>
#include <list>
#include <set>
#include <string>
#include <vector>

namespace shapeton
{
/** The files that a tool writes: temporary until Commit() renames all of them. What is not committed is removed by the
 * destructor, and by the handlers of the signals that end a program. */
class OutputFiles
{
public:
  OutputFiles();
  OutputFiles(const OutputFiles &) = delete;
  OutputFiles &
  operator=(const OutputFiles &) = delete;
  ~OutputFiles();

  /** The temporary name for a final path. Throws OutputError when nothing can be written there. */
  std::string
  Add(const std::string & path);

  /** A message with the paths as the user wrote them in place of temporary names. */
  std::string
  InFinalNames(std::string message) const;

  /** Makes a folder and its parents. */
  void
  MakeFolder(const std::string & path);

  /** Makes one file durable and gives it its final name now; its path may be added again. Throws OutputError. */
  void
  Publish(const std::string & path);

  /** Makes the files durable and gives them their final names. Throws OutputError. */
  void
  Commit();

private:
  struct File
  {
    std::string           path; ///< as the user wrote it
    std::filesystem::path target;
    std::string           temporary;
    RemovalAtDeath        removal;
  };
  struct Folder
  {
    std::filesystem::path path;
    RemovalAtDeath        removal;
  };

  void
  RemoveLeftovers(const std::filesystem::path & folder);
  static void
  Finish(const File & file);
  static void
  Rename(const File & file);

  std::list<File>                 m_Files;
  std::size_t                     m_Added{ 0 };
  std::vector<Folder>             m_Folders; // made by us, parents first
  std::set<std::filesystem::path> m_TidyFolders;
};
} // namespace shapeton

#endif
