#include "shapetonSurfaceRendering.h"

#include "shapetonSampleComposition.h"
#include "shapetonCurveTubes.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <stdexcept>

namespace shapeton
{
namespace
{
const RGBColor background = MakeColor(18, 19, 25);
const RGBColor annotation = MakeColor(214, 218, 226);

constexpr int marginOfScene = 12; // pixels

void
Require(bool condition, const char * what)
{
  if (!condition)
  {
    throw std::invalid_argument(what);
  }
}

void
Check(const SurfaceScene & scene)
{
  Require(!scene.surfaces.empty() || !scene.curves.empty() || !scene.markers.empty(), "a scene must not be empty");
  for (const SurfaceActor & actor : scene.surfaces)
  {
    Require(actor.surface && actor.surface->NumberOfVertices() > 0, "a surface of a scene must have vertices");
    const FaceMatrix & faces = actor.surface->F;
    const int          vertices = actor.surface->NumberOfVertices();
    Require(faces.size() == 0 || (faces.minCoeff() >= 0 && faces.maxCoeff() < vertices),
            "a face of a scene has an invalid vertex index");
    Require(actor.vertexColors.empty() || static_cast<int>(actor.vertexColors.size()) == vertices,
            "a surface of a scene requires a color for each vertex, or none");
    Require(actor.faceColors.empty() || static_cast<int>(actor.faceColors.size()) == faces.rows(),
            "a surface of a scene requires a color for each face, or none");
    Require(actor.opacity > 0.0 && actor.opacity <= 1.0, "the opacity of a surface must be above 0 and at most 1");
  }
  for (const CurveActor & actor : scene.curves)
  {
    Require(actor.curves != nullptr && actor.radius > 0.0, "curves of a scene require a radius above 0");
    for (const std::vector<int> & curve : actor.curves->curves)
    {
      Require(!curve.empty() && *std::min_element(curve.begin(), curve.end()) >= 0 &&
                *std::max_element(curve.begin(), curve.end()) < actor.curves->V.rows(),
              "a curve of a scene is empty or has an invalid vertex index");
    }
    Require(actor.vertexColors.empty() ||
              static_cast<Eigen::Index>(actor.vertexColors.size()) == actor.curves->V.rows(),
            "curves of a scene require a color for each vertex, or none");
  }
}

/** Extent of a scene to the right, up and away from the viewer. */
class SceneExtent
{
public:
  SceneExtent(const SurfaceScene & scene, const PatientViewOptions & options) : m_Options(options)
  {
    const PatientView direction(PatientView::PointType(0.0), 1.0, 1.0, options);
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Axes.row(i) << direction.GetRight()[i], direction.GetUp()[i], direction.GetForward()[i];
    }
    for (const SurfaceActor & actor : scene.surfaces)
    {
      this->Add(actor.surface->V, 0.0);
    }
    for (const CurveActor & actor : scene.curves)
    {
      this->Add(actor.curves->V, actor.radius);
    }
    for (const MarkerActor & marker : scene.markers)
    {
      this->Add(VertexMatrix(marker.point.transpose()), marker.radius);
    }
    Require(m_Lowest.allFinite() && m_Highest.allFinite(), "a scene must have points, all of them finite");
  }

  PatientView
  View() const
  {
    const Eigen::RowVector3d center = 0.5 * (m_Lowest + m_Highest) * m_Axes.transpose();
    Eigen::RowVector3d       half = 0.5 * (m_Highest - m_Lowest);
    if (half[0] <= 0.0 && half[1] <= 0.0)
    {
      half.setOnes(); // a single point has no extent
    }
    return { PatientView::PointType(center.data()), half[0], half[1], m_Options };
  }

private:
  void
  Add(const VertexMatrix & V, double radius)
  {
    for (Eigen::Index i = 0; i < V.rows(); ++i)
    {
      const Eigen::RowVector3d place = V.row(i) * m_Axes;
      // Unlike cwiseMin, this keeps a NaN.
      Require(place.allFinite(), "the points of a scene must be finite");
      m_Lowest = m_Lowest.cwiseMin(Eigen::RowVector3d(place.array() - radius));
      m_Highest = m_Highest.cwiseMax(Eigen::RowVector3d(place.array() + radius));
    }
  }

  PatientViewOptions m_Options;
  Eigen::Matrix3d    m_Axes; ///< columns: right, up, forward
  Eigen::RowVector3d m_Lowest = Eigen::RowVector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::RowVector3d m_Highest = Eigen::RowVector3d::Constant(-std::numeric_limits<double>::infinity());
};

/** Pixels of a picture available to the scene: all except the color bar. */
PatientViewOptions
SceneArea(const SurfaceRenderingOptions & options)
{
  PatientViewOptions area = options;
  const unsigned int bar = options.colorBar ? colorBarWidth : 0;
  Require(options.width > bar, "the picture of a scene is too narrow for its color bar");
  area.width -= bar;
  return area;
}

/** The projected scene; owns the meshes of tubes and balls. */
class ScreenScene
{
public:
  ScreenScene(const SurfaceScene & scene, const PatientView & view)
  {
    for (const SurfaceActor & actor : scene.surfaces)
    {
      m_Parts.push_back(ProjectMesh(*actor.surface, view));
      m_Parts.back().vertexColors = actor.vertexColors;
      m_Parts.back().faceColors = actor.faceColors;
      m_Parts.back().color = actor.color;
      m_Parts.back().opacity = static_cast<float>(actor.opacity);
    }
    for (const CurveActor & actor : scene.curves)
    {
      this->Add(TubesAround(actor), view);
    }
    this->Add(BallsAt(scene.markers), view);
  }

