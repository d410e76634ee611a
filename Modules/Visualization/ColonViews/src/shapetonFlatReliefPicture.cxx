#include "shapetonFlatColonStrip.h"

#include "shapetonStripPainter.h"
#include "shapetonExceptions.h"

namespace shapeton
{
Picture::Pointer
PaintFlatRelief(const FlatColonGrid & grid, const FlatColonAxis & axis, const FlatReliefOptions & options)
{
  RequireParameter(options.heightContrast >= 0.0 && options.heightContrast <= 1.0,
                   "the contrast of heights must be from 0 to 1");
  static const LinearColor pocket = ToLinear(MakeColor(168, 88, 74));
  static const LinearColor wall = ToLinear(MakeColor(232, 164, 144));
  static const LinearColor crest = ToLinear(MakeColor(255, 226, 206));
  return PaintStrip(grid, [&](const FlatSample & sample, int column) {
    const FlatColonFrame  frame = FrameAt(axis, column, sample.point);
    const Eigen::Vector3d toAxis = axis.centers.row(column).transpose() - sample.point;
    const double          height = 1.0 - frame.towards.dot(toAxis) / axis.radii[column]; // 1 on the axis, 0 on the tube
    const auto            share = static_cast<float>(std::clamp(2.0 * height, -1.0, 1.0) * options.heightContrast);
    LinearColor     color = share < 0.0F ? LinearColor(wall - share * (pocket - wall)) : wall + share * (crest - wall);
    const FlatLight light = LightOn(sample, frame);
    return FromLinear((light.brightness * color).array() + light.highlight);
  });
}
} // namespace shapeton
