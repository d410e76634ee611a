#ifndef shapetonLighting_h
#define shapetonLighting_h

#include "shapetonHostDevice.h"

namespace shapeton
{
/** Blinn-Phong lighting with one light above the viewer's left shoulder and the coefficients of the volume property
 * (see ShapeTransferFunction). */
struct Lighting
{
  float brightness; ///< factor of the color
  float highlight;  ///< added white

  /** The cosines of a normal with the light direction and with the half vector to the viewer; both at least 0. */
  SHAPETON_HOST_DEVICE static Lighting
  Of(float towardsLight, float halfway)
  {
    constexpr float ambient = 0.3F;
    constexpr float diffuse = 0.6F;
    constexpr float specular = 0.2F;
    const float     power2 = halfway * halfway;
    const float     power8 = power2 * power2 * power2 * power2;
    return { ambient + diffuse * towardsLight, specular * power8 * power2 };
  }
  SHAPETON_HOST_DEVICE static Lighting
  Even()
  {
    constexpr float ambientAndDiffuse = 0.9F;
    return { ambientAndDiffuse, 0.0F };
  }

  /** `TVector`: itk::Vector<double, 3>. */
  template <typename TVector>
  static TVector
  DirectionToLight(const TVector & right, const TVector & up, const TVector & forward)
  {
    constexpr double above = 0.5, atTheLeft = 0.4; // relative to the distance in front
    TVector          toLight = up * above - right * atTheLeft - forward;
    toLight.Normalize();
    return toLight;
  }
};
} // namespace shapeton

#endif
