#ifndef shapetonGltfScene_h
#define shapetonGltfScene_h

#include "shapetonBinaryValues.h"
#include "shapetonJson.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** \name Words of a GLB file, little endian. */
///@{
constexpr std::uint32_t GlbMagic = 0x46546C67;       // "glTF"
constexpr std::uint32_t GlbJsonChunk = 0x4E4F534A;   // "JSON"
constexpr std::uint32_t GlbBinaryChunk = 0x004E4942; // "BIN"
///@}

/** Column by column: LPS in mm to the axes of glTF in meters, where a model looks along z, y is up, and x is its left.
 */
constexpr double GltfOfLps[16] = { 1e-3, 0, 0, 0, 0, 0, -1e-3, 0, 0, 1e-3, 0, 0, 0, 0, 0, 1 };

/** A nonnegative integer. Throws std::out_of_range for any other value. */
std::size_t
GltfIndex(const Json & json);

/** \class GltfScene
 * \brief Document, buffers and mesh nodes of a glTF 2.0 or GLB file.
 *
 * https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html. Throws InputError; nlohmann's exceptions and
 * std::out_of_range if required content is missing.
 */
class GltfScene
{
public:
  struct Instance
  {
    std::string     name;
    std::size_t     mesh{ 0 };
    Eigen::Matrix4d transform;
  };

  GltfScene(const std::string & bytes, const std::string & path);
  ~GltfScene();

  /** Mesh nodes of the scene, in depth-first order from its roots. */
  std::vector<Instance>
  Instances() const;

  const Json &
  Document() const
  {
    return m_Document;
  }

  /** Whether the file is from WriteSurfaceScene(): its nodes turn LPS by GltfOfLps. */
  bool
  IsTurnedLps() const;

  /** Positions of an accessor: three floats for each vertex. */
  std::vector<double>
  Positions(std::size_t accessor) const;
  /** Indices of an accessor. */
  std::vector<std::int64_t>
  Indices(std::size_t accessor) const;

private:
  struct View
  {
    const std::string * bytes;
    std::size_t         begin, stride, count;
    BinaryType          type;
  };

  void
  ReadChunks(const std::string & bytes);
  void
  ReadBuffers(const std::string & binary, bool hasBinary);
  std::string
  BufferOfUri(const std::string & uri) const;
  void
  RefuseExtensions() const;
  View
  ViewOf(std::size_t accessor, const std::string & type) const;
  void
  Visit(std::size_t             node,
        const Eigen::Matrix4d & parent,
        std::vector<bool> &     isVisited,
        std::vector<Instance> & instances,
        int                     depth) const;

  std::string              m_Path;
  Json                     m_Document;
  std::vector<std::string> m_Buffers;
};
} // namespace shapeton

#endif
