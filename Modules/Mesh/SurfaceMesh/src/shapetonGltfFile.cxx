#include "shapetonGltfScene.h"
#include "shapetonJson.h"
#include "shapetonSurfaceFormats.h"

#include <Eigen/LU>

#include <numeric>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr std::size_t MostPoints = 150000000; // coordinates

enum Mode : std::size_t
{
  Triangles = 4,
  Strip = 5,
  Fan = 6
};

/** Appends the triangles of a primitive, flipped if `isMirrored`. */
void
AddTriangles(const std::vector<std::int64_t> & indices,
             std::size_t                       mode,
             bool                              isMirrored,
             std::int64_t                      firstVertex,
             PolygonSurface &                  surface)
{
  const std::size_t step = mode == Triangles ? 3 : 1;
  for (std::size_t i = 2; i < indices.size(); i += step)
  {
    std::int64_t a = indices[mode == Fan ? 0 : i - 2];
    std::int64_t b = indices[i - 1];
    if (isMirrored != (mode == Strip && i % 2 == 1))
    {
      std::swap(a, b);
    }
    for (const std::int64_t index : { a, b, indices[i] })
    {
      surface.corners.push_back(firstVertex + index);
    }
    surface.EndPolygon();
  }
}

class GltfReader
{
public:
  GltfReader(const std::string & bytes, const std::string & path)
    : m_Path(path), m_Scene(bytes, path), m_IsTurned(m_Scene.IsTurnedLps())
  {
    m_Surface.unit = SurfaceUnit::Meter;
    m_Surface.repeatsVertices = true;
  }

  PolygonSurface
  Read()
  {
    for (const GltfScene::Instance & instance : m_Scene.Instances())
    {
      const auto firstFace = static_cast<int>(m_Surface.ends.size());
      for (const Json & primitive : m_Scene.Document().at("meshes").at(instance.mesh).at("primitives"))
      {
        this->ReadPrimitive(primitive, instance.transform);
      }
      m_Surface.parts.push_back({ instance.name, firstFace, static_cast<int>(m_Surface.ends.size()) - firstFace });
    }
    if (m_LeftOut)
    {
      m_Surface.notes.push_back(std::to_string(m_LeftOut) + " sets of points or lines were skipped");
    }
    return std::move(m_Surface);
  }

private:
  void
  ReadPrimitive(const Json & primitive, const Eigen::Matrix4d & transform)
  {
    const std::size_t mode = primitive.contains("mode") ? GltfIndex(primitive.at("mode")) : std::size_t{ Triangles };
    if (mode < Triangles || mode > Fan)
    {
      ++m_LeftOut;
      return;
    }
    const auto          firstVertex = static_cast<std::int64_t>(m_Surface.points.size() / 3);
    std::vector<double> positions = m_Scene.Positions(GltfIndex(primitive.at("attributes").at("POSITION")));
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3)
    {
      const Eigen::Vector4d p = transform * Eigen::Vector4d(positions[i], positions[i + 1], positions[i + 2], 1.0);
      m_IsTurned ? m_Surface.AddPoint(p[0], -p[2], p[1]) : m_Surface.AddPoint(p[0], p[1], p[2]);
    }
    if (m_Surface.points.size() > MostPoints) // a few bytes can reference one mesh many times
    {
      RefuseSurface(m_Path, "there are more than 50 million vertices", "cut or simplify the surface");
    }
    std::vector<std::int64_t> indices;
    if (primitive.contains("indices"))
    {
      indices = m_Scene.Indices(GltfIndex(primitive.at("indices")));
    }
    else
    {
      indices.resize(positions.size() / 3);
      std::iota(indices.begin(), indices.end(), 0);
    }
    this->CheckIndices(indices, positions.size() / 3);
    AddTriangles(indices, mode, transform.topLeftCorner<3, 3>().determinant() < 0.0, firstVertex, m_Surface);
  }

  // Check before meshes are merged: afterwards an index out of range would refer to the next mesh.
  void
  CheckIndices(const std::vector<std::int64_t> & indices, std::size_t vertices) const
  {
    for (const std::int64_t index : indices)
    {
      if (static_cast<std::uint64_t>(index) >= vertices)
      {
        RefuseSurface(m_Path,
                      "a face refers to vertex " + std::to_string(index) + ", but its mesh has " +
                        std::to_string(vertices));
      }
    }
  }

  std::string    m_Path;
  GltfScene      m_Scene;
  bool           m_IsTurned;
  PolygonSurface m_Surface;
  int            m_LeftOut{ 0 };
};
} // namespace

PolygonSurface
ReadGltf(const std::string & bytes, const std::string & path)
{
  try
  {
    return GltfReader(bytes, path).Read();
  }
  catch (const Json::exception & error)
  {
    RefuseSurface(path, std::string("not a valid glTF file (") + error.what() + ")");
  }
  catch (const std::out_of_range & error)
  {
    RefuseSurface(path, std::string("not a valid glTF file (") + error.what() + ")");
  }
}
} // namespace shapeton
