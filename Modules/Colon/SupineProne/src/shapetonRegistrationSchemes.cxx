#include "shapetonRegistrationSchemes.h"

#include "shapetonFinalMap.h"
#include "shapetonPublishedMap.h"

#include <algorithm>
#include <limits>

namespace shapeton
{
namespace
{
/** Frame that is linear in mm of the flat maps, from end to end. */
PiecewiseLine
FrameOfRectangles(const ColonPair & pair)
{
  const ColonCylinder & source = *pair.sourceCylinder;
  const ColonCylinder & target = *pair.targetCylinder;
  const double  scale = static_cast<double>(target.Grid().Columns()) / static_cast<double>(source.Grid().Columns());
  constexpr int pieces = 200; // about 10 mm of colon each; chosen
  PiecewiseLine frame;
  for (int i = 0; i <= pieces; ++i)
  {
    const double s = source.Begin() + (source.End() - source.Begin()) * i / pieces;
    frame.from.push_back(s);
    frame.to.push_back(target.ArcOfColumn(scale * source.ColumnOfArc(s)));
  }
  return frame;
}

/** Overall rotation (turns) of the target at which the fold pictures agree best under the frame. */
double
BestRotation(const ColonPair & pair, const PiecewiseLine & frame)
{
  const auto picture = [&](const PiecewiseLine * line) {
    CylinderPictureForm form;
    form.begin = pair.sourceCylinder->Begin() + 0.5 * WarpRowStep;
    form.rows =
      std::max(2, static_cast<int>((pair.sourceCylinder->End() - pair.sourceCylinder->Begin()) / WarpRowStep));
    form.step = WarpRowStep;
    form.angles = WarpAngles;
    const PiecewiseLine back = line ? line->Inverse() : PiecewiseLine{ { 0.0, 1.0 }, { 0.0, 1.0 } };
    form.coordinate = [back](double s) { return back(s); };
    return line ? MakeCylinderPicture(pair.target, *pair.targetCylinder, pair.targetFolds, form).values
                : MakeCylinderPicture(pair.source, *pair.sourceCylinder, pair.sourceFolds, form).values;
  };
  const Eigen::MatrixXd source = picture(nullptr);
  const Eigen::MatrixXd target = picture(&frame);
  int                   best = 0;
  double                most = -std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < WarpAngles; ++shift)
  {
    const int    rest = WarpAngles - shift;
    const double agreement = source.leftCols(rest).cwiseProduct(target.rightCols(rest)).sum() +
                             source.rightCols(shift).cwiseProduct(target.leftCols(shift)).sum();
    if (agreement > most)
    {
      most = agreement;
      best = shift;
    }
  }
  return static_cast<double>(best) / WarpAngles;
}

CylinderMap
MapOfFrame(const ColonPair & pair, const PiecewiseLine & frame)
{
  const double rotation = BestRotation(pair, frame);
  return CylinderMap(NodesOf(pair, { frame, { { 0.0, 1.0 }, { rotation, rotation } }, nullptr, pair.Around() }));
}

FoldMatching
FollowedPairs(const SupineProneRegistration & registration)
{
  FoldMatching followed;
  for (const FoldMatch & match : registration.matches)
  {
    if (match.weight >= 0.5)
    {
      followed.pairs.emplace_back(match.source.fold, match.target.fold);
    }
  }
  return followed;
}
} // namespace

CylinderMap
MapOfScheme(RegistrationScheme              scheme,
            const ColonPosition &           source,
            const ColonPosition &           target,
            const SupineProneRegistration & registration)
{
  ColonPair                pair(source, target);
  std::vector<std::string> warnings; // already reported by the registration
  FindFrame(pair, false, warnings);
  switch (scheme)
  {
    case RegistrationScheme::Rectangles:
      return MapOfFrame(pair, FrameOfRectangles(pair));
    case RegistrationScheme::Centerline:
      return MapOfFrame(pair, EndFrame(pair.frame));
    case RegistrationScheme::Warping:
      return registration.warp;
    case RegistrationScheme::QuasiConformal:
      return QuasiConformalMapThrough(
        pair, registration.map, FollowedPairs(registration), SupineProneOptions().greatestDilatation);
    default:
      return registration.frame;
  }
}
} // namespace shapeton
