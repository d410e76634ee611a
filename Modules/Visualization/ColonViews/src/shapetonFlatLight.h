#ifndef shapetonFlatLight_h
#define shapetonFlatLight_h

#include "shapetonHostDevice.h"

namespace shapeton
{
/** View directions of a pixel of a flat picture: a FlatColonFrame as plain numbers. */
struct FlatAxes
{
  double right[3];
  double down[3];
  double towards[3];
};

/** Lighting of a piece of wall: factor of its color, and added white. */
struct FlatLight
{
  float brightness;
  float highlight;

  /** `normal`: unit vector into the lumen. */
  SHAPETON_HOST_DEVICE static FlatLight
  On(const double normal[3], const FlatAxes & axes)
  {
    // The direction towards the light, which is at the left and slightly above, (-0.62, -0.22, 0.75), and the half
    // vector to the eye.
    constexpr double toLight[] = { -0.6214621561237835, -0.22051882959231028, 0.7517687372465124 };
    constexpr double halfway[] = { -0.33201775133635536, -0.11781275047419061, 0.9358869422228607 };
    constexpr double ambient = 0.10;
    constexpr double diffuse = 0.80;
    constexpr double fromEye = 0.12;
    constexpr double wrap = 0.7; // wrap lighting shows the shape of shadowed sides
    constexpr float  specular = 0.10F;
    const double     seen[] = { HostDevice::Product(normal, axes.right),
                                HostDevice::Product(normal, axes.down),
                                HostDevice::Product(normal, axes.towards) };
    const double     towardsLight = HostDevice::Larger(0.0, (HostDevice::Product(seen, toLight) + wrap) / (1.0 + wrap));
    const auto       towardsHalfway = static_cast<float>(HostDevice::Larger(0.0, HostDevice::Product(seen, halfway)));
    const float      power3 = towardsHalfway * towardsHalfway * towardsHalfway;
    const float      power6 = power3 * power3;
    const float      power12 = power6 * power6;
    return { static_cast<float>(ambient + diffuse * towardsLight + fromEye * HostDevice::Larger(0.0, seen[2])),
             specular * (power12 * power12) };
  }
};
} // namespace shapeton

#endif
