#include "shapetonFlatColon.h"

#include <Eigen/Geometry>

#include <array>
#include <list>
#include <mutex>
#include <utility>

namespace shapeton
{
namespace
{
/** The tube with the cut closed; faces are counterclockwise as seen from outside. */
struct Tube
{
  explicit Tube(const FlatColonGrid & grid) : V(grid.InwardNormals().rows(), 3), F(grid.Faces())
  {
    const std::vector<int> & source = grid.SourceOfPoints();
    for (std::size_t i = 0; i < source.size(); ++i)
    {
      V.row(source[i]) = grid.Points().row(static_cast<Eigen::Index>(i));
    }
    for (Eigen::Index i = 0; i < F.size(); ++i)
    {
      F.data()[i] = source[F.data()[i]];
    }
    if (this->LooksInwards(grid.InwardNormals()))
    {
      F.col(1).swap(F.col(2));
    }
  }

  VertexMatrix V;
  FaceMatrix   F;

private:
  bool
  LooksInwards(const VertexMatrix & inwardNormals) const
  {
    double sum = 0.0;
    for (Eigen::Index face = 0; face < F.rows(); ++face)
    {
      const Eigen::Vector3d a = V.row(F(face, 0)), b = V.row(F(face, 1)), c = V.row(F(face, 2));
      sum += (b - a).cross(c - a).dot(inwardNormals.row(F(face, 0)));
    }
    return sum > 0.0;
  }
};

using GridKey = std::array<double, 3>;

GridKey
KeyOf(const FlatColonGridOptions & options)
{
  return { options.pixelSize, options.curvatureLength, options.normalLength };
}

template <typename TKey, typename TValue>
using KeptValues = std::list<std::pair<TKey, TValue>>;

/** The cached value for a key, computed on first use. References to list elements remain valid. */
template <typename TKey, typename TValue, typename TMake>
const TValue &
FindOrMake(std::mutex & mutex, KeptValues<TKey, TValue> & kept, const TKey & key, const TMake & make)
{
  const std::lock_guard<std::mutex> lock(mutex);
  for (const auto & one : kept)
  {
    if (one.first == key)
    {
      return one.second;
    }
  }
  return kept.emplace_back(key, make()).second;
}
} // namespace

/** One mutex per kind of value, since computing an axis or a curvature requests a grid. */
struct FlatColon::Derived
{
  std::mutex                                                    gridMutex;
  std::mutex                                                    axisMutex;
  std::mutex                                                    curvatureMutex;
  KeptValues<GridKey, std::unique_ptr<const FlatColonGrid>>     grids;
  KeptValues<GridKey, FlatColonAxis>                            axes;
  KeptValues<std::pair<double, CurvatureUnit>, Eigen::VectorXd> curvatures;
};

FlatColon::FlatColon(SurfaceMesh surface, const FlatColonGridOptions & options, std::string what)
  : m_Surface(std::move(surface)), m_Options(options), m_What(std::move(what)), m_Derived(std::make_unique<Derived>())
{}

FlatColon::~FlatColon() = default;

const FlatColonGrid &
FlatColon::Grid(const FlatColonGridOptions & options) const
{
  return *FindOrMake(m_Derived->gridMutex, m_Derived->grids, KeyOf(options), [&] {
    return std::make_unique<const FlatColonGrid>(m_Surface, options, m_What);
  });
}

const FlatColonAxis &
FlatColon::Axis(const FlatColonGridOptions & options) const
{
  return FindOrMake(
    m_Derived->axisMutex, m_Derived->axes, KeyOf(options), [&] { return MakeFlatColonAxis(this->Grid(options)); });
}

const Eigen::VectorXd &
FlatColon::Curvature(double time, CurvatureUnit unit) const
{
  return FindOrMake(m_Derived->curvatureMutex, m_Derived->curvatures, std::pair(time, unit), [&] {
    const Tube tube(this->Grid());
    return SmoothedMeanCurvature(tube.V, tube.F, time, unit);
  });
}
} // namespace shapeton
