#include "shapetonLumenAlong.h"

#include "shapetonArcLengthField.h"
#include "shapetonParallelFor.h"

namespace shapeton
{
itk::Image<unsigned short, 3>::Pointer
LabelLumenAlong(const LumenMaskImage *                        lumen,
                const CurveSet &                              centreline,
                const std::function<unsigned short(double)> & labelOf)
{
  const ArcLengthField field(lumen, centreline);
  const auto           labels = itk::Image<unsigned short, 3>::New();
  const auto           region = lumen->GetBufferedRegion();
  labels->CopyInformation(lumen);
  labels->SetRegions(region);
  labels->Allocate(true);
  const GridGeometry grid(lumen);
  const auto         columns = region.GetSize(0);
  const auto         pixels = columns * region.GetSize(1);
  ParallelFor(region.GetSize(2), [&](std::size_t slice) {
    for (std::size_t i = 0; i < pixels; ++i)
    {
      const std::size_t voxel = slice * pixels + i;
      if (lumen->GetBufferPointer()[voxel] != 0)
      {
        const Eigen::Vector3d index(i % columns, i / columns, slice);
        labels->GetBufferPointer()[voxel] = labelOf(field.ArcLengthAt(grid.PointOf(index)));
      }
    }
  });
  return labels;
}
} // namespace shapeton
