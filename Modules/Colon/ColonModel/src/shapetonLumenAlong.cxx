#include "shapetonLumenAlong.h"

#include "shapetonArcLengthField.h"
#include "shapetonMappedImage.h"
#include "shapetonParallelFor.h"

namespace shapeton
{
itk::Image<unsigned short, 3>::Pointer
LabelLumenAlong(const LumenMaskImage *                        lumen,
                const CurveSet &                              centerline,
                const std::function<unsigned short(double)> & labelOf)
{
  const ArcLengthField field(lumen, centerline);
  const auto           region = lumen->GetBufferedRegion();
  const auto           labels = NewImageOn<itk::Image<unsigned short, 3>>(lumen, true);
  const std::size_t    pixels = region.GetSize(0) * region.GetSize(1);
  ParallelFor(region.GetSize(2), [&](std::size_t slice) {
    for (std::size_t voxel = slice * pixels; voxel < (slice + 1) * pixels; ++voxel)
    {
      if (lumen->GetBufferPointer()[voxel] != 0)
      {
        labels->GetBufferPointer()[voxel] = labelOf(field.ArcLengthOfVoxel(static_cast<std::int64_t>(voxel)));
      }
    }
  });
  return labels;
}
} // namespace shapeton
