#include "shapetonSampleComposition.h"

#include <algorithm>

namespace shapeton
{
void
ComposeSamples(Picture *                       picture,
               const std::vector<SeenSample> & samples,
               const DepthShading &            shading,
               const RGBColor &                background)
{
  const std::size_t width = picture->GetBufferedRegion().GetSize(0);
  const std::size_t pixels = picture->GetBufferedRegion().GetNumberOfPixels();
  constexpr float   share = 1.0F / (samplesAlongPixel * samplesAlongPixel);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    float seen[4] = { 0.0F, 0.0F, 0.0F, 0.0F };
    for (int k = 0; k < samplesAlongPixel * samplesAlongPixel; ++k)
    {
      const std::size_t  row = pixel / width * samplesAlongPixel + k / samplesAlongPixel;
      const std::size_t  column = pixel % width * samplesAlongPixel + k % samplesAlongPixel;
      const SeenSample & sample = samples[row * width * samplesAlongPixel + column];
      const float        light = shading.LightOf(sample, pixel);
      for (int channel = 0; channel < 3; ++channel)
      {
        seen[channel] += share * light * sample.color[channel];
      }
      seen[3] += share * sample.coverage;
    }
    for (unsigned int channel = 0; channel < 3; ++channel)
    {
      const float value = seen[channel] + (1.0F - seen[3] / 255.0F) * background[channel];
      picture->GetBufferPointer()[pixel][channel] = static_cast<unsigned char>(std::clamp(value + 0.5F, 0.0F, 255.0F));
    }
  }
}
} // namespace shapeton
