#include "shapetonFlatColonStrip.h"

#include "shapetonStripPainter.h"
#include "shapetonExceptions.h"

namespace shapeton
{
namespace
{
/** A diverging map: blue at 0, nearly white in the middle, red at 1. */
RGBColor
CurvatureColor(double position)
{
  static const RGBColor stops[] = { MakeColor(33, 72, 150),   MakeColor(100, 155, 208), MakeColor(196, 219, 234),
                                    MakeColor(246, 244, 240), MakeColor(251, 207, 160), MakeColor(236, 128, 70),
                                    MakeColor(168, 30, 36) };
  constexpr int         parts = 6;
  const double          place = std::clamp(position, 0.0, 1.0) * parts;
  const int             part = std::min(parts - 1, static_cast<int>(place));
  return MixColors(stops[part], stops[part + 1], place - part);
}
} // namespace

ColorScale
CurvatureScale(double limit)
{
  RequireParameter(limit > 0.0, "the limit of a scale of curvature must be greater than 0");
  return { "mean curvature (1/mm), into the lumen positive", -limit, limit, CurvatureColor };
}

Picture::Pointer
PaintFlatCurvature(const FlatColonGrid & grid, const FlatColonAxis & axis, const ColorScale & scale, double shading)
{
  RequireParameter(shading >= 0.0 && shading <= 1.0, "the strength of shading must be from 0 to 1");
  return PaintStrip(grid, [&](const FlatSample & sample, int column) {
    const FlatLight light = LightOn(sample, FrameAt(axis, column, sample.point));
    const float     brightness = std::min(1.0F, 1.2F * light.brightness); // a flat wall keeps its color
    const auto      share = static_cast<float>(shading);
    return FromLinear((1.0F - share + share * brightness) * ToLinear(scale.ColorOf(sample.curvature)));
  });
}
} // namespace shapeton
