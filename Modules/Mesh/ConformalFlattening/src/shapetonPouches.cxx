#include "shapetonPouches.h"

#include "shapetonDisjointSets.h"
#include "shapetonFaceReplacement.h"
#include "shapetonFlatDistortion.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <functional>

namespace shapeton
{
namespace
{
/** \name Area scales, relative to the mean
 * Below the first, positions are lost to rounding and nothing is visible; pouches are cut off at the second. */
///@{
constexpr double invisibleScale = 1e-6;
constexpr double smallScale = 1e-3;
///@}

using FaceMarks = std::vector<char>;

/** For each face its cap number, 0 on the wall. */
std::vector<int>
CapOfFaces(const SurfaceMesh & mesh)
{
  const SurfaceArray * const array = FindSurfaceArray(mesh.cellArrays, capName);
  std::vector<int>           caps(mesh.NumberOfFaces(), 0);
  for (int face = 0; array && face < mesh.NumberOfFaces(); ++face)
  {
    caps[face] = static_cast<int>(array->values(face, 0));
  }
  return caps;
}

double
AreaOfFace(const SurfaceMesh & mesh, int face)
{
  const Eigen::RowVector3d a = mesh.V.row(mesh.F(face, 0));
  const Eigen::RowVector3d b = mesh.V.row(mesh.F(face, 1));
  const Eigen::RowVector3d c = mesh.V.row(mesh.F(face, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

/** For each vertex, plane area over space area of its faces, relative to the mean. */
Eigen::VectorXd
ScalesOfStars(const SurfaceMesh & mesh, const SurfaceMesh & flat)
{
  const Eigen::MatrixX2d uv = FlatCoordinates(flat, "the map");
  Eigen::VectorXd        areas = Eigen::VectorXd::Zero(mesh.NumberOfVertices());
  Eigen::VectorXd        flatAreas = areas;
  for (int face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    const Eigen::RowVector2d a = uv.row(flat.F(face, 1)) - uv.row(flat.F(face, 0));
    const Eigen::RowVector2d b = uv.row(flat.F(face, 2)) - uv.row(flat.F(face, 0));
    const double             area = AreaOfFace(mesh, face);
    const double             flatArea = 0.5 * std::abs(a[0] * b[1] - a[1] * b[0]);
    for (int k = 0; k < 3; ++k)
    {
      areas[mesh.F(face, k)] += area;
      flatAreas[mesh.F(face, k)] += flatArea;
    }
  }
  return (flatAreas.array() / areas.array()) * (areas.sum() / flatAreas.sum());
}

/** For each face, the representative of its part: faces of one kind joined by edges. */
std::vector<int>
PartsOfFaces(const SurfaceConnectivity & connectivity, const FaceMarks & kind)
{
  DisjointSets sets(connectivity.NumberOfFaces());
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const IndexRange faces = connectivity.FacesOfEdge(edge);
    if (faces.size() == 2 && kind[faces[0]] == kind[faces[1]])
    {
      sets.Join(faces[0], faces[1]);
    }
  }
  std::vector<int> part;
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    part.push_back(sets.Find(face));
  }
  return part;
}

/** Face marks that grow to a region that can be cut off. */
class PouchGrowth
{
public:
  PouchGrowth(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, FaceMarks isPouch)
    : m_Mesh(mesh), m_Connectivity(connectivity), m_CapOfFaces(CapOfFaces(mesh)), m_IsPouch(std::move(isPouch))
  {}

  FaceMarks
  Run()
  {
    FaceMarks before;
    while (before != m_IsPouch)
    {
      before = m_IsPouch;
      this->TakeWholeCaps();
      this->TakeIslands();
      OpenPinches(m_Mesh.F, m_Connectivity, m_IsPouch);
    }
    this->LeaveEnds();
    this->LeaveHandles();
    return std::move(m_IsPouch);
  }

private:
  void
  TakeWholeCaps()
  {
    std::vector<char> isTaken(m_CapOfFaces.size() + 1, 0);
    for (std::size_t face = 0; face < m_IsPouch.size(); ++face)
    {
      isTaken[m_CapOfFaces[face]] |= m_CapOfFaces[face] > 0 && m_IsPouch[face];
    }
    for (std::size_t face = 0; face < m_IsPouch.size(); ++face)
    {
      m_IsPouch[face] |= isTaken[m_CapOfFaces[face]];
    }
  }

  /** Marks everything that is disconnected from the largest remaining part. */
  void
  TakeIslands()
  {
    const std::vector<int> part = PartsOfFaces(m_Connectivity, m_IsPouch);
    std::vector<int>       sizes(part.size(), 0);
    for (std::size_t face = 0; face < part.size(); ++face)
    {
      sizes[part[face]] += m_IsPouch[face] ? 0 : 1;
    }
    const auto greatest = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    for (std::size_t face = 0; face < part.size(); ++face)
    {
      m_IsPouch[face] |= part[face] != greatest;
    }
  }

  /** Unmarks pouches with a vertex on an end. */
  void
  LeaveEnds()
  {
    const std::vector<int> part = PartsOfFaces(m_Connectivity, m_IsPouch);
    std::vector<char>      touchesEnd(part.size(), 0);
    for (std::size_t face = 0; face < part.size(); ++face)
    {
      for (int k = 0; k < 3; ++k)
      {
        touchesEnd[part[face]] |= m_Connectivity.IsBoundaryVertex(m_Mesh.F(static_cast<Eigen::Index>(face), k));
      }
    }
    for (std::size_t face = 0; face < part.size(); ++face)
    {
      m_IsPouch[face] = m_IsPouch[face] && !touchesEnd[part[face]];
    }
  }

  /** Unmarks pouches that are not discs: those with handles, and those that handles connect to the rest. */
  void
  LeaveHandles()
  {
    const std::vector<int> part = PartsOfFaces(m_Connectivity, m_IsPouch);
    std::vector<int>       euler(part.size(), 0);
    for (std::size_t face = 0; face < part.size(); ++face)
    {
      ++euler[part[face]];
    }
    for (int edge = 0; edge < m_Connectivity.NumberOfEdges(); ++edge)
    {
      this->AddToParts(part, m_Connectivity.FacesOfEdge(edge), -1, euler);
    }
    for (int vertex = 0; vertex < m_Connectivity.NumberOfVertices(); ++vertex)
    {
      this->AddToParts(part, m_Connectivity.FacesOfVertex(vertex), 1, euler);
    }
    for (std::size_t face = 0; face < part.size(); ++face)
    {
      m_IsPouch[face] = m_IsPouch[face] && euler[part[face]] == 1;
    }
  }

  /** Adds a number once to the marked part among these faces; after OpenPinches() there is at most one. */
  void
  AddToParts(const std::vector<int> & part, const IndexRange & faces, int number, std::vector<int> & euler) const
  {
    const auto * const marked = std::find_if(faces.begin(), faces.end(), [this](int face) { return m_IsPouch[face]; });
    if (marked != faces.end())
    {
      euler[part[*marked]] += number;
    }
  }

  const SurfaceMesh &         m_Mesh;
  const SurfaceConnectivity & m_Connectivity;
  std::vector<int>            m_CapOfFaces;
  FaceMarks                   m_IsPouch;
};

/** Marks the faces with a smaller scale around all corners and no corner on an end. */
FaceMarks
SmallFaces(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const SurfaceMesh & flat, double scale)
{
  const Eigen::VectorXd scales = ScalesOfStars(mesh, flat);
  FaceMarks             isSmall(static_cast<std::size_t>(mesh.NumberOfFaces()));
  for (int face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    const auto isInside = [&](int v) { return scales[v] < scale && !connectivity.IsBoundaryVertex(v); };
    isSmall[face] = isInside(mesh.F(face, 0)) && isInside(mesh.F(face, 1)) && isInside(mesh.F(face, 2));
  }
  return isSmall;
}

/** Marks the core and the other marked faces connected to it. */
FaceMarks
PartsWithCore(const SurfaceConnectivity & connectivity, FaceMarks isMarked, const FaceMarks & isCore)
{
  std::transform(isMarked.begin(), isMarked.end(), isCore.begin(), isMarked.begin(), std::logical_or<>());
  const std::vector<int> part = PartsOfFaces(connectivity, isMarked);
  FaceMarks              hasCore(part.size(), 0);
  for (std::size_t face = 0; face < part.size(); ++face)
  {
    hasCore[part[face]] |= isCore[face];
  }
  for (std::size_t face = 0; face < part.size(); ++face)
  {
    isMarked[face] = isMarked[face] && hasCore[part[face]];
  }
  return isMarked;
}

double
LengthOfRim(const SurfaceMesh & mesh, const std::vector<int> & rim)
{
  double length = 0.0;
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    length += (mesh.V.row(rim[i]) - mesh.V.row(rim[(i + 1) % rim.size()])).norm();
  }
  return length;
}

/** For each cap the part that contained it, or -1. */
std::vector<int>
PartsOfCaps(std::size_t              caps,
            const std::vector<int> & capOfFaces,
            const FaceMarks &        isPouch,
            const std::vector<int> & part)
{
  std::vector<int> partOfCap(caps, -1);
  for (std::size_t face = 0; face < part.size(); ++face)
  {
    if (isPouch[face] && capOfFaces[face] > 0)
    {
      partOfCap[capOfFaces[face] - 1] = part[face];
    }
  }
  return partOfCap;
}

/** New number of each old cap; caps without a part are renumbered. */
std::vector<int>
NumbersOfCapsLeft(const std::vector<int> & partOfCap)
{
  std::vector<int> numbers(partOfCap.size() + 1, 0);
  int              next = 0;
  for (std::size_t i = 0; i < partOfCap.size(); ++i)
  {
    numbers[i + 1] = partOfCap[i] == -1 ? ++next : 0;
  }
  return numbers;
}

/** For each hole filling, the part that contained the replaced faces. */
std::vector<int>
PartsOfFillings(const SurfaceConnectivity & connectivity,
                const FaceReplacement &     replacement,
                const FaceMarks &           isPouch,
                const std::vector<int> &    part)
{
  std::vector<int> parts;
  for (const HoleFilling & filling : replacement.fillings)
  {
    const IndexRange faces = connectivity.FacesOfVertex(replacement.keptVertices[filling.rim.front()]);
    parts.push_back(part[*std::find_if(faces.begin(), faces.end(), [&](int face) { return isPouch[face]; })]);
  }
  return parts;
}

PouchCap
MakeCap(const SurfaceMesh & mesh, const std::vector<int> & rim, double area)
{
  PouchCap cap{ LengthOfRim(mesh, rim), area };
  for (const int v : rim)
  {
    cap.place += mesh.V.row(v).transpose() / static_cast<double>(rim.size());
  }
  return cap;
}

/** Writes the cell array: wall and old caps are renumbered, followed by the fillings. */
void
NumberCaps(SurfaceMesh &                    mesh,
           const std::vector<HoleFilling> & fillings,
           const std::vector<int> &         numbersOfOld,
           int                              number)
{
  SurfaceArray & array = *std::find_if(
    mesh.cellArrays.begin(), mesh.cellArrays.end(), [](const SurfaceArray & a) { return a.name == capName; });
  for (Eigen::Index face = 0; face < array.values.rows(); ++face)
  {
    array.values(face, 0) = numbersOfOld[static_cast<std::size_t>(array.values(face, 0))];
  }
  Eigen::Index face = array.values.rows();
  for (std::size_t i = fillings.size(); i-- > 0;)
  {
    const auto faces = static_cast<Eigen::Index>(fillings[i].faces.size());
    face -= faces;
    array.values.middleRows(face, faces).setConstant(number + static_cast<int>(i) + 1);
  }
}
} // namespace

std::vector<char>
InvisibleFaces(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const SurfaceMesh & flat)
{
  FaceMarks              isInvisible = SmallFaces(mesh, connectivity, flat, invisibleScale);
  const std::vector<int> capOfFaces = CapOfFaces(mesh);
  for (std::size_t face = 0; face < isInvisible.size(); ++face)
  {
    isInvisible[face] = isInvisible[face] && capOfFaces[face] == 0;
  }
  return isInvisible;
}

std::vector<char>
FacesOfPouches(const SurfaceMesh &         mesh,
               const SurfaceConnectivity & connectivity,
               const SurfaceMesh &         flat,
               const std::vector<char> &   isCore)
{
  FaceMarks isPouch = PartsWithCore(connectivity, SmallFaces(mesh, connectivity, flat, smallScale), isCore);
  return PouchGrowth(mesh, connectivity, std::move(isPouch)).Run();
}

CappedSurface
CutOffPouches(const SurfaceMesh &           mesh,
              const SurfaceConnectivity &   connectivity,
              const std::vector<char> &     isPouch,
              const std::vector<PouchCap> & caps)
{
  const std::vector<int> part = PartsOfFaces(connectivity, isPouch);
  const std::vector<int> capOfFaces = CapOfFaces(mesh);
  const std::vector<int> partOfCap = PartsOfCaps(caps.size(), capOfFaces, isPouch, part);
  std::vector<double>    areaOfPart(part.size(), 0.0);
  for (int face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    areaOfPart[part[face]] += capOfFaces[face] == 0 ? AreaOfFace(mesh, face) : 0.0;
  }
  FaceReplacement replacement = ReplaceFaces(mesh, connectivity, isPouch, capName);
  CappedSurface   result;
  for (std::size_t i = 0; i < caps.size(); ++i)
  {
    if (partOfCap[i] == -1)
    {
      result.caps.push_back(caps[i]);
    }
    else
    {
      areaOfPart[partOfCap[i]] += caps[i].area; // the wall area it replaced
    }
  }
  NumberCaps(
    replacement.mesh, replacement.fillings, NumbersOfCapsLeft(partOfCap), static_cast<int>(result.caps.size()));
  const std::vector<int> partOfFilling = PartsOfFillings(connectivity, replacement, isPouch, part);
  for (std::size_t i = 0; i < partOfFilling.size(); ++i)
  {
    result.caps.push_back(MakeCap(replacement.mesh, replacement.fillings[i].rim, areaOfPart[partOfFilling[i]]));
  }
  result.mesh = std::move(replacement.mesh);
  result.keptVertices = std::move(replacement.keptVertices);
  return result;
}

std::vector<char>
FacesOfCaps(const SurfaceMesh & surface)
{
  if (!FindSurfaceArray(surface.cellArrays, capName))
  {
    return {};
  }
  std::vector<char> isCap;
  for (const int cap : CapOfFaces(surface))
  {
    isCap.push_back(cap > 0);
  }
  return isCap;
}
} // namespace shapeton
