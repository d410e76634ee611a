#include "shapetonFlatColonStrip.h"

#include "shapetonStripPainter.h"

#include <array>
#include <stdexcept>

namespace shapeton
{
FlatColonGridOptions
PictureGridOptions(double pixelSize)
{
  FlatColonGridOptions options;
  options.pixelSize = pixelSize;
  options.curvatureLength = 2.0;
  options.normalLength = 1.0;
  return options;
}

Picture::Pointer
ReduceStrip(const Picture * strip, unsigned int factor, unsigned int width, unsigned int height)
{
  const auto size = strip->GetLargestPossibleRegion().GetSize();
  if (factor < 1 || (width - 1) * factor >= size[0] || (height - 1) * factor >= size[1])
  {
    throw std::invalid_argument("the size of the strip must be a multiple of the reduced size");
  }
  std::array<float, 256> linear{};
  for (int i = 0; i < 256; ++i)
  {
    const auto gray = static_cast<unsigned char>(i);
    linear[i] = ToLinear(MakeColor(gray, gray, gray))[0];
  }
  const auto       reduced = NewPicture(width, height, RGBColor());
  const RGBColor * source = strip->GetBufferPointer();
  RGBColor * const target = reduced->GetBufferPointer();
  ParallelFor(height, [&](std::size_t row) {
    for (std::size_t column = 0; column < width; ++column)
    {
      LinearColor       sum = LinearColor::Zero();
      float             number = 0.0F;
      const std::size_t bottom = std::min<std::size_t>(size[1], (row + 1) * factor);
      const std::size_t right = std::min<std::size_t>(size[0], (column + 1) * factor);
      for (std::size_t y = row * factor; y < bottom; ++y)
      {
        for (std::size_t x = column * factor; x < right; ++x)
        {
          const RGBColor & color = source[y * size[0] + x];
          sum += LinearColor(linear[color[0]], linear[color[1]], linear[color[2]]);
          number += 1.0F;
        }
      }
      target[row * width + column] = FromLinear(sum / number);
    }
  });
  return reduced;
}
} // namespace shapeton
