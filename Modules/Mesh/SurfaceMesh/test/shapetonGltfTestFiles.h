#ifndef shapetonGltfTestFiles_h
#define shapetonGltfTestFiles_h

#include <cstdint>
#include <cstring>
#include <string>

/** glTF and GLB files as bytes. */
namespace testsurfaces
{
/** Vertex positions and face indices of a unit tetrahedron. */
inline std::string
TetrahedronBuffer()
{
  const float         points[12] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  const std::uint16_t indices[12] = { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 };
  std::string         bytes(sizeof(points) + sizeof(indices), '\0');
  std::memcpy(bytes.data(), points, sizeof(points));
  std::memcpy(bytes.data() + sizeof(points), indices, sizeof(indices));
  return bytes;
}

/** Two nodes: an untransformed tetrahedron, and one translated by 3 m by its parent, scaled and mirrored by its own
 * transform. */
inline std::string
GltfDocument(const std::string & buffer)
{
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[)"
         R"({"mesh":0,"name":"plain"},{"translation":[3,0,0],"children":[2]},{"mesh":0,"scale":[2,2,-2]}],)"
         R"("meshes":[{"name":"tetra","primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
         R"("buffers":[{"byteLength":72)" +
         buffer + "}]}";
}

inline std::string
Chunk(const std::string & bytes, const char * kind)
{
  const auto  size = static_cast<std::uint32_t>(bytes.size());
  std::string chunk(8, '\0');
  std::memcpy(chunk.data(), &size, 4);
  std::memcpy(chunk.data() + 4, kind, 4);
  return chunk + bytes;
}

inline std::string
Glb(std::string document)
{
  document.append((4 - document.size() % 4) % 4, ' ');
  const std::string   chunks = Chunk(document, "JSON") + Chunk(TetrahedronBuffer(), "BIN\0");
  const std::uint32_t head[3] = { 0x46546C67, 2, static_cast<std::uint32_t>(12 + chunks.size()) };
  return std::string(reinterpret_cast<const char *>(head), 12) + chunks;
}
} // namespace testsurfaces

#endif
