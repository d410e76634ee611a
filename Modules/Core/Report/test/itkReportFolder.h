#ifndef itkReportFolder_h
#define itkReportFolder_h

#include "itkToolError.h"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

namespace reporttest
{
/** A fresh folder, removed with all it holds. */
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

/** Exit status and message of the ToolError that `work` throws. */
inline std::string
MessageOf(const std::function<void()> & work)
{
  try
  {
    work();
  }
  catch (const itk::ToolError & error)
  {
    return std::to_string(error.GetExitStatus()) + ' ' + error.what();
  }
  return "no error";
}
} // namespace reporttest

#endif
