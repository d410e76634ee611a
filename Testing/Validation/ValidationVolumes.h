#ifndef ValidationVolumes_h
#define ValidationVolumes_h

#include "shapetonDiffusionTestVolumes.h"

/** Cube of value 1 in the middle of a volume of 0. */
inline shapeton::test::Volume
Cube(std::size_t volumeSide, std::size_t side)
{
  shapeton::test::Volume volume({ volumeSide, volumeSide, volumeSide });
  const std::size_t      first = (volumeSide - side) / 2;
  volume.Fill([=](std::size_t x, std::size_t y, std::size_t z) {
    return std::min({ x, y, z }) >= first && std::max({ x, y, z }) < first + side ? 1.0 : 0.0;
  });
  return volume;
}

template <typename TA, typename TB>
double
Correlation(const std::vector<TA> & a, const std::vector<TB> & b)
{
  const double n = static_cast<double>(a.size());
  double       sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sa += a[i];
    sb += b[i];
    saa += static_cast<double>(a[i]) * a[i];
    sbb += static_cast<double>(b[i]) * b[i];
    sab += static_cast<double>(a[i]) * b[i];
  }
  return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

#endif
