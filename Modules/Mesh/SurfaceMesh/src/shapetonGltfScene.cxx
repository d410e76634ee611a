#include "shapetonGltfScene.h"
#include "shapetonPrintable.h"
#include "shapetonFileBytes.h"
#include "shapetonJson.h"
#include "shapetonSurfaceFormats.h"

#include <Eigen/Geometry>

#include <cctype>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr int DeepestNode = 1000; // levels; chosen, bounds the recursion for malformed files

const char * const Truncated = "truncated: the file ends within its data";
const char * const Again = "copy or write the file again";

std::string
DecodePercents(const std::string & text)
{
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isCode = text[i] == '%' && i + 2 < text.size() &&
                        std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
                        std::isxdigit(static_cast<unsigned char>(text[i + 2]));
    decoded += isCode ? static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16)) : text[i];
    i += isCode ? 2 : 0;
  }
  return decoded;
}

std::size_t
SizeOr(const Json & json, const char * key, std::size_t missing)
{
  return json.contains(key) ? GltfIndex(json.at(key)) : missing;
}

Eigen::Matrix4d
TransformOf(const Json & node)
{
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  if (node.contains("matrix"))
  {
    for (int i = 0; i < 16; ++i)
    {
      transform(i % 4, i / 4) = node.at("matrix").at(i).get<double>(); // column by column
    }
    return transform;
  }
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
  const auto      vectorOf = [&](const char * key) {
    const Json & v = node.at(key);
    return Eigen::Vector3d(v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>());
  };
  if (node.contains("translation"))
  {
    affine.translate(vectorOf("translation"));
  }
  if (node.contains("rotation"))
  {
    const Eigen::Vector3d xyz = vectorOf("rotation");
    affine.rotate(Eigen::Quaterniond(node.at("rotation").at(3).get<double>(), xyz[0], xyz[1], xyz[2]).normalized());
  }
  if (node.contains("scale"))
  {
    affine.scale(vectorOf("scale"));
  }
  return affine.matrix();
}
} // namespace

std::size_t
GltfIndex(const Json & json)
{
  if (!json.is_number_unsigned())
  {
    throw std::out_of_range(json.dump().substr(0, LongestExcerpt) + " is not a nonnegative integer");
  }
  return json.get<std::size_t>();
}

GltfScene::GltfScene(const std::string & bytes, const std::string & path) : m_Path(path)
{
  this->ReadChunks(bytes);
  if (m_Document.at("asset").at("version").get<std::string>().compare(0, 2, "2.") != 0)
  {
    RefuseSurface(path, "its version of glTF is not 2", "write it as glTF 2.0");
  }
  this->RefuseExtensions();
}

GltfScene::~GltfScene() = default;

bool
GltfScene::IsTurnedLps() const
{
  const Json extras = m_Document.at("asset").value("extras", Json::object());
  return extras.is_object() && extras.value("SPACE", Json()) == "LPS";
}

void
GltfScene::RefuseExtensions() const
{
  for (const Json & extension : m_Document.value("extensionsRequired", Json::array()))
  {
    const auto name = extension.get<std::string>();
    for (const char * const refused : { "draco", "meshopt", "quantization" })
    {
      if (name.find(refused) != std::string::npos)
      {
        RefuseSurface(m_Path, "its meshes are compressed (" + name + ")", "write it without compression");
      }
    }
  }
}

void
GltfScene::ReadChunks(const std::string & bytes)
{
  std::string document = bytes;
  std::string binary;
  bool        hasBinary = false;
  if (bytes.size() >= 4 && ValueAt<std::uint32_t>(bytes, 0) == GlbMagic)
  {
    constexpr std::size_t headers = 20; // bytes of the file header and the first chunk header
    if (bytes.size() < headers || ValueAt<std::uint32_t>(bytes, 8) > bytes.size())
    {
      RefuseSurface(m_Path, Truncated, Again);
    }
    document.clear();
    const std::size_t end = ValueAt<std::uint32_t>(bytes, 8);
    for (std::size_t place = 12; place + 8 <= end;)
    {
      const std::size_t size = ValueAt<std::uint32_t>(bytes, place);
      const auto        kind = ValueAt<std::uint32_t>(bytes, place + 4);
      place += 8;
      if (size > end - place)
      {
        RefuseSurface(m_Path, Truncated, Again);
      }
      if (kind == GlbJsonChunk && document.empty())
      {
        document = bytes.substr(place, size);
      }
      else if (kind == GlbBinaryChunk && !hasBinary)
      {
        hasBinary = true;
        binary = bytes.substr(place, size);
      }
      place += size;
    }
  }
  m_Document = Json::parse(document);
  this->ReadBuffers(binary, hasBinary);
}

