#include "shapetonPi.h"
#include "shapetonWallBetweenFolds.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Weights of (distance from the axis) / radius, and of (mean curvature) * radius, which is -0.5 on a tube. */
constexpr double reliefWeight = 20.0;
constexpr double curvatureWeight = 2.0;
/** Clamp of curvature * radius; larger values are caused by voxel steps. */
constexpr double greatestCurvature = 2.0;
/** Number of harmonics to remove; bends shift the center of the tube and make it oval. */
constexpr int bendHarmonics = 2;

/** Subtracts mean and first harmonics of each row. */
void
RemoveBends(std::vector<double> & wall, int rows)
{
  for (int row = 0; row < rows; ++row)
  {
    double * const cells = wall.data() + static_cast<std::size_t>(row) * anglesAround;
    for (int harmonic = 0; harmonic <= bendHarmonics; ++harmonic)
    {
      double cosine = 0.0;
      double sine = 0.0;
      for (int a = 0; a < anglesAround; ++a)
      {
        cosine += cells[a] * std::cos(TwoPi * harmonic * a / anglesAround);
        sine += cells[a] * std::sin(TwoPi * harmonic * a / anglesAround);
      }
      const double share = (harmonic == 0 ? 1.0 : 2.0) / anglesAround;
      for (int a = 0; a < anglesAround; ++a)
      {
        cells[a] -= share * (cosine * std::cos(TwoPi * harmonic * a / anglesAround) +
                             sine * std::sin(TwoPi * harmonic * a / anglesAround));
      }
    }
  }
}

/** Evidence at one point of the wall. */
double
InwardForm(const FlatSample & sample, const FlatColonAxis & axis, int column)
{
  const Eigen::Vector3d spoke = sample.point - axis.centers.row(column).transpose();
  const Eigen::Vector3d tangent = axis.tangents.row(column).transpose();
  const double          radius = (spoke - tangent * tangent.dot(spoke)).norm();
  const double          curvature = sample.curvature * axis.radii[column];
  return reliefWeight * (1.0 - radius / axis.radii[column]) +
         curvatureWeight * std::clamp(curvature, -greatestCurvature, greatestCurvature);
}
} // namespace

std::vector<double>
WallBetweenFolds(const FlatColonGrid &  grid,
                 const FlatColonAxis &  axis,
                 const HaustralFolds &  folds,
                 const TaeniaEvidence & evidence)
{
  std::vector<double> wall(static_cast<std::size_t>(evidence.rows) * anglesAround, 0.0);
  std::vector<double> count(wall.size(), 0.0);
  for (int column = 0; column < evidence.rows * evidence.columnsPerRow; ++column)
  {
    for (int row = 0; row < grid.Rows(); ++row)
    {
      const bool isFold = folds.labels->GetPixel({ { column, row } }) > 0;
      const bool isSeen = !isFold && grid.FaceOfPixel(column, row) >= 0 && !grid.IsBridged(column, row);
      if (isSeen)
      {
        const double form = InwardForm(grid.SampleOfPixel(column, row), axis, column);
        evidence.ForCellsOfPixel(column, row, [&](std::size_t cell, double share) {
          wall[cell] += share * form;
          count[cell] += share;
        });
      }
    }
  }
  for (std::size_t i = 0; i < wall.size(); ++i)
  {
    wall[i] = count[i] > 0.0 ? wall[i] / count[i] : 0.0;
  }
  RemoveBends(wall, evidence.rows);
  return wall;
}
} // namespace shapeton
