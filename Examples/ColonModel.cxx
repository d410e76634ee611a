// Computes the centerline and the handle-free wall of a synthetic colon from a mask of its lumen. Usage:
// ExampleColonModel WALL.vtp CENTERLINE.vtp
#include "shapetonColonAnatomy.h"
#include "shapetonColonModel.h"
#include "shapetonSurfaceWriter.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " WALL.vtp CENTERLINE.vtp\n";
    return 2;
  }
  const shapeton::ColonAnatomy anatomy{ shapeton::ColonPhantomParameters() };
  Eigen::Vector3d              low, high;
  anatomy.BoundingBox(4.0, low, high);

  const auto      lumen = shapeton::LumenMask::New();
  constexpr float spacing = 2.0F; // mm
  itk::Size<3>    size;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<itk::SizeValueType>((high[axis] - low[axis]) / spacing) + 1;
  }
  lumen->SetRegions(size);
  lumen->SetSpacing(shapeton::LumenMask::SpacingType(spacing));
  lumen->SetOrigin(low.data());
  lumen->Allocate();
  for (itk::ImageRegionIteratorWithIndex<shapeton::LumenMask> voxel(lumen, size); !voxel.IsAtEnd(); ++voxel)
  {
    const auto point = lumen->TransformIndexToPhysicalPoint<double>(voxel.GetIndex());
    voxel.Set(anatomy.Evaluate({ point[0], point[1], point[2] }).distance > 0.0);
  }

  shapeton::ColonModelSettings options;
  options.faces = 20000;
  const shapeton::ColonModel colon = shapeton::BuildColonModelOfLumen(lumen, options);
  shapeton::WriteSurface(colon.wall.simplified, argv[1]);
  shapeton::WriteCurves(colon.centerline.curve, argv[2]);
  std::cout << "a colon of " << static_cast<int>(colon.centerline.length / 100.0) << " dm, wall of genus "
            << colon.wall.report.repairedGenus << " instead of " << colon.wall.report.rawGenus << '\n';
}
