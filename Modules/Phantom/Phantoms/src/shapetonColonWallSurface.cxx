// The wall of ColonAnatomy.
#include "shapetonColonAnatomyData.h"

#include "shapetonExceptions.h"
#include "shapetonForEachCell.h"
#include "shapetonParallelFor.h"
#include "shapetonSurfaceConnectivity.h"

#include <Eigen/Geometry>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

namespace shapeton
{
using Eigen::Vector3d;

namespace
{
constexpr int c_Block = 8;      // voxels; blocks far from the wall have one value
constexpr int c_SlabBlocks = 2; // blocks contoured at once; chosen, bounds the memory

/** Extracts the zero level of the distance on a grid with this spacing (mm) in the box and projects its vertices onto
 * the wall. Processes slabs to limit memory. */
class WallExtractor
{
public:
  WallExtractor(const ColonField & field, const Vector3d & low, const Vector3d & high, double spacing)
    : m_Field(field), m_Low(low), m_Spacing(spacing)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      m_Blocks[axis] = static_cast<int>((high[axis] - low[axis]) / (c_Block * spacing)) + 1;
    }
    // One additional layer: the first layer of the next slab.
    m_SizeX = c_Block * m_Blocks[0] + 1;
    m_SizeY = c_Block * m_Blocks[1] + 1;
  }

  SurfaceMesh
  Run()
  {
    for (int slab = 0; slab * c_SlabBlocks < m_Blocks[2]; ++slab)
    {
      this->SampleSlab(slab);
      this->ContourSlab(slab * c_SlabBlocks * c_Block);
    }
    return this->MakeMesh();
  }

private:
  Vector3d
  PointAt(double x, double y, double z) const
  {
    return m_Low + m_Spacing * Vector3d(x, y, z);
  }

  // Bounded away from 0, so that points on different grid edges remain distinct after rounding.
  double
  DistanceAt(const Vector3d & point) const
  {
    ColonField::Place place;
    const double      value = m_Field.Evaluate(point, place) ? place.distance.value : -1e3;
    const double      least = 0.003 * m_Spacing;
    return value < 0 ? std::min(value, -least) : std::max(value, least);
  }

  void
  SampleSlab(int slab)
  {
    const int depth = c_SlabBlocks * c_Block + 1;
    m_Values.resize(std::size_t(m_SizeX) * m_SizeY * depth);
    ParallelFor(m_Blocks[1] + 1, [this, slab, depth](std::size_t rowOfBlocks) {
      const int begin = static_cast<int>(rowOfBlocks) * c_Block;
      const int end = std::min(begin + c_Block, m_SizeY);
      for (int z = 0; z < depth; z += c_Block)
      {
        for (int x = 0; x < m_SizeX; x += c_Block)
        {
          this->SampleBlock({ x, begin, z },
                            { std::min(x + c_Block, m_SizeX), end, std::min(z + c_Block, depth) },
                            slab * c_SlabBlocks * c_Block);
        }
      }
    });
  }

  // Use the value at the center for blocks far from the wall.
  void
  SampleBlock(const std::array<int, 3> & begin, const std::array<int, 3> & end, int base)
  {
    const double   half = 0.5 * (c_Block - 1);
    const Vector3d middle = this->PointAt(begin[0] + half, begin[1] + half, base + begin[2] + half);
    const double   distance = this->DistanceAt(middle);
    const bool     isFar = std::abs(distance) > 1.5 * 1.7321 * half * m_Spacing + 0.5;
    ForEachCell(begin, end, 1, [&](const std::array<int, 3> & cell) {
      m_Values[(std::size_t(cell[2]) * m_SizeY + cell[1]) * m_SizeX + cell[0]] =
        static_cast<float>(isFar ? distance : this->DistanceAt(this->PointAt(cell[0], cell[1], base + cell[2])));
    });
  }

