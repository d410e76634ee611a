#include "shapetonBinaryValues.h"
#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonGltfScene.h"
#include "shapetonJson.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceScene.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace shapeton
{
namespace
{
/** Values of the glTF 2.0 specification. */
enum GltfConstant : unsigned int
{
  ArrayBuffer = 34962,
  ElementArrayBuffer = 34963,
  UnsignedInt = 5125,
  Float = 5126,
};

/** Roughness of the material, in [0, 1]; chosen for a soft highlight that shows the shape. */
constexpr double Roughness = 0.6;

/** Decodes a component of an sRGB color (IEC 61966-2-1), as glTF requires. */
double
LinearOf(double value)
{
  constexpr double linearEnd = 0.04045, linearSlope = 12.92, offset = 0.055, gamma = 2.4;
  return value > linearEnd ? std::pow((value + offset) / (1.0 + offset), gamma) : value / linearSlope;
}

/** The bytes of one buffer, and the document that describes them. */
class GltfWriter
{
public:
  GltfWriter()
  {
    m_Document["asset"] = { { "version", "2.0" }, { "generator", "Shapeton" }, { "extras", { { "SPACE", "LPS" } } } };
    m_Document["scene"] = 0;
    m_Document["scenes"] = Json::array({ { { "nodes", { 0 } } } });
    m_Document["nodes"] =
      Json::array({ { { "name", "LPS in mm" }, { "matrix", GltfOfLps }, { "children", Json::array() } } });
  }

  void
  Add(const SurfaceOfScene & surface)
  {
    std::vector<int> faces(static_cast<std::size_t>(surface.mesh.NumberOfFaces()));
    std::iota(faces.begin(), faces.end(), 0);
    const SurfaceMesh mesh = FacesOfSurface(surface.mesh, faces); // validators object to unused vertices
    const Json        attributes{ { "POSITION", this->AddVectors(mesh.V, true) },
                           { "NORMAL", this->AddVectors(UnitNormals(mesh), false) } };
    const Json        primitive{ { "attributes", attributes },
                          { "indices", this->AddIndices(mesh.F) },
                          { "material", m_Document["materials"].size() } };
    const Json        color{ LinearOf(surface.color[0]), LinearOf(surface.color[1]), LinearOf(surface.color[2]), 1.0 };
    m_Document["materials"].push_back(
      { { "name", surface.name },
        { "pbrMetallicRoughness",
          { { "baseColorFactor", color }, { "metallicFactor", 0.0 }, { "roughnessFactor", Roughness } } } });
    m_Document["nodes"][0]["children"].push_back(m_Document["nodes"].size());
    m_Document["nodes"].push_back({ { "name", surface.name }, { "mesh", m_Document["meshes"].size() } });
    m_Document["meshes"].push_back({ { "name", surface.name }, { "primitives", Json::array({ primitive }) } });
  }

  void
  Write(const std::string & path)
  {
    m_Document["buffers"] = Json::array({ { { "byteLength", m_Bytes.size() } } });
    const std::string document = m_Document.dump();
    const std::string chunks = Chunk(document, ' ', GlbJsonChunk) + Chunk(m_Bytes, '\0', GlbBinaryChunk);
    std::string       file;
    AppendValue(file, GlbMagic);
    AppendValue(file, std::uint32_t{ 2 });
    constexpr std::size_t header = 12; // bytes
    if (chunks.size() > std::numeric_limits<std::uint32_t>::max() - header)
    {
      throw OutputError('"' + path + "\" would be larger than 4 GB, the limit of the format; write VTP files");
    }
    AppendValue(file, static_cast<std::uint32_t>(chunks.size() + header));
    WriteFileBytes(path, file + chunks);
  }

private:
  /** Unit vectors, because validators object to others. */
  static VertexMatrix
  UnitNormals(const SurfaceMesh & mesh)
  {
    VertexMatrix normals = VertexNormals(mesh.V, mesh.F);
    for (Eigen::Index i = 0; i < normals.rows(); ++i)
    {
      if (normals.row(i).isZero(0.0))
      {
        normals.row(i) = Eigen::RowVector3d::UnitZ(); // its faces have no area
      }
    }
    return normals;
  }

  static std::string
  Chunk(std::string bytes, char padding, std::uint32_t kind)
  {
    bytes.append((4 - bytes.size() % 4) % 4, padding);
    std::string head;
    AppendValue(head, static_cast<std::uint32_t>(bytes.size()));
    AppendValue(head, kind);
    return head + bytes;
  }

  /** Adds the accessor of the bytes after `begin`. */
  std::size_t
  AddAccessor(std::size_t begin, GltfConstant target, Json accessor)
  {
    accessor["bufferView"] = m_Document["bufferViews"].size();
    m_Document["bufferViews"].push_back(
      { { "buffer", 0 }, { "byteOffset", begin }, { "byteLength", m_Bytes.size() - begin }, { "target", target } });
    m_Document["accessors"].push_back(std::move(accessor));
    return m_Document["accessors"].size() - 1;
  }

  std::size_t
  AddVectors(const VertexMatrix & vectors, bool withExtent)
  {
    using FloatMatrix = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
    const FloatMatrix values = vectors.cast<float>();
    const std::size_t begin = m_Bytes.size();
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      AppendValue(m_Bytes, values.data()[i]);
    }
    Json accessor{ { "componentType", Float }, { "count", values.rows() }, { "type", "VEC3" } };
    if (withExtent)
    {
      const Eigen::RowVector3f least = values.colwise().minCoeff(), greatest = values.colwise().maxCoeff();
      accessor["min"] = { least[0], least[1], least[2] };
      accessor["max"] = { greatest[0], greatest[1], greatest[2] };
    }
    return this->AddAccessor(begin, ArrayBuffer, accessor);
  }

  std::size_t
  AddIndices(const FaceMatrix & F)
  {
    const std::size_t begin = m_Bytes.size();
    for (Eigen::Index f = 0; f < F.rows(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        AppendValue(m_Bytes, static_cast<std::uint32_t>(F(f, k)));
      }
    }
    return this->AddAccessor(
      begin, ElementArrayBuffer, { { "componentType", UnsignedInt }, { "count", F.size() }, { "type", "SCALAR" } });
  }

  Json        m_Document;
  std::string m_Bytes;
};
} // namespace

void
WriteSurfaceScene(const std::vector<SurfaceOfScene> & surfaces, const std::string & path)
{
  RequireParameter(SurfaceExtension(path) == "glb", '"' + path + "\" does not have the extension of a scene; use .glb");
  GltfWriter writer;
  for (const SurfaceOfScene & surface : surfaces)
  {
    RequireSound(surface.mesh, "the surface \"" + surface.name + '"');
    if (surface.mesh.NumberOfFaces() == 0)
    {
      throw InputError("the surface \"" + surface.name + "\" has no face");
    }
    writer.Add(surface);
  }
  writer.Write(path);
}

void
WriteGlb(const SurfaceMesh & mesh, const std::string & path)
{
  SurfaceOfScene surface;
  surface.name = "surface";
  surface.mesh = mesh;
  WriteSurfaceScene({ surface }, path);
}
} // namespace shapeton
