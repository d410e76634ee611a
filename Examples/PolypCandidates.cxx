// Finds a polyp of 10 mm on the wall of a synthetic tube that also has a fold of the same height.
// Usage: ExamplePolypCandidates
#include "shapetonColonWall.h"
#include "shapetonPolypCandidates.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <algorithm>
#include <cmath>
#include <iostream>

int
main()
{
  constexpr double spacing = 0.8; // mm
  const auto       occupancy = shapeton::OccupancyImage::New();
  const double     origin[3] = { -34.0, -26.0, -26.0 };
  occupancy->SetRegions(shapeton::OccupancyImage::SizeType{ { 86, 66, 66 } });
  occupancy->SetSpacing(shapeton::OccupancyImage::SpacingType(spacing));
  occupancy->SetOrigin(origin);
  occupancy->Allocate();
  for (itk::ImageRegionIteratorWithIndex<shapeton::OccupancyImage> voxel(occupancy, occupancy->GetBufferedRegion());
       !voxel.IsAtEnd();
       ++voxel)
  {
    const auto   p = occupancy->TransformIndexToPhysicalPoint<double>(voxel.GetIndex());
    const double axis = std::hypot(p[1], p[2]);
    const double tube = std::min(20.0 - axis, 28.0 - std::abs(p[0]));
    const double polyp = std::sqrt(std::pow(p[0] - 10.0, 2) + p[1] * p[1] + std::pow(p[2] + 18.0, 2)) - 5.0;
    const double fold = std::hypot(p[0] + 10.0, std::max(0.0, 15.5 - axis)) - 1.5; // a ring
    const double depth = std::min({ tube, polyp, fold });                          // mm inside the lumen
    voxel.Set(static_cast<float>(std::min(1.0, std::max(0.0, 0.5 + 0.5 * depth / spacing))));
  }
  const shapeton::SurfaceMesh wall = shapeton::ExtractWall(occupancy);
  const auto                  candidates = shapeton::FindPolypCandidates(wall);
  std::cout << candidates.size() << " candidate for " << wall.NumberOfFaces() << " faces\n";
  for (const shapeton::PolypCandidate & candidate : candidates)
  {
    std::cout << "number " << candidate.number << ": score " << candidate.score << ", diameter " << candidate.diameter
              << " mm (" << shapeton::NameOf(shapeton::SizeOf(candidate.diameter)) << "), "
              << (candidate.position - Eigen::Vector3d(10.0, 0.0, -18.0)).norm() << " mm from the center of the ball\n";
  }
}
