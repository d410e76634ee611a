#include "shapetonQuadrilateralMap.h"

#include "shapetonBoundedWeights.h"
#include "shapetonHarmonicSolver.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shapeton
{
namespace
{
/** Positions of the corners along the boundary, ascending from the first corner. */
std::array<int, 4>
PlacesOfCorners(const std::vector<int> & boundary, const std::array<int, 4> & corners)
{
  const int          length = static_cast<int>(boundary.size());
  std::array<int, 4> places{};
  for (int i = 0; i < 4; ++i)
  {
    const auto found = std::find(boundary.begin(), boundary.end(), corners[i]);
    if (found == boundary.end())
    {
      throw InputError("corner " + std::to_string(corners[i]) +
                       " is not a boundary vertex; choose four boundary vertices, for example " +
                       std::to_string(boundary[0]));
    }
    places[i] = static_cast<int>(found - boundary.begin());
  }
  const auto isAfter = [&](int i) { return (places[i] - places[0] + length) % length; };
  if (isAfter(1) > isAfter(3))
  {
    std::swap(places[1], places[3]);
  }
  if (!(0 < isAfter(1) && isAfter(1) < isAfter(2) && isAfter(2) < isAfter(3)))
  {
    throw InputError("the corners must be four different vertices in boundary order");
  }
  return places;
}

/** Vertices between two boundary positions, inclusive. */
std::vector<int>
SideOfBoundary(const std::vector<int> & boundary, int from, int to)
{
  std::vector<int> side;
  for (std::size_t i = from;; i = (i + 1) % boundary.size())
  {
    side.push_back(boundary[i]);
    if (static_cast<int>(i) == to)
    {
      return side;
    }
  }
}

/** The harmonic function that is 0 on one side and 1 on the other. */
Eigen::VectorXd
Between(const SurfaceLaplacian &      laplacian,
        const SymbolicFactorization & symbolic,
        std::vector<int>              zero,
        const std::vector<int> &      one,
        const Progress &              progress)
{
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(zero.size() + one.size()));
  values.tail(static_cast<Eigen::Index>(one.size())).setOnes();
  zero.insert(zero.end(), one.begin(), one.end());
  return HarmonicSolver(laplacian, std::move(zero), symbolic, progress).Solve(values);
}
} // namespace

QuadrilateralMap
MapQuadrilateral(const SurfaceConnectivity & connectivity,
                 const Eigen::VectorXd &     edgeLengths,
                 const BoundaryLoop &        boundary,
                 const std::array<int, 4> &  corners,
                 const std::vector<int> &    weightLevels,
                 const Progress &            progress)
{
  const std::array<int, 4>    places = PlacesOfCorners(boundary.vertices, corners);
  const SurfaceLaplacian      laplacian = MakeSurfaceLaplacian(connectivity, edgeLengths);
  const SurfaceLaplacian      bounded = WithBoundedWeights(laplacian, weightLevels);
  const SymbolicFactorization symbolic = HarmonicSolver::Analyze(connectivity);
  const auto side = [&](int i) { return SideOfBoundary(boundary.vertices, places[i], places[(i + 1) % 4]); };
  progress(0.4);
  QuadrilateralMap map;
  for (int i = 0; i < 4; ++i)
  {
    map.corners[i] = boundary.vertices[places[i]];
  }
  map.u = Between(bounded, symbolic, side(3), side(1), progress.Part("", 0.4, 0.7));
  map.v = Between(bounded, symbolic, side(0), side(2), progress.Part("", 0.7, 1.0));
  map.modulusU = GradientEnergy(laplacian, map.u);
  map.modulusV = 1.0 / GradientEnergy(laplacian, map.v);
  return map;
}

namespace
{
/** A closed curve of points and the area of quadrilaterals in it. */
class Inscribed
{
public:
  Inscribed(const std::vector<int> & boundary, const VertexMatrix & V)
  {
    for (const int vertex : boundary)
    {
      m_Points.emplace_back(V.row(vertex));
    }
  }
  int
  Size() const
  {
    return static_cast<int>(m_Points.size());
  }
  /** Area of its projection along its mean normal, doubled. */
  double
  Area(const std::array<int, 4> & at) const
  {
    return (m_Points[at[2]] - m_Points[at[0]]).cross(m_Points[at[3]] - m_Points[at[1]]).norm();
  }
  /** The positions at quarters of the length, starting at `first`. */
  std::array<int, 4>
  Quarters(int first) const
  {
    std::vector<double> arc{ 0.0 };
    for (int i = 0; i < this->Size(); ++i)
    {
      const int a = (first + i) % this->Size();
      arc.push_back(arc.back() + (m_Points[(a + 1) % this->Size()] - m_Points[a]).norm());
    }
    std::array<int, 4> at{ 0, 0, 0, 0 };
    for (int k = 1; k < 4; ++k)
    {
      const auto next = std::lower_bound(arc.begin(), arc.end(), 0.25 * k * arc.back());
      at[k] = std::clamp(static_cast<int>(next - arc.begin()), at[k - 1] + 1, this->Size() - 4 + k);
    }
    for (int & place : at)
    {
      place = (first + place) % this->Size();
    }
    return at;
  }

private:
  std::vector<Eigen::Vector3d> m_Points;
};

/** Treats areas that are equal up to rounding as ties, for reproducible results. */
bool
IsLarger(double area, double than)
{
  return area > than * (1.0 + 1e-9);
}

/** Moves one corner between its neighbors to maximize the area. */
bool
MoveCorner(const Inscribed & curve, int corner, std::array<int, 4> & at)
{
  const int          end = at[(corner + 1) % 4];
  std::array<int, 4> best = at;
  for (int place = (at[(corner + 3) % 4] + 1) % curve.Size(); place != end; place = (place + 1) % curve.Size())
  {
    std::array<int, 4> trial = at;
    trial[corner] = place;
    if (IsLarger(curve.Area(trial), curve.Area(best)))
    {
      best = trial;
    }
  }
  const bool hasMoved = best != at;
  at = best;
  return hasMoved;
}
} // namespace

std::array<int, 4>
SpreadCorners(const BoundaryLoop & boundary, const VertexMatrix & V)
{
  const Inscribed curve(boundary.vertices, V);
  if (curve.Size() < 4)
  {
    throw InputError("a boundary of " + std::to_string(curve.Size()) + " vertices has no four corners");
  }
  const int          starts = std::min(curve.Size(), 256);
  std::array<int, 4> at = curve.Quarters(0);
  for (int i = 1; i < starts; ++i)
  {
    const auto trial = curve.Quarters(static_cast<int>(static_cast<long long>(i) * curve.Size() / starts));
    if (IsLarger(curve.Area(trial), curve.Area(at)))
    {
      at = trial;
    }
  }
  for (bool moves = true; moves;)
  {
    moves = false;
    for (int corner = 0; corner < 4; ++corner)
    {
      moves = MoveCorner(curve, corner, at) || moves;
    }
  }
  std::rotate(at.begin(), std::min_element(at.begin(), at.end()), at.end());
  std::array<int, 4> corners{};
  std::transform(at.begin(), at.end(), corners.begin(), [&](int place) { return boundary.vertices[place]; });
  return corners;
}
} // namespace shapeton
