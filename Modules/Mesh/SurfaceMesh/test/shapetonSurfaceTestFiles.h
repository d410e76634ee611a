#ifndef shapetonSurfaceTestFiles_h
#define shapetonSurfaceTestFiles_h

#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"
#include "shapetonSurfaceReader.h"

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

/** Message of the InputError thrown for these bytes, excluding the file name; empty if nothing is thrown. */
inline std::string
FaultOf(const std::string & extension, const std::string & bytes)
{
  const std::string message = basetest::ErrorOf([&] { ReadBytes(extension, bytes); });
  const auto        end = message.find("\": ");
  return end == std::string::npos ? message : message.substr(end + 3);
}
} // namespace testsurfaces

#endif
