#include "shapetonCylinderPicture.h"

#include "shapetonGaussianWeights.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Sums of values and weights. */
struct Splat
{
  Eigen::MatrixXd sum;
  Eigen::MatrixXd weight;
};

void
AddPixel(Splat & splat, double row, double angle, double value)
{
  const int rows = static_cast<int>(splat.sum.rows());
  const int angles = static_cast<int>(splat.sum.cols());
  const int i = static_cast<int>(std::floor(row));
  const int j = static_cast<int>(std::floor(angle));
  for (int corner = 0; corner < 4; ++corner)
  {
    const int    ii = i + corner / 2;
    const double share = (corner / 2 ? row - i : 1.0 - (row - i)) * (corner % 2 ? angle - j : 1.0 - (angle - j));
    if (ii >= 0 && ii < rows)
    {
      const int jj = ((j + corner % 2) % angles + angles) % angles;
      splat.sum(ii, jj) += share * value;
      splat.weight(ii, jj) += share;
    }
  }
}

/** Normalizes a picture to mean 0 and standard deviation 1 over the valid rows; excluded rows are set to 0. */
void
Normalize(CylinderPicture & picture, const std::vector<char> & isExcluded)
{
  double sum = 0.0, squares = 0.0, number = 0.0;
  for (int i = 0; i < picture.Rows(); ++i)
  {
    if (!isExcluded[i])
    {
      sum += picture.values.row(i).sum();
      squares += picture.values.row(i).squaredNorm();
      number += picture.Angles();
    }
  }
  const double mean = sum / std::max(1.0, number);
  const double deviation = std::sqrt(std::max(1e-12, squares / std::max(1.0, number) - mean * mean));
  for (int i = 0; i < picture.Rows(); ++i)
  {
    picture.values.row(i) = isExcluded[i] ? Eigen::RowVectorXd::Zero(picture.Angles())
                                          : Eigen::RowVectorXd((picture.values.row(i).array() - mean) / deviation);
  }
}
} // namespace

double
SampleOf(const CylinderPicture & picture, double s, double turn)
{
  const double row = std::clamp((s - picture.begin) / picture.step, 0.0, picture.Rows() - 1.0);
  const double angle = (turn - std::floor(turn)) * picture.Angles() - 0.5 + picture.Angles();
  const int    i = std::min(static_cast<int>(row), picture.Rows() - 2);
  const int    j = static_cast<int>(angle);
  const double p = row - i;
  const double q = angle - j;
  const int    a = j % picture.Angles();
  const int    b = (j + 1) % picture.Angles();
  return (1.0 - p) * ((1.0 - q) * picture.values(i, a) + q * picture.values(i, b)) +
         p * ((1.0 - q) * picture.values(i + 1, a) + q * picture.values(i + 1, b));
}

Eigen::MatrixXd
SmoothedOnCylinder(const Eigen::MatrixXd & values, double rows, double angles)
{
  const std::vector<double> overRows = GaussianWeights(rows, 3.0);
  const std::vector<double> overAngles = GaussianWeights(angles, 3.0);
  const int                 rowReach = static_cast<int>(overRows.size()) / 2;
  const int                 angleReach = static_cast<int>(overAngles.size()) / 2;
  const int                 last = static_cast<int>(values.rows()) - 1;
  const int                 turn = static_cast<int>(values.cols());
  Eigen::MatrixXd           along = Eigen::MatrixXd::Zero(values.rows(), values.cols());
  for (int i = 0; i <= last; ++i)
  {
    for (int k = -rowReach; k <= rowReach; ++k)
    {
      along.row(i) += overRows[k + rowReach] * values.row(std::clamp(i + k, 0, last));
    }
  }
  Eigen::MatrixXd around = Eigen::MatrixXd::Zero(values.rows(), values.cols());
  for (int j = 0; j < turn; ++j)
  {
    for (int k = -angleReach; k <= angleReach; ++k)
    {
      around.col(j) += overAngles[k + angleReach] * along.col(((j + k) % turn + turn) % turn);
    }
  }
  return around;
}

CylinderPicture
MakeCylinderPicture(const ColonPosition &       position,
                    const ColonCylinder &       cylinder,
                    const std::vector<float> &  probability,
                    const CylinderPictureForm & form)
{
  const FlatColonGrid & grid = position.flat->Grid();
  Splat           splat{ Eigen::MatrixXd::Zero(form.rows, form.angles), Eigen::MatrixXd::Zero(form.rows, form.angles) };
  Eigen::VectorXd excluded = Eigen::VectorXd::Zero(form.rows);
  Eigen::VectorXd columns = Eigen::VectorXd::Zero(form.rows);
  for (int column = 0; column < grid.Columns(); ++column)
  {
    const double row = (form.coordinate(cylinder.ArcOfColumn(column + 0.5)) - form.begin) / form.step;
    const int    nearest = static_cast<int>(std::lround(row));
    if (nearest >= 0 && nearest < form.rows)
    {
      excluded[nearest] += !position.isExcluded.empty() && position.isExcluded[column];
      columns[nearest] += 1.0;
    }
    for (int y = 0; y < grid.Rows(); ++y)
    {
      const CylinderPlace place = cylinder.PlaceOfUv(grid.UvOfPixel(column, y));
      AddPixel(splat,
               row,
               (place.turn - std::floor(place.turn)) * form.angles - 0.5,
               probability[static_cast<std::size_t>(y) * grid.Columns() + column]);
    }
  }
  const Eigen::MatrixXd sum = SmoothedOnCylinder(splat.sum, form.smoothRows, form.smoothAngles);
  const Eigen::MatrixXd weight = SmoothedOnCylinder(splat.weight, form.smoothRows, form.smoothAngles);
  CylinderPicture       picture;
  picture.begin = form.begin;
  picture.step = form.step;
  picture.values = sum.array() / weight.array().max(1e-9);
  for (int i = 0; i < form.rows; ++i)
  {
    picture.isExcluded.push_back(columns[i] > 0.0 ? 2.0 * excluded[i] > columns[i] : weight.row(i).maxCoeff() < 1e-9);
  }
  Normalize(picture, picture.isExcluded);
  return picture;
}
} // namespace shapeton
