#ifndef shapetonLighting_h
#define shapetonLighting_h

#include "shapetonHostDevice.h"

namespace shapeton
{
/** Blinn-Phong with one light over the viewer's left shoulder and the numbers of the volume property (see
 * ShapeTransferFunction). */
struct Lighting
{
  float brightness; ///< of the colour
  float highlight;  ///< white, added

  /** The cosines of a normal to the light and to the direction halfway to the viewer; both at least 0. */
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
    return { 0.9F, 0.0F };
  }

  /** `TVector`: itk::Vector<double, 3>. */
  template <typename TVector>
  static TVector
  DirectionToLight(const TVector & right, const TVector & up, const TVector & forward)
  {
    TVector toLight = up * 0.5 - right * 0.4 - forward;
    toLight.Normalize();
    return toLight;
  }
};
} // namespace shapeton

#endif