void
GltfScene::ReadBuffers(const std::string & binary, bool hasBinary)
{
  for (const Json & buffer : m_Document.value("buffers", Json::array()))
  {
    if (buffer.contains("uri"))
    {
      m_Buffers.push_back(this->BufferOfUri(buffer.at("uri").get<std::string>()));
    }
    else if (hasBinary && m_Buffers.empty())
    {
      m_Buffers.push_back(binary);
    }
    else
    {
      RefuseSurface(m_Path, "a buffer has no data");
    }
    if (SizeOr(buffer, "byteLength", 0) > m_Buffers.back().size())
    {
      RefuseSurface(m_Path, Truncated, Again);
    }
  }
}

std::string
GltfScene::BufferOfUri(const std::string & uri) const
{
  constexpr std::string_view scheme = "data:";
  if (uri.compare(0, scheme.size(), scheme) == 0)
  {
    const std::size_t mark = uri.find(";base64,");
    if (mark == std::string::npos)
    {
      RefuseSurface(m_Path, "a buffer within it is not base64");
    }
    std::string text = uri.substr(mark + 8);
    text.append((4 - text.size() % 4) % 4, '='); // some writers omit the padding
    const std::string bytes = DecodeBase64(text, 0, text.size());
    if (bytes.size() + (text.size() - text.find_last_not_of('=') - 1) != text.size() / 4 * 3)
    {
      RefuseSurface(m_Path, "a buffer within it is not base64");
    }
    return bytes;
  }
  const std::filesystem::path name = DecodePercents(uri);
  if (name.empty() || name.is_absolute() || uri.find("://") != std::string::npos || uri.find("..") != std::string::npos)
  {
    RefuseSurface(m_Path, "a buffer is outside its folder", "put all files into one folder, or write it as .glb");
  }
  return ReadFileBytes((std::filesystem::path(m_Path).parent_path() / name).string());
}

void
GltfScene::Visit(std::size_t             index,
                 const Eigen::Matrix4d & parent,
                 std::vector<bool> &     isVisited,
                 std::vector<Instance> & instances,
                 int                     depth) const
{
  const Json & node = m_Document.at("nodes").at(index);
  if (isVisited[index] || depth > DeepestNode)
  {
    RefuseSurface(m_Path, "node " + std::to_string(index) + " has two parents or is too deep");
  }
  isVisited[index] = true;
  const Eigen::Matrix4d transform = parent * TransformOf(node);
  if (node.contains("mesh"))
  {
    const std::size_t mesh = SizeOr(node, "mesh", 0);
    const std::string nameOfMesh = m_Document.at("meshes").at(mesh).value("name", "mesh " + std::to_string(mesh));
    instances.push_back({ node.value("name", nameOfMesh), mesh, transform });
  }
  for (const Json & child : node.value("children", Json::array()))
  {
    this->Visit(GltfIndex(child), transform, isVisited, instances, depth + 1);
  }
}

std::vector<GltfScene::Instance>
GltfScene::Instances() const
{
  const Json               nodes = m_Document.value("nodes", Json::array());
  std::vector<bool>        isVisited(nodes.size(), false);
  std::vector<std::size_t> roots;
  if (m_Document.contains("scenes"))
  {
    const Json & scene = m_Document.at("scenes").at(SizeOr(m_Document, "scene", 0));
    for (const Json & root : scene.value("nodes", Json::array()))
    {
      roots.push_back(GltfIndex(root));
    }
  }
  else
  {
    std::vector<bool> isChild(nodes.size(), false);
    for (const Json & node : nodes)
    {
      for (const Json & child : node.value("children", Json::array()))
      {
        if (GltfIndex(child) < nodes.size())
        {
          isChild[GltfIndex(child)] = true;
        }
      }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      roots.insert(roots.end(), isChild[i] ? 0 : 1, i);
    }
  }
  std::vector<Instance> instances;
  for (const std::size_t root : roots)
  {
    this->Visit(root, Eigen::Matrix4d::Identity(), isVisited, instances, 0);
  }
  return instances;
}

