#include "shapetonColonPictures.h"

#include "shapetonCenterlineStations.h"
#include "shapetonSurfaceRendering.h"

#include <stdexcept>

namespace shapeton
{
namespace
{
const RGBColor glass = MakeColor(168, 186, 212);
const RGBColor bridge = MakeColor(250, 214, 60);

constexpr double opacityOfGlass = 0.3; // chosen by eye
constexpr double radiusOfLine = 1.8;   ///< mm
constexpr double radiusOfEnds = 4.5;   ///< mm

bool
IsBridged(const SurfaceArray * bridged, Eigen::Index face)
{
  return bridged && bridged->values(face, 0) != 0.0;
}

void
AddWall(SurfaceScene & scene, SurfaceRenderingOptions & options, const SurfaceMesh & wall, bool isSolid)
{
  SurfaceActor actor;
  actor.surface = &wall;
  actor.color = isSolid ? TissueColor : glass;
  actor.opacity = isSolid ? 1.0 : opacityOfGlass;
  const SurfaceArray * bridged = FindSurfaceArray(wall.cellArrays, "bridged");
  bool                 any = false;
  for (Eigen::Index face = 0; bridged && face < wall.F.rows(); ++face)
  {
    any = any || IsBridged(bridged, face);
  }
  if (any)
  {
    actor.faceColors.resize(wall.F.rows());
    for (Eigen::Index face = 0; face < wall.F.rows(); ++face)
    {
      actor.faceColors[face] = IsBridged(bridged, face) ? bridge : actor.color;
    }
    options.legend.push_back({ bridge, "bridge over a gap" });
  }
  scene.surfaces.push_back(actor);
}

void
AddCenterline(SurfaceScene & scene, SurfaceRenderingOptions & options, const CurveSet & centerline)
{
  const std::vector<CenterlineStation> stations = StationsOf(centerline);
  options.colorBar = DistanceScale(stations);
  CurveActor actor{ &centerline, radiusOfLine };
  actor.vertexColors.resize(centerline.V.rows());
  bool hasGaps = false;
  for (const CenterlineStation & station : stations)
  {
    actor.vertexColors[station.vertex] = station.isGap ? GapColor() : options.colorBar->ColorOf(station.distance);
    hasGaps = hasGaps || station.isGap;
  }
  if (hasGaps)
  {
    options.legend.push_back({ GapColor(), "gap in the lumen" });
  }
  scene.curves.push_back(actor);
}

void
AddEnds(SurfaceScene & scene, const CurveSet & centerline)
{
  const std::vector<CenterlineStation> stations = StationsOf(centerline);
  const ColorScale                     scale = DistanceScale(stations);
  scene.markers.push_back(
    { stations.front().point, radiusOfEnds, scale.ColorOf(stations.front().distance), "anal verge" });
  scene.markers.push_back({ stations.back().point, radiusOfEnds, scale.ColorOf(stations.back().distance), "cecum" });
}
} // namespace

Picture::Pointer
DrawColonWall(const ColonParts & colon, PatientSide side, bool isSolid)
{
  if (!colon.wall || (!isSolid && !colon.centerline))
  {
    throw std::invalid_argument("a picture of the colon requires a wall, and a centerline for the transparent view");
  }
  constexpr unsigned int  pictureWidth = 1000;
  constexpr unsigned int  pictureHeight = 860;
  SurfaceScene            scene;
  SurfaceRenderingOptions options;
  LookFrom(side, options);
  options.width = pictureWidth;
  options.height = pictureHeight;
  options.title = (isSolid ? "Wall, from the " : "Centerline, from the ") +
                  std::string(side == PatientSide::Anterior    ? "front"
                              : side == PatientSide::Posterior ? "back"
                                                               : NameOf(side));
  AddWall(scene, options, *colon.wall, isSolid);
  if (colon.centerline)
  {
    AddEnds(scene, *colon.centerline);
  }
  if (!isSolid)
  {
    AddCenterline(scene, options, *colon.centerline);
  }
  return RenderSurfaces(scene, options);
}
} // namespace shapeton
