#include "shapetonConformalMapPicture.h"

#include "shapetonHolomorphicForm.h"
#include "shapetonPi.h"
#include "shapetonRefinedPattern.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
RGBColor
ColorOfBoundary(std::size_t boundary)
{
  static const std::array<RGBColor, 9> colors{ MakeColor(250, 214, 60),  MakeColor(214, 39, 40),
                                               MakeColor(44, 160, 44),   MakeColor(255, 127, 14),
                                               MakeColor(148, 80, 190),  MakeColor(23, 170, 190),
                                               MakeColor(227, 119, 194), MakeColor(188, 220, 34),
                                               MakeColor(140, 86, 75) };
  return colors[boundary % colors.size()];
}

/** Each boundary as a closed curve. */
std::vector<CurveSet>
CurvesOf(const std::vector<BoundaryLoop> & boundaries, const VertexMatrix & V)
{
  std::vector<CurveSet> sets;
  for (const BoundaryLoop & boundary : boundaries)
  {
    CurveSet         set;
    std::vector<int> curve;
    set.V.resize(static_cast<Eigen::Index>(boundary.vertices.size()), 3);
    for (std::size_t i = 0; i < boundary.vertices.size(); ++i)
    {
      set.V.row(static_cast<Eigen::Index>(i)) = V.row(boundary.vertices[i]);
      curve.push_back(static_cast<int>(i));
    }
    curve.push_back(0);
    set.curves.push_back(curve);
    sets.push_back(set);
  }
  return sets;
}

PlanePattern
PatternOf(const ConformalMap & map, int checks)
{
  const auto   uv = FlatCoordinates(map.flat, "the map");
  const double longer = (uv.colwise().maxCoeff() - uv.colwise().minCoeff()).maxCoeff();
  if (map.domain != ConformalDomain::Rectangle)
  {
    return PolarCheckerboard(checks);
  }
  if (map.loops.size() == 1)
  {
    return Checkerboard(longer / checks);
  }
  // An even number of checks per turn makes the pattern continuous across the cut.
  const double circumference = FlatCircumference(map.flat, "the map");
  const double around = 2.0 * std::max(1.0, std::round(0.5 * checks * circumference / longer));
  return Checkerboard(circumference / around);
}
} // namespace

SurfaceMesh
PlaneOf(const SurfaceMesh & flat, const Eigen::MatrixX2d & uv)
{
  SurfaceMesh plane;
  plane.F = flat.F;
  plane.V = VertexMatrix::Zero(flat.V.rows(), 3);
  plane.V.col(0) = uv.col(0);
  plane.V.col(2) = uv.col(1);
  return plane;
}

Picture::Pointer
DrawPattern(const SurfaceMesh &               shape,
            const Eigen::MatrixX2d &          uv,
            const PlanePattern &              pattern,
            const std::vector<BoundaryLoop> & boundaries,
            const SurfaceRenderingOptions &   options)
{
  constexpr double            radiusOfCurves = 0.003; // fraction of the extent
  const ColoredSurface        refined = RefineForPattern(shape, uv, pattern);
  const std::vector<CurveSet> curves = CurvesOf(boundaries, shape.V);
  const double                extent = (shape.V.colwise().maxCoeff() - shape.V.colwise().minCoeff()).norm();
  SurfaceScene                scene;
  SurfaceActor                actor;
  actor.surface = &refined.mesh;
  actor.faceColors = refined.faceColors;
  scene.surfaces.push_back(actor);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    scene.curves.push_back({ &curves[i], radiusOfCurves * extent, ColorOfBoundary(i) });
  }
  return RenderSurfaces(scene, options);
}

