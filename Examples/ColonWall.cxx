// Computes the wall of a synthetic colon, and cuts handles where loops of the lumen touch in a coarse mask.
// Usage: ExampleColonWall WALL.vtp
#include "shapetonColonPhantomImageSource.h"
#include "shapetonColonWall.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceWriter.h"

#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " WALL.vtp\n";
    return 2;
  }
  const auto phantom = shapeton::ColonPhantomImageSource::New();
  phantom->SetSize({ { 96, 96, 90 } });
  phantom->SetSpacing(shapeton::ColonPhantomImageSource::SpacingType(3.7)); // mm
  phantom->CenterOutput();
  phantom->TruthOnlyOn();
  phantom->Update();

  const auto                    occupancy = shapeton::OccupancyFromMask(phantom->GetLumenOutput());
  const shapeton::LumenTopology repaired = shapeton::RepairLumenTopology(occupancy, phantom->GetAnatomy().Centerline());
  const shapeton::SurfaceMesh   wall = shapeton::ExtractWall(occupancy, repaired.mask);
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(wall);
  const shapeton::SurfaceQuality raw = shapeton::InspectSurface(shapeton::ExtractWall(occupancy));
  shapeton::WriteSurface(wall, argv[1]);
  std::cout << quality.faces << " faces, genus " << quality.genus.value_or(-1) << " instead of "
            << raw.genus.value_or(-1) << "; " << repaired.report.cutVolume << " ml of " << repaired.report.lumenVolume
            << " ml were cut away\n";
}
