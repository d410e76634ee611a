#ifndef shapetonDepthShading_h
#define shapetonDepthShading_h

#include "shapetonSurfaceRaster.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
/** \class DepthShading
 * \brief Darkens samples that are farther away than the mean of their surroundings (Luft, Colditz, Deussen: Image
 * enhancement by unsharp masking the depth buffer, 2006). Samples without depth are ignored. */
class DepthShading
{
public:
  /** `strength` in [0, 1]: the maximum fraction of light removed. */
  DepthShading(const std::vector<SeenSample> & samples,
               unsigned int                    width,
               unsigned int                    height,
               double                          millimetersPerPixel,
               double                          strength);

  /** Fraction of light that a sample of a pixel keeps. */
  float
  LightOf(const SeenSample & sample, std::size_t pixel) const
  {
    if (m_Strength <= 0.0F || !std::isfinite(sample.depth))
    {
      return 1.0F;
    }
    return 1.0F - m_Strength * std::clamp((sample.depth - m_MeanDepth[pixel]) / m_DarkDepth, 0.0F, 1.0F);
  }

private:
  std::vector<float> m_MeanDepth; ///< mean depth around each pixel
  float              m_DarkDepth; ///< distance behind them of maximum darkening, mm
  float              m_Strength;
};
} // namespace shapeton

#endif