void
LookAtSurface(const SurfaceMesh & mesh, PatientViewOptions & options)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double          area = 0.0;
  for (Eigen::Index face = 0; face < mesh.F.rows(); ++face)
  {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0));
    const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 1));
    const Eigen::Vector3d c = mesh.V.row(mesh.F(face, 2));
    const Eigen::Vector3d twice = (b - a).cross(c - a);
    normal += twice;
    area += twice.norm();
  }
  constexpr double least = 0.2;
  if (normal.norm() > least * area)
  {
    normal.normalize();
    options.azimuth = DegreesPerRadian * std::atan2(normal.x(), -normal.y());
    options.elevation = DegreesPerRadian * std::asin(std::clamp(normal.z(), -1.0, 1.0));
  }
}

namespace
{
/** The surface at the left, the plane at the right. */
Picture::Pointer
DrawBoth(const SurfaceMesh &                flat,
         const Eigen::MatrixX2d &           uv,
         const PlanePattern &               pattern,
         const std::vector<BoundaryLoop> &  loops,
         const ConformalMapPictureOptions & options)
{
  SurfaceRenderingOptions view;
  view.width = options.width / 2;
  view.height = options.height;
  view.annotations = false;
  view.depthShading = 0.0;
  const auto plane = DrawPattern(PlaneOf(flat, uv), uv, pattern, loops, view);
  LookAtSurface(flat, view);
  const auto space = DrawPattern(flat, uv, pattern, loops, view);
  const auto picture = NewPicture(2 * view.width, view.height, MakeColor(255, 255, 255));
  PastePicture(picture, space, 0, 0);
  PastePicture(picture, plane, static_cast<int>(view.width), 0);
  return picture;
}
} // namespace

Picture::Pointer
DrawConformalMap(const ConformalMap & map, const ConformalMapPictureOptions & options)
{
  return DrawBoth(map.flat, FlatCoordinates(map.flat, "the map"), PatternOf(map, options.checks), map.loops, options);
}

Picture::Pointer
DrawFlatSurface(const SurfaceMesh & flat, const std::string & what, const ConformalMapPictureOptions & options)
{
  const auto   uv = FlatCoordinates(flat, what);
  const double longer = (uv.colwise().maxCoeff() - uv.colwise().minCoeff()).maxCoeff();
  return DrawBoth(flat, uv, Checkerboard(longer / options.checks), {}, options);
}

Picture::Pointer
DrawHolomorphicForms(const ConformalMap & map, unsigned int panel)
{
  constexpr int    captionHeight = 30;
  constexpr double distance = 0.05; // between level sets
  const auto       forms = HolomorphicFormsOf(map);
  const auto       side = static_cast<int>(panel);
  const auto       picture =
    NewPicture(3 * panel, static_cast<unsigned int>(forms.size()) * (panel + captionHeight), MakeColor(255, 255, 255));
  SurfaceRenderingOptions view;
  view.width = panel;
  view.height = panel;
  view.annotations = false;
  view.depthShading = 0.0;
  LookAtSurface(map.flat, view);
  int top = 0;
  for (const HolomorphicForm & form : forms)
  {
    const Eigen::MatrixX2d turned = form.values.rowwise().reverse();
    const PlanePattern     conjugate = LevelSets(turned.col(0).minCoeff(), turned.col(0).maxCoeff(), distance);
    const auto             put = [&](int column, const std::string & caption, const Picture * drawn) {
      DrawText(picture, caption, column * side + 8, top + 6, TextStyle());
      PastePicture(picture, drawn, column * side, top + captionHeight);
    };
    const std::string name = "f" + std::to_string(form.inner + 1);
    put(0,
        name + ", 1 on boundary " + std::to_string(form.inner + 1),
        DrawPattern(form.mesh, form.values, LevelSets(0.0, 1.0, distance), map.loops, view));
    put(1, "conjugate of " + name, DrawPattern(form.mesh, turned, conjugate, map.loops, view));
    put(2, "both", DrawPattern(form.mesh, form.values, Checkerboard(distance), map.loops, view));
    top += side + captionHeight;
  }
  return picture;
}
} // namespace shapeton