  const std::vector<ScreenPart> &
  GetParts() const
  {
    return m_Parts;
  }

private:
  void
  Add(ColoredMesh mesh, const PatientView & view)
  {
    m_Meshes.push_back(std::move(mesh.mesh));
    m_Parts.push_back(ProjectMesh(m_Meshes.back(), view));
    m_Parts.back().vertexColors = std::move(mesh.colors);
    m_Parts.back().hasDepthShading = false;
  }

  std::deque<SurfaceMesh> m_Meshes;
  std::vector<ScreenPart> m_Parts;
};

/** Box of a label, in pixels. */
struct Box
{
  int left, top, right, bottom;

  bool
  Meets(const Box & other) const
  {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/** Draws each label at the side of its marker where it does not overlap other labels, with a dark rim. */
void
DrawLabels(Picture * picture, const std::vector<MarkerActor> & markers, const PatientView & view, int width)
{
  const int        height = static_cast<int>(picture->GetBufferedRegion().GetSize(1));
  std::vector<Box> taken;
  TextStyle        style{ 16, {}, true };
  for (const MarkerActor & marker : markers)
  {
    const auto       place = view.Project(PatientView::PointType(marker.point.data()));
    const TextExtent extent = MeasureText(marker.label, style);
    const int        off = static_cast<int>(std::lround(marker.radius / view.GetMillimetersPerPixel())) + 5;
    const int        x = static_cast<int>(std::lround(place[0]));
    const int        y = static_cast<int>(std::lround(place[1]));
    const int        middle = y - extent.height / 2;
    const std::array<std::array<int, 2>, 4> corners{ { { { x + off, middle } },
                                                       { { x - off - extent.width, middle } },
                                                       { { x - extent.width / 2, y + off } },
                                                       { { x - extent.width / 2, y - off - extent.height } } } };
    const auto                              boxAt = [&](const std::array<int, 2> & corner) {
      return Box{ corner[0], corner[1], corner[0] + extent.width, corner[1] + extent.height };
    };
    const auto isFree = [&](const std::array<int, 2> & corner) {
      const Box box = boxAt(corner);
      return box.left >= 4 && box.top >= 4 && box.right <= width - 4 && box.bottom <= height - 4 &&
             std::none_of(taken.begin(), taken.end(), [&](const Box & other) { return box.Meets(other); });
    };
    const auto * found = std::find_if(corners.begin(), corners.end(), isFree);
    const Box    box = boxAt(found == corners.end() ? corners[0] : *found);
    taken.push_back(box);
    style.color = MixColors(marker.color, annotation, 0.5);
    DrawRimmedText(picture, marker.label, box.left, box.top, style, background);
  }
}

void
Annotate(Picture * picture, const PatientView & view, const SurfaceRenderingOptions & options, int width)
{
  constexpr int sceneTitleSize = 20;
  constexpr int sceneTitleHeight = 34;
  constexpr int besideTitle = 40; // free pixels between the title and the middle
  constexpr int belowLegend = 20;
  const int     height = static_cast<int>(picture->GetBufferedRegion().GetSize(1));
  int           top = 10;
  if (!options.title.empty())
  {
    TextStyle style{ sceneTitleSize, annotation, true };
    DrawText(picture, options.title, marginOfScene, top, FitText(options.title, style, width / 2 - besideTitle));
    top += sceneTitleHeight;
  }
  DrawLegend(picture, options.legend, marginOfScene, top, height / 2 - belowLegend, annotation);
  if (options.colorBar)
  {
    DrawColorBar(picture, width + 4, height / 8, height - height / 4, *options.colorBar, annotation);
  }
  if (options.annotations)
  {
    DrawScaleBar(picture, marginOfScene, height - marginOfScene, width / 4, view.GetMillimetersPerPixel(), annotation);
  }
}
} // namespace

PatientView
ViewOfScene(const SurfaceScene & scene, const SurfaceRenderingOptions & options)
{
  Check(scene);
  return SceneExtent(scene, SceneArea(options)).View();
}

Picture::Pointer
RenderSurfaces(const SurfaceScene & scene, const SurfaceRenderingOptions & options)
{
  const PatientView        view = ViewOfScene(scene, options);
  const PatientViewOptions area = SceneArea(options);
  const ScreenScene        screen(scene, view);
  const auto               samples = RasterizeParts(screen.GetParts(), area.width, area.height);
  const DepthShading       shading(
    samples, area.width, area.height, view.GetMillimetersPerPixel(), std::clamp(options.depthShading, 0.0, 1.0));
  auto picture = NewPicture(area.width, area.height, background);
  ComposeSamples(picture, samples, shading, background);
  if (options.annotations)
  {
    OrientationLettersStyle style;
    style.color = annotation;
    DrawOrientationLetters(picture, view.GetRight(), view.GetUp(), style);
  }
  DrawLabels(picture, scene.markers, view, static_cast<int>(area.width));
  auto page = NewPicture(options.width, options.height, background);
  PastePicture(page, picture, 0, 0);
  Annotate(page, view, options, static_cast<int>(area.width));
  return page;
}
} // namespace shapeton
