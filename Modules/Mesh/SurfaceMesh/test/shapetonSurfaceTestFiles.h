#ifndef shapetonSurfaceTestFiles_h
#define shapetonSurfaceTestFiles_h

#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"
#include "shapetonSurfaceReader.h"
#include "shapetonExceptions.h"

#include <string>

namespace testsurfaces
{
using basetest::Folder;

/** Reads bytes as a surface file with this extension. */
inline shapeton::SurfaceFile
ReadBytes(const std::string & extension, const std::string & bytes)
{
  const Folder      folder;
  const std::string path = folder / ("surface." + extension);
  shapeton::WriteFileBytes(path, bytes);
  return shapeton::ReadSurfaceFile(path);
}

/** Message of the InputError thrown for these bytes, without the file name; empty if nothing is thrown. */
inline std::string
FaultOf(const std::string & extension, const std::string & bytes)
{
  try
  {
    ReadBytes(extension, bytes);
  }
  catch (const shapeton::InputError & error)
  {
    const std::string message = error.what();
    const auto        end = message.find("\": ");
    return end == std::string::npos ? message : message.substr(end + 3);
  }
  return "";
}
} // namespace testsurfaces

#endif
