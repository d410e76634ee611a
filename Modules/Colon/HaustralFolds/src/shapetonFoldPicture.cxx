#include "shapetonFoldPicture.h"

#include "shapetonParallelFor.h"
#include "shapetonSmoothedCurvature.h"

#include <Eigen/Geometry>

namespace shapeton
{
namespace
{
/** The tube before it was cut. */
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
} // namespace

FoldPicture
MakeFoldPicture(const FlatColonGrid & grid, const HaustralFoldOptions & options)
{
  const Tube          tube(grid);
  const CurvatureUnit unit =
    options.scheme == HaustralFoldScheme::Published ? CurvatureUnit::Published : CurvatureUnit::PerArea;
  const Eigen::VectorXd curvature = SmoothedMeanCurvature(tube.V, tube.F, options.smoothingTime, unit);
  FoldPicture           picture;
  picture.sign = unit == CurvatureUnit::Published ? -1.0 : 1.0;
  picture.columns = grid.Columns();
  picture.rows = grid.Rows();
  picture.pixelSize = grid.PixelSize();
  picture.curvature.assign(picture.Size(), 0.0F);
  picture.scale.assign(picture.Size(), 1.0F);
  picture.isWall.assign(picture.Size(), 0);
  picture.part.assign(picture.Size(), 0);
  ParallelFor(picture.rows, [&](std::size_t row) {
    for (int column = 0; column < picture.columns; ++column)
    {
      const FlatSample sample = grid.SampleOfPixel(column, static_cast<int>(row));
      if (sample.face < 0)
      {
        continue;
      }
      const std::size_t pixel = picture.Index(column, static_cast<int>(row));
      double            value = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        value += sample.barycentric[k] * curvature[grid.SourceOfPoints()[grid.Faces()(sample.face, k)]];
      }
      picture.curvature[pixel] = static_cast<float>(value);
      picture.scale[pixel] = static_cast<float>(sample.scale);
      picture.isWall[pixel] = !sample.isBridged && sample.scale > 0.0;
    }
  });
  return picture;
}
} // namespace shapeton
