#ifndef shapetonTestFolder_h
#define shapetonTestFolder_h

#include "shapetonTestErrors.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace basetest
{
/** A fresh folder that is removed with its contents. */
class Folder
{
public:
  Folder() : m_Path((std::filesystem::temp_directory_path() / "shapeton-test-XXXXXX").string())
  {
    if (!mkdtemp(m_Path.data()))
    {
      throw std::runtime_error("no folder for temporary files");
    }
  }
  Folder(const Folder &) = delete;
  Folder &
  operator=(const Folder &) = delete;
  ~Folder()
  {
    std::error_code error;
    std::filesystem::remove_all(m_Path, error);
  }

  std::string
  operator/(const std::string & name) const
  {
    return m_Path + '/' + name;
  }

private:
  std::string m_Path;
};

/** A fresh current folder that is removed with its contents. */
class Scratch
{
public:
  Scratch() : m_Previous(std::filesystem::current_path()), m_Path(std::filesystem::canonical(m_Folder / "."))
  {
    std::filesystem::permissions(m_Path, std::filesystem::perms(0755));
    std::filesystem::current_path(m_Path);
  }
  Scratch(const Scratch &) = delete;
  Scratch &
  operator=(const Scratch &) = delete;
  ~Scratch()
  {
    std::error_code error;
    std::filesystem::current_path(m_Previous, error);
  }

  const std::filesystem::path &
  Path() const
  {
    return m_Path;
  }

private:
  Folder                m_Folder;
  std::filesystem::path m_Previous;
  std::filesystem::path m_Path;
};
} // namespace basetest

#endif
