#ifndef itkSurfaceTestFiles_h
#define itkSurfaceTestFiles_h

#include "itkFileBytes.h"
#include "itkSurfaceReader.h"
#include "itkToolError.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace testsurfaces
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

/** Reads bytes as a file with this extension. */
inline itk::SurfaceFile
ReadBytes(const std::string & extension, const std::string & bytes)
{
  const Folder      folder;
  const std::string path = folder / ("surface." + extension);
  itk::WriteFileBytes(path, bytes);
  return itk::ReadSurfaceFile(path);
}

/** The message of the InputError that reading these bytes throws, without the name of the file; "" when it throws none.
 */
inline std::string
FaultOf(const std::string & extension, const std::string & bytes)
{
  try
  {
    ReadBytes(extension, bytes);
  }
  catch (const itk::InputError & error)
  {
    const std::string message = error.what();
    const auto        end = message.find("\": ");
    return end == std::string::npos ? message : message.substr(end + 3);
  }
  return "";
}
} // namespace testsurfaces

#endif
