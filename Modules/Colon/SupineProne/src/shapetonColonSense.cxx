#include "shapetonColonSense.h"

#include "shapetonCylinderPicture.h"
#include "shapetonCylindricalWarping.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <array>

namespace shapeton
{
namespace
{
constexpr double rowStep = 3.0; // mm, as WarpRowStep
constexpr double reach = 75.0;  // mm from the course proportional to the lengths

/** Picture scaled to a number of rows from end to end. */
CylinderPicture
PictureOf(const ColonWithFolds & colon, double step, int rows)
{
  CylinderPictureForm form;
  const double        scale = rows * step / (colon.cylinder.End() - colon.cylinder.Begin());
  form.begin = 0.5 * rowStep;
  form.step = step;
  form.rows = rows;
  form.smoothRows = 1.0;
  form.coordinate = [scale, begin = colon.cylinder.Begin()](double s) { return scale * (s - begin); };
  return MakeCylinderPicture(colon.position, colon.cylinder, colon.folds, form);
}

/** The picture in another orientation: bit 1 of `way` reverses the angles, bit 2 the rows. */
CylinderPicture
Turned(CylinderPicture picture, int way)
{
  if (way % 2 != 0)
  {
    picture.values = picture.values.rowwise().reverse().eval();
  }
  if (way / 2 != 0)
  {
    picture.values = picture.values.colwise().reverse().eval();
    std::reverse(picture.isExcluded.begin(), picture.isExcluded.end());
  }
  return picture;
}

/** Description of each orientation, indexed by the argument `way` of Turned(). */
constexpr std::array<const char *, 4> textOfWay{ { "",
                                                   "is a mirror image",
                                                   "is a mirror image that runs from the cecum to the rectum",
                                                   "runs from the cecum to the rectum" } };
} // namespace

double
RequireSameSense(const ColonWithFolds & source, const ColonWithFolds & target, const Progress & progress)
{
  const int rows = std::max(2, static_cast<int>((source.cylinder.End() - source.cylinder.Begin()) / rowStep));
  const CylinderPicture     fixed = PictureOf(source, rowStep, rows);
  const CylinderPicture     moving = PictureOf(target, 0.5 * rowStep, 2 * rows);
  CylindricalWarpingOptions options;
  options.band = reach;
  options.frameDeviation = reach;
  const PiecewiseLine   frame{ { 0.0, 1.0 }, { 0.0, 1.0 } }; // the identity
  std::array<double, 4> energies;
  for (int way = 0; way < 4; ++way)
  {
    options.progress = progress.Part("", 0.25 * way, 0.25 * (way + 1));
    energies[way] = WarpCylinder(fixed, Turned(moving, way), frame, {}, options).energy;
  }
  const auto       best = std::min_element(energies.begin() + 1, energies.end());
  const double     margin = *best - energies[0];
  constexpr double doubt = 0.05; // colons of two patients differ by less
  if (margin < -doubt)
  {
    throw InputError(target.position.name + " " + textOfWay[best - energies.begin()] + " against " +
                     source.position.name +
                     " according to its folds: head and feet or left and right are swapped in one of them; check the "
                     "orientation of the series, and that both are of one patient");
  }
  return margin;
}
} // namespace shapeton
