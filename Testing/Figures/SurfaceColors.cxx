// Draws a surface in space, colored by a point array from blue over white to red.
// usage: SurfaceColors SURFACE.vtp PICTURE.png ARRAY LEAST GREATEST AZIMUTH (degrees, 0 from the front)
#include "shapetonExceptions.h"
#include "shapetonPicture.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRendering.h"

#include <algorithm>
#include <iostream>

using namespace shapeton;

namespace
{
RGBColor
BlueWhiteRed(double share)
{
  static const RGBColor blue = MakeColor(40, 80, 200);
  static const RGBColor white = MakeColor(240, 240, 235);
  static const RGBColor red = MakeColor(200, 30, 30);
  const double          t = std::clamp(share, 0.0, 1.0);
  return t < 0.5 ? MixColors(blue, white, 2.0 * t) : MixColors(white, red, 2.0 * t - 1.0);
}

void
Draw(const std::vector<std::string> & arguments)
{
  const SurfaceMesh          mesh = ReadSurface(arguments[0]).mesh;
  const SurfaceArray * const array = FindSurfaceArray(mesh.pointArrays, arguments[2]);
  if (array == nullptr)
  {
    throw InputError('"' + arguments[0] + "\" has no point array " + arguments[2]);
  }
  const double least = std::stod(arguments[3]);
  const double greatest = std::stod(arguments[4]);
  SurfaceActor actor;
  actor.surface = &mesh;
  for (Eigen::Index vertex = 0; vertex < mesh.V.rows(); ++vertex)
  {
    actor.vertexColors.push_back(BlueWhiteRed((array->values(vertex, 0) - least) / (greatest - least)));
  }
  SurfaceScene scene;
  scene.surfaces.push_back(actor);
  SurfaceRenderingOptions options;
  options.azimuth = std::stod(arguments[5]);
  WritePng(RenderSurfaces(scene, options), arguments[1]);
}
} // namespace

int
main(int argc, char * argv[])
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments.back() == "--quiet") // as for the tools
  {
    arguments.pop_back();
  }
  if (arguments.size() != 6)
  {
    std::cerr << "usage: SurfaceColors SURFACE.vtp PICTURE.png ARRAY LEAST GREATEST AZIMUTH\n";
    return 2;
  }
  try
  {
    Draw(arguments);
  }
  catch (const Exception & error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return EXIT_SUCCESS;
}