  void
  ContourSlab(int base)
  {
    vtkNew<vtkFloatArray> scalars;
    scalars->SetArray(m_Values.data(), static_cast<vtkIdType>(m_Values.size()), 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(m_SizeX, m_SizeY, c_SlabBlocks * c_Block + 1);
    image->GetPointData()->SetScalars(scalars);
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(image);
    contour->SetValue(0, 0.0);
    contour->ComputeNormalsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    this->Append(contour->GetOutput(), base);
  }

  // Points on a shared layer have bitwise equal x and y in both slabs.
  void
  Append(vtkPolyData * surface, int base)
  {
    std::map<std::pair<double, double>, int> top;
    std::vector<int>                         ids(surface->GetNumberOfPoints());
    const double                             topZ = c_SlabBlocks * c_Block;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double p[3];
      surface->GetPoint(i, p);
      const auto shared = p[2] == 0.0 ? m_Shared.find({ p[0], p[1] }) : m_Shared.end();
      ids[i] = shared != m_Shared.end() ? shared->second : static_cast<int>(m_Points.size());
      if (shared == m_Shared.end())
      {
        m_Points.push_back(this->PointAt(p[0], p[1], p[2] + base));
      }
      if (p[2] == topZ)
      {
        top[{ p[0], p[1] }] = ids[i];
      }
    }
    vtkNew<vtkIdList> corners;
    for (vtkIdType c = 0; c < surface->GetPolys()->GetNumberOfCells(); ++c)
    {
      surface->GetPolys()->GetCellAtId(c, corners);
      m_Faces.push_back({ ids[corners->GetId(0)], ids[corners->GetId(1)], ids[corners->GetId(2)] });
    }
    m_Shared = std::move(top);
  }

  Vector3d
  OntoWall(Vector3d point) const
  {
    // Newton steps; half steps if they oscillate at a crease of the field.
    constexpr double onWall = 1e-4; // mm
    for (int round = 0; round < 40; ++round)
    {
      ColonField::Place place;
      if (!m_Field.Evaluate(point, place) || std::abs(place.distance.value) < onWall)
      {
        break;
      }
      const double length = std::max(place.distance.gradient.norm(), 0.5);
      const double share = round < 6 ? 1.0 : 0.5;
      const double step = std::clamp(share * place.distance.value / length, -0.5 * m_Spacing, 0.5 * m_Spacing);
      point -= (step / length) * place.distance.gradient;
    }
    return point;
  }

  SurfaceMesh
  MakeMesh() const
  {
    SurfaceMesh mesh;
    mesh.V.resize(m_Points.size(), 3);
    ParallelForBlocks(m_Points.size(), [&](std::size_t i) { mesh.V.row(i) = this->OntoWall(m_Points[i]); });
    double volume = 0.0;
    for (const Eigen::Vector3i & face : m_Faces)
    {
      volume += m_Points[face[0]].dot(m_Points[face[1]].cross(m_Points[face[2]]));
    }
    mesh.F.resize(m_Faces.size(), 3);
    for (std::size_t i = 0; i < m_Faces.size(); ++i)
    {
      mesh.F.row(i) = volume > 0 ? m_Faces[i] : Eigen::Vector3i(m_Faces[i][0], m_Faces[i][2], m_Faces[i][1]);
    }
    return mesh;
  }

  const ColonField &                       m_Field;
  Vector3d                                 m_Low;
  double                                   m_Spacing;
  std::array<int, 3>                       m_Blocks;
  int                                      m_SizeX;
  int                                      m_SizeY;
  std::vector<float>                       m_Values;
  std::vector<Vector3d>                    m_Points;
  std::vector<Eigen::Vector3i>             m_Faces;
  std::map<std::pair<double, double>, int> m_Shared;
};

// A grid point moved across the wall by rounding creates a component of eight faces.
SurfaceMesh
WithoutSpecks(const SurfaceMesh & mesh)
{
  constexpr int             speck = 50;
  const SurfaceConnectivity connectivity(mesh);
  std::vector<int>          faces;
  for (int i = 0; i < mesh.NumberOfFaces(); ++i)
  {
    const int component = connectivity.ComponentOfFaces()[i];
    if (component >= 0 && connectivity.Components()[component].faces >= speck)
    {
      faces.push_back(i);
    }
  }
  return FacesOfSurface(mesh, faces);
}
} // namespace

SurfaceMesh
ColonAnatomy::Wall(double edgeLength) const
{
  RequireParameter(edgeLength >= 0.1 && edgeLength <= 5, "the edge length of the wall must be from 0.1 to 5 mm");
  Vector3d low, high;
  this->BoundingBox(2.0, low, high);
  return WithoutSpecks(WallExtractor(m_Data->field, low, high, edgeLength).Run());
}
} // namespace shapeton
