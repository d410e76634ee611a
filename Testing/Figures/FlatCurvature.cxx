// Draws faces of a flat colon in the plane: red at vertices with Gaussian curvature (an angle defect), else green.
// usage: FlatCurvature FLAT.vtp PICTURE.png U_FIRST U_LAST V_FIRST V_LAST REACH (mm; faces within REACH of such a
// vertex are red)
#include "FigureProgram.h"

#include "shapetonExceptions.h"
#include "shapetonFlatDistortion.h"
#include "shapetonFlatSurface.h"
#include "shapetonPicture.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRendering.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace shapeton;

namespace
{
/** Faces with the vertices of the surface before the cut. */
FaceMatrix
FacesBeforeCut(const SurfaceMesh & flat, const std::vector<int> & source)
{
  FaceMatrix faces = flat.F;
  for (Eigen::Index i = 0; i < faces.size(); ++i)
  {
    faces.data()[i] = source[faces.data()[i]];
  }
  return faces;
}

void
Draw(const std::string & surface, const std::string & picture, const std::array<double, 5> & window)
{
  const SurfaceMesh         flat = ReadSurface(surface).mesh;
  const Eigen::MatrixX2d    uv = FlatCoordinates(flat, surface);
  const std::vector<int>    source = FlatSourcePoints(flat, surface);
  const FaceMatrix          faces = FacesBeforeCut(flat, source);
  const SurfaceConnectivity connectivity(faces, faces.maxCoeff() + 1);
  const Eigen::VectorXd     defects = FlatAngleDefects(faces, connectivity, PlacesOfCorners(flat.F, uv));
  constexpr double          leastDefect = 1e-6; // as in DetectHandles()
  SurfaceMesh               plane;
  plane.V = Eigen::MatrixX3d::Zero(flat.V.rows(), 3);
  plane.V.col(0) = uv.col(0);
  plane.V.col(2) = uv.col(1);
  plane.F = flat.F;
  std::vector<Eigen::Vector2d> curved;
  for (Eigen::Index i = 0; i < flat.V.rows(); ++i)
  {
    if (std::abs(defects[source[i]]) > leastDefect)
    {
      curved.emplace_back(uv.row(i));
    }
  }
  std::vector<int>      shown;
  std::vector<RGBColor> colors;
  for (int face = 0; face < flat.NumberOfFaces(); ++face)
  {
    const Eigen::Vector2d at = uv.row(flat.F(face, 0));
    if (at[0] >= window[0] && at[0] <= window[1] && at[1] >= window[2] && at[1] <= window[3])
    {
      bool isCurved = false;
      for (int k = 0; k < 3; ++k)
      {
        const Eigen::Vector2d corner = uv.row(flat.F(face, k));
        isCurved |= std::any_of(curved.begin(), curved.end(), [&](const Eigen::Vector2d & point) {
          return (corner - point).squaredNorm() <= window[4] * window[4];
        });
      }
      shown.push_back(face);
      colors.push_back(isCurved ? MakeColor(220, 20, 20) : MakeColor(70, 170, 80));
    }
  }
  const SurfaceMesh part = FacesOfSurface(plane, shown);
  SurfaceActor      actor;
  actor.surface = &part;
  actor.faceColors = colors;
  SurfaceScene scene;
  scene.surfaces.push_back(actor);
  SurfaceRenderingOptions options;
  options.width = 1000;
  options.height = static_cast<unsigned int>(1000.0 * (window[3] - window[2]) / (window[1] - window[0]));
  options.annotations = false;
  options.depthShading = 0.0;
  WritePng(RenderSurfaces(scene, options), picture);
}
} // namespace

int
main(int argc, char * argv[])
{
  return RunFigureProgram(argc,
                          argv,
                          { 7, 7 },
                          "FLAT.vtp PICTURE.png U_FIRST U_LAST V_FIRST V_LAST REACH",
                          [](const std::vector<std::string> & arguments) {
                            std::array<double, 5> window{};
                            std::transform(arguments.begin() + 2,
                                           arguments.end(),
                                           window.begin(),
                                           [](const std::string & text) { return std::stod(text); });
                            Draw(arguments[0], arguments[1], window);
                          });
}
