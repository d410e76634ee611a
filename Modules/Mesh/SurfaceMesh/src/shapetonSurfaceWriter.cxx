#include "shapetonSurfaceWriter.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonExceptions.h"

#include <map>

namespace shapeton
{
void
WriteSurface(const SurfaceMesh & mesh, const std::string & path)
{
  using Writer = void (*)(const SurfaceMesh &, const std::string &);
  static const std::map<std::string, Writer> writers{
    { "vtp", WriteVtp }, { "stl", WriteStl }, { "obj", WriteObj }, { "ply", WritePly }, { "glb", WriteGlb }
  };
  const auto writer = writers.find(SurfaceExtension(path));
  RequireParameter(writer != writers.end(),
                   "\"" + path +
                     "\" does not have the extension of a surface format; use .vtp, .stl, .ply, .obj or .glb");
  RequireSound(mesh, "the surface");
  writer->second(mesh, path);
}

void
WriteSurface(SurfaceMesh mesh, const Provenance & provenance, const std::string & path)
{
  mesh.facts = ProvenanceMetadata(provenance);
  WriteSurface(mesh, path);
}
} // namespace shapeton
