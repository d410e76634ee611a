#ifndef shapetonOutputFiles_h
#define shapetonOutputFiles_h

#include "shapetonOperatingSystem.h"

#include <filesystem>
#include <list>
#include <set>
#include <string>
#include <vector>

namespace shapeton
{
/** The files that a tool writes: temporary until Commit() renames them. Uncommitted files are removed by the
 * destructor and by the handlers of termination signals. */
class OutputFiles
{
public:
  OutputFiles();
  OutputFiles(const OutputFiles &) = delete;
  OutputFiles &
  operator=(const OutputFiles &) = delete;
  ~OutputFiles();

  /** Temporary name for a final path, whose folder is created if it is missing. Throws OutputError if the final path
   * cannot be written to. */
  std::string
  Add(const std::string & path);

  /** The message with temporary names replaced by the paths from the command line. */
  std::string
  InFinalNames(std::string message) const;

  /** Creates a folder and its parents. */
  void
  MakeFolder(const std::string & path);
  /** Creates the parents of a file or folder. */
  void
  MakeParentFolder(const std::string & path);

  /** Syncs one file to disk and renames it to its final name; its path may be added again. Throws OutputError. */
  void
  Publish(const std::string & path);

  /** Syncs the files to disk and renames them to their final names. Throws OutputError. */
  void
  Commit();

  /** The HTML pages renamed to their final names so far. */
  const std::set<std::string> &
  GetPages() const
  {
    return m_Pages;
  }

private:
  struct File
  {
    std::string           path; ///< as on the command line
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
  void
  Rename(const File & file);

  std::list<File>                 m_Files;
  std::size_t                     m_Added{ 0 };
  std::vector<Folder>             m_Folders; // created by this run, parents first
  std::set<std::filesystem::path> m_TidyFolders;
  std::set<std::string>           m_Pages;
};
} // namespace shapeton

#endif
