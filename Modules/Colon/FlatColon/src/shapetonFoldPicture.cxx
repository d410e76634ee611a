#include "shapetonFoldPicture.h"

#include "shapetonParallelFor.h"

namespace shapeton
{
FoldPicture
MakeFoldPicture(const FlatColon & flat, const HaustralFoldSettings & options)
{
  const FlatColonGrid & grid = flat.Grid();
  options.progress(0.1);
  const CurvatureUnit unit =
    options.scheme == HaustralFoldScheme::Published ? CurvatureUnit::Published : CurvatureUnit::PerArea;
  const Eigen::VectorXd & curvature = flat.Curvature(options.smoothingTime, unit);
  options.progress(0.3);
  FoldPicture picture;
  picture.sign = unit == CurvatureUnit::Published ? -1.0 : 1.0;
  picture.columns = grid.Columns();
  picture.rows = grid.Rows();
  picture.pixelSize = grid.PixelSize();
  picture.curvature.assign(picture.Size(), 0.0F);
  picture.scale.assign(picture.Size(), 1.0F);
  picture.isWall.assign(picture.Size(), 0);
  picture.part.assign(picture.Size(), 0);
  const auto fillRow = [&](std::size_t row) {
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
  };
  ParallelFor(picture.rows, fillRow, options.progress.Part("", 0.3, 0.5));
  return picture;
}
} // namespace shapeton
