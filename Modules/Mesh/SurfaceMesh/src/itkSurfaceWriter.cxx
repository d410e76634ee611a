#include "itkSurfaceWriter.h"
#include "itkCommandLine.h"
#include "itkSurfaceFormats.h"
#include "itkToolError.h"

#include <map>

namespace itk
{
void
WriteSurface(const SurfaceMesh & mesh, const std::string & path)
{
  using Writer = void (*)(const SurfaceMesh &, const std::string &);
  static const std::map<std::string, Writer> writers{
    { "vtp", WriteVtp }, { "stl", WriteStl }, { "obj", WriteObj }, { "ply", WritePly }
  };
  const auto writer = writers.find(SurfaceExtension(path));
  RequireUsage(writer != writers.end(), "\"" + path + "\" names no format of a surface; use .vtp, .stl, .ply or .obj");
  RequireSound(mesh, "the surface");
  writer->second(mesh, path);
}

void
WriteSurface(const CommandLine & commandLine, SurfaceMesh mesh, const std::string & path)
{
  mesh.facts.clear();
  for (const auto & [key, value] : commandLine.GetProvenance())
  {
    mesh.facts.emplace_back("Shapeton." + key, value);
  }
  WriteSurface(mesh, path);
}
} // namespace itk
