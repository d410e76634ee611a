#include "shapetonPictureMaps.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
Frame
FrameOf(const Place & z)
{
  const Place  up = std::abs(z.z) < 0.9 ? Place{ 0.0, 0.0, 1.0 } : Place{ 0.0, 1.0, 0.0 };
  const double along = Dot(up, z);
  Place        y{ up.x - along * z.x, up.y - along * z.y, up.z - along * z.z };
  const double length = std::sqrt(Dot(y, y));
  y = { y.x / length, y.y / length, y.z / length };
  return { { y.y * z.z - y.z * z.y, y.z * z.x - y.x * z.z, y.x * z.y - y.y * z.x }, y, z };
}

Frame
Turned(const Frame & frame, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const auto   mixed = [](double a, const Place & p, double b, const Place & q) {
    return Place{ a * p.x + b * q.x, a * p.y + b * q.y, a * p.z + b * q.z };
  };
  return { mixed(c, frame.x, s, frame.y), mixed(-s, frame.x, c, frame.y), frame.z };
}

PictureMap
Orthographic(const Frame & frame)
{
  PictureMap picture = { [frame](const Place & p) {
                          return Pixel{ Dot(p, frame.x), -Dot(p, frame.y) };
                        },
                         [frame](const Place & p) { return Dot(p, frame.z) >= 0.0; },
                         false,
                         false,
                         {} };
  constexpr int number = 360;
  for (int i = 0; i < number; ++i)
  {
    const double c = std::cos(2.0 * std::acos(-1.0) * i / number);
    const double s = std::sin(2.0 * std::acos(-1.0) * i / number);
    picture.rim.push_back(
      { c * frame.x.x + s * frame.y.x, c * frame.x.y + s * frame.y.y, c * frame.x.z + s * frame.y.z });
  }
  return picture;
}

PictureMap
Stereographic(const Frame & frame)
{
  constexpr double lowest = -0.9999; // the pole is outside any picture
  return { [frame](const Place & p) {
            const double share = 1.0 / std::max(1e-12, 1.0 + Dot(p, frame.z));
            return Pixel{ share * Dot(p, frame.x), -share * Dot(p, frame.y) };
          },
           [frame](const Place & p) { return Dot(p, frame.z) > lowest; },
           true,
           false,
           {} };
}

PictureMap
Flat(bool isStraight)
{
  return { [](const Place & p) {
            return Pixel{ p.x, -p.y };
          },
           [](const Place &) { return true; },
           true,
           isStraight,
           {} };
}

PictureMap
Klein()
{
  return { [](const Place & p) {
            const double scale = 2.0 / (1.0 + p.x * p.x + p.y * p.y);
            return Pixel{ scale * p.x, -scale * p.y };
          },
           [](const Place &) { return true; },
           false,
           true,
           {} };
}
} // namespace shapeton
