#include "shapetonCorrectedWarp.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Picture in the coordinate of its own position; settings are the same for both positions. */
CylinderPicture
PlainPicture(const ColonPosition &      position,
             const ColonCylinder &      cylinder,
             const std::vector<float> & folds,
             double                     blur)
{
  CylinderPictureForm form;
  form.begin = cylinder.Begin() + 0.5 * WarpRowStep;
  form.step = WarpRowStep;
  form.rows = std::max(2, static_cast<int>((cylinder.End() - cylinder.Begin()) / WarpRowStep));
  form.angles = WarpAngles;
  form.smoothRows = blur;
  form.smoothAngles = blur;
  form.coordinate = [](double s) { return s; };
  return MakeCylinderPicture(position, cylinder, folds, form);
}

/** Differences between the target and source pictures, linearized about the map. */
std::vector<DirectionConstraint>
ConstraintsOfPictures(const ColonPair &       pair,
                      const CylinderPicture & source,
                      const CylinderPicture & target,
                      const RowMap &          map)
{
  constexpr double                 weight = 0.04; // per difference of one standard deviation
  const double                     along = 0.5 * WarpRowStep;
  const double                     around = 0.5 / WarpAngles;
  std::vector<DirectionConstraint> constraints;
  for (int i = 0; i < source.Rows(); ++i)
  {
    for (int j = 0; j < WarpAngles && !source.isExcluded[i]; ++j)
    {
      const CylinderPlace place{ source.begin + i * source.step, (j + 0.5) / WarpAngles };
      const CylinderPlace to = map(place);
      if (IsExcluded(pair.target, *pair.targetCylinder, to))
      {
        continue;
      }
      const Eigen::Vector2d gradient(
        (SampleOf(target, to.s + along, to.turn) - SampleOf(target, to.s - along, to.turn)) / (2.0 * along),
        (SampleOf(target, to.s, to.turn + around) - SampleOf(target, to.s, to.turn - around)) /
          (2.0 * around * pair.Around()));
      const double difference = source.values(i, j) - SampleOf(target, to.s, to.turn);
      constraints.push_back({ place, gradient, difference + gradient.dot(map.correction->At(place)), weight, false });
    }
  }
  return constraints;
}
} // namespace

void
RefineByPictures(const ColonPair & pair, CorrectedWarp & corrected, const Progress & progress)
{
  double share = 0.0;
  for (const double blur : { 2.5, 1.5, 1.0 })
  {
    const double begin = share;
    share += 1.0 / 3.0;
    const CylinderPicture source = PlainPicture(pair.source, *pair.sourceCylinder, pair.sourceFolds, blur);
    const CylinderPicture target = PlainPicture(pair.target, *pair.targetCylinder, pair.targetFolds, blur);
    const RowMap          map = corrected.Map(pair);
    FitCorrection(
      pair, map, ConstraintsOfPictures(pair, source, target, map), corrected, progress.Part("", begin, share));
  }
}
} // namespace shapeton
