#ifndef shapetonDepthShading_h
#define shapetonDepthShading_h

#include "shapetonSurfaceRaster.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
/** \class DepthShading
 * \brief Darkens what lies farther away than the mean of its surroundings (Luft, Colditz, Deussen: Image enhancement by
 * unsharp masking the depth buffer, 2006). Samples without depth take no part. */
class DepthShading
{
public:
  /** `strength` in [0, 1]: the share of light that is taken at most. */
  DepthShading(const std::vector<SeenSample> & samples,
               unsigned int                    width,
               unsigned int                    height,
               double                          millimetresPerPixel,
               double                          strength);

  /** The share of light that a sample of a pixel keeps. */
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
  std::vector<float> m_MeanDepth; ///< of the surroundings of each pixel
  float              m_DarkDepth; ///< mm behind them that are darkest
  float              m_Strength;
};
} // namespace shapeton

#endif
