// Distances between shape signatures: of two copies of one shape in different images, and of two different shapes.
// Usage: ExampleShapeSignature
#include "shapetonLabelShapes.h"
#include "shapetonShapeSearch.h"

#include <cmath>
#include <iostream>

namespace
{
/** An image with 1 mm voxels that is 1 in an ellipsoid. */
shapeton::LabelMap::Pointer
Ellipsoid(double a, double b, double c)
{
  const auto image = shapeton::LabelMap::New();
  image->SetRegions(shapeton::LabelMap::SizeType{ { 60, 60, 60 } });
  image->Allocate(true);
  const shapeton::VoxelGrid grid(60, 60, 60);
  for (std::size_t p = 0; p < grid.NumberOfVoxels(); ++p)
  {
    const auto v = grid.Voxel(p);
    const bool isIn = std::hypot((v[0] - 30.0) / a, (v[1] - 30.0) / b, (v[2] - 30.0) / c) <= 1.0;
    image->GetBufferPointer()[p] = isIn ? 1.0F : 0.0F;
  }
  return image;
}

shapeton::ShapeSignature
SignatureOf(const shapeton::LabelMap * image)
{
  return shapeton::ComputeShapeSignature(shapeton::VoxelsOfLabel(image, 1), image);
}
} // namespace

int
main()
{
  const auto large = SignatureOf(Ellipsoid(12.0, 18.0, 26.0));
  const auto small = SignatureOf(Ellipsoid(13.0, 6.0, 9.0)); // half the size, rotated
  const auto other = SignatureOf(Ellipsoid(18.0, 18.0, 18.0));
  std::cout << "a copy is " << shapeton::SignatureDistance(large, small) << " away, another shape "
            << shapeton::SignatureDistance(large, other) << '\n';
  const auto found = shapeton::FindShape(small, { { "ball", other }, { "ellipsoid", large } }, { 1 });
  std::cout << "found as entry " << found.neighbors[0].entry << (found.IsUnknown() ? ", but uncertain" : "") << '\n';
}
