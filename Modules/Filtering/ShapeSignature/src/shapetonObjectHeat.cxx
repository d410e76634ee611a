#include "shapetonObjectHeat.h"

#include "shapetonExceptions.h"
#include "shapetonSpectralMeasure.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Position of the boundary. */
constexpr float BoundaryLevel = 0.5F;
/** Minimum distance of a boundary from a voxel center, in voxels: otherwise its conductance would dominate. */
constexpr double LeastDistance = 0.1;
/** Smaller heat values are rounding errors. */
constexpr double LeastHeat = 1e-9;
/** Voxels with a smaller fraction are empty. */
constexpr float LeastShare = 1e-3F;

/** The active voxels: their grid indices, and for each grid index the number of the voxel, or -1 if inactive. */
struct Participants
{
  std::vector<std::size_t> places;
  std::vector<int>         numbers;

  Participants(const ShapeOccupancy & occupancy, float least) : numbers(occupancy.values.size(), -1)
  {
    for (std::size_t place = 0; place < occupancy.values.size(); ++place)
    {
      if (occupancy.values[place] >= least)
      {
        numbers[place] = static_cast<int>(places.size());
        places.push_back(place);
      }
    }
  }
  Eigen::Index
  Size() const
  {
    return static_cast<Eigen::Index>(places.size());
  }
};

/** Distance from the center of an inside voxel to the boundary toward an outside neighbor, in voxels. */
double
DistanceOfBoundary(float inside, float outside)
{
  return std::max(LeastDistance, static_cast<double>((inside - BoundaryLevel) / (inside - outside)));
}

/** Negative Laplacian with heat 0 on the boundary. */
SymmetricMatrix
LeavingOperator(const ShapeOccupancy & occupancy, const Participants & inside)
{
  SymmetricMatrix matrix;
  matrix.diagonal = Eigen::VectorXd::Zero(inside.Size());
  for (Eigen::Index i = 0; i < inside.Size(); ++i)
  {
    const std::size_t place = inside.places[i];
    ForEachNeighbor(occupancy.grid, place, [&](std::size_t neighbor) {
      const int j = inside.numbers[neighbor];
      matrix.diagonal[i] +=
        j >= 0 ? 1.0 : 1.0 / DistanceOfBoundary(occupancy.values[place], occupancy.values[neighbor]);
      if (j > i)
      {
        matrix.entries.push_back({ static_cast<int>(i), j, 1.0 });
      }
    });
  }
  return matrix;
}

/** M^-1/2 L M^-1/2 for an insulated object: M the filled fractions, L from the conductances of the faces. */
SymmetricMatrix
StayingOperator(const ShapeOccupancy & occupancy, const Participants & filled)
{
  SymmetricMatrix matrix;
  matrix.diagonal = Eigen::VectorXd::Zero(filled.Size());
  for (Eigen::Index i = 0; i < filled.Size(); ++i)
  {
    const std::size_t place = filled.places[i];
    const double      share = occupancy.values[place];
    ForEachNeighbor(occupancy.grid, place, [&](std::size_t neighbor) {
      const int    j = filled.numbers[neighbor];
      const double other = occupancy.values[neighbor];
      if (j > i)
      {
        const double conductance = std::min({ share, other, 1.0 });
        matrix.entries.push_back({ static_cast<int>(i), j, conductance / std::sqrt(share * other) });
        matrix.diagonal[i] += conductance / share;
        matrix.diagonal[j] += conductance / other;
      }
    });
  }
  return matrix;
}

void
RequireThickness(const ShapeOccupancy & occupancy, const Participants & inside)
{
  double filled = 0.0;
  for (const float share : occupancy.values)
  {
    filled += share;
  }
  if (inside.Size() < 0.5 * filled)
  {
    throw InputError("the shape is too thin for its size: less than half of it is thicker than 1/" +
                     std::to_string(static_cast<int>(ShapeSignature::RadiusInVoxels)) +
                     " of the radius of a ball of its volume");
  }
}
} // namespace

ShapeSignature::Curve
RemainingHeat(const ShapeOccupancy & occupancy, const ShapeSignature::Curve & times)
{
  const Participants inside(occupancy, BoundaryLevel);
  RequireThickness(occupancy, inside);
  const SpectralMeasure measure(LeavingOperator(occupancy, inside), Eigen::VectorXd::Ones(inside.Size()));
  ShapeSignature::Curve curve{};
  for (std::size_t k = 0; k < times.size(); ++k)
  {
    const double remaining = measure.Remaining(times[k]) / static_cast<double>(inside.Size());
    curve[k] = remaining < LeastHeat ? 0.0 : remaining;
  }
  return curve;
}

ShapeSignature::Curve
MeanSquareDisplacement(const ShapeOccupancy & occupancy, const ShapeSignature::Curve & times)
{
  const Participants    filled(occupancy, LeastShare);
  const SymmetricMatrix matrix = StayingOperator(occupancy, filled);
  Eigen::VectorXd       share(filled.Size());
  Eigen::MatrixX3d      position(filled.Size(), 3);
  for (Eigen::Index i = 0; i < filled.Size(); ++i)
  {
    const auto voxel = occupancy.grid.Voxel(filled.places[i]);
    share[i] = occupancy.values[filled.places[i]];
    position.row(i) << voxel[0], voxel[1], voxel[2];
  }
  ShapeSignature::Curve curve{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double          mean = share.dot(position.col(axis)) / share.sum();
    const SpectralMeasure measure(matrix, share.cwiseSqrt().cwiseProduct((position.col(axis).array() - mean).matrix()));
    for (std::size_t k = 0; k < times.size(); ++k)
    {
      curve[k] += 2.0 * measure.Gone(times[k]) / share.sum();
    }
  }
  return curve;
}
} // namespace shapeton