GltfScene::View
GltfScene::ViewOf(std::size_t index, const std::string & type) const
{
  static const std::map<std::size_t, BinaryType> types{
    { 5120, BinaryTypeOf<std::int8_t>() },   { 5121, BinaryTypeOf<std::uint8_t>() },
    { 5122, BinaryTypeOf<std::int16_t>() },  { 5123, BinaryTypeOf<std::uint16_t>() },
    { 5125, BinaryTypeOf<std::uint32_t>() }, { 5126, BinaryTypeOf<float>() }
  };
  const Json & accessor = m_Document.at("accessors").at(index);
  if (accessor.contains("sparse") || !accessor.contains("bufferView"))
  {
    RefuseSurface(m_Path, "accessor " + std::to_string(index) + " is sparse", "write it without sparse accessors");
  }
  const Json &          view = m_Document.at("bufferViews").at(SizeOr(accessor, "bufferView", 0));
  const std::string &   buffer = m_Buffers.at(SizeOr(view, "buffer", 0));
  const auto            componentType = types.find(SizeOr(accessor, "componentType", 0));
  const std::size_t     components = type == "VEC3" ? 3 : 1;
  const std::size_t     size = componentType == types.end() ? 0 : componentType->second.size;
  const std::size_t     count = SizeOr(accessor, "count", 0);
  const std::size_t     stride = SizeOr(view, "byteStride", size * components);
  const std::size_t     begin = SizeOr(view, "byteOffset", 0);
  const std::size_t     length = SizeOr(view, "byteLength", 0);
  const std::size_t     offset = SizeOr(accessor, "byteOffset", 0);
  const std::size_t     row = size * components;
  constexpr std::size_t longestStride = 252; // of glTF 2.0
  if (accessor.at("type").get<std::string>() != type || size == 0 || stride < row || stride > longestStride)
  {
    RefuseSurface(m_Path, "accessor " + std::to_string(index) + " has a wrong type or stride");
  }
  // Compares each number with the remaining size to avoid overflow of sums.
  const bool fitsBuffer = begin <= buffer.size() && length <= buffer.size() - begin;
  const bool fitsView =
    offset <= length && (count == 0 || (row <= length - offset && (count - 1) <= (length - offset - row) / stride));
  if (!fitsBuffer || !fitsView)
  {
    RefuseSurface(m_Path, "accessor " + std::to_string(index) + " extends beyond its data", Again);
  }
  return { &buffer, begin + offset, stride, count, componentType->second };
}

std::vector<double>
GltfScene::Positions(std::size_t accessor) const
{
  const View view = this->ViewOf(accessor, "VEC3");
  if (view.type.isInteger)
  {
    RefuseSurface(m_Path, "its positions are not floats", "write it without quantization");
  }
  std::vector<double> positions;
  for (std::size_t i = 0; i < 3 * view.count; ++i)
  {
    positions.push_back(ValueAt<float>(*view.bytes, view.begin + i / 3 * view.stride + 4 * (i % 3)));
  }
  return positions;
}

std::vector<std::int64_t>
GltfScene::Indices(std::size_t accessor) const
{
  const View view = this->ViewOf(accessor, "SCALAR");
  if (!view.type.isUnsigned)
  {
    RefuseSurface(m_Path, "accessor " + std::to_string(accessor) + " has indices that are not unsigned integers");
  }
  std::vector<std::int64_t> indices;
  for (std::size_t i = 0; i < view.count; ++i)
  {
    indices.push_back(static_cast<std::int64_t>(view.type.valueAt(*view.bytes, view.begin + i * view.stride, false)));
  }
  return indices;
}
} // namespace shapeton
