#include "shapetonLumenAlong.h"

#include "shapetonArcLengthField.h"
#include "shapetonParallelFor.h"

namespace shapeton
{
itk::Image<unsigned short, 3>::Pointer
LabelLumenAlong(const LumenMaskImage *                        lumen,
                const CurveSet &                              centerline,
                const std::function<unsigned short(double)> & labelOf)
{
  const ArcLengthField field(lumen, centerline);
  const auto           labels = itk::Image<unsigned short, 3>::New();
  const auto           region = lumen->GetBufferedRegion();
  labels->CopyInformation(lumen);
  labels->SetRegions(region);
  labels->Allocate(true);
  const std::size_t pixels = region.GetSize(0) * region.GetSize(1);
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
