#include "shapetonColonLandmarkPictures.h"

#include "shapetonFlatColonAxis.h"
#include "shapetonFlatColonLocator.h"
#include "shapetonFlatColonOverlay.h"
#include "shapetonFlatColonPage.h"
#include "shapetonFlatColonStrip.h"
#include "shapetonSurfaceRendering.h"

#include <array>

namespace shapeton
{
namespace
{
const RGBColor colorOfLoops = MakeColor(20, 20, 20);
const RGBColor colorOfValve = MakeColor(60, 200, 90);
const RGBColor colorOfMarkers = MakeColor(255, 255, 255);
const RGBColor colorOfSurfaceFolds = MakeColor(52, 96, 196);

/** Radii of tubes and balls in a scene, mm. */
constexpr double radiusOfTaeniae = 1.6;
constexpr double radiusOfLoops = 2.2;
constexpr double radiusOfMarkers = 4.0;
constexpr double radiusOfValve = 5.0;

/** Segments have the numbers 1 to 6; 0 is an unknown segment. */
constexpr int lastSegment = 6;

SurfaceRenderingOptions
OptionsFor(PatientSide side, const std::string & title)
{
  constexpr unsigned int  pixels = 900;
  SurfaceRenderingOptions options;
  options.width = pixels;
  options.height = pixels;
  options.title = title + ", " + NameOf(side);
  LookFrom(side, options);
  return options;
}

void
AddSegmentLegend(const ColonSegments & segments, SurfaceRenderingOptions & options)
{
  std::array<bool, lastSegment + 1> isThere{};
  for (const int segment : segments.segmentOfFace)
  {
    isThere[segment] = true;
  }
  for (int segment = 0; segment <= lastSegment; ++segment)
  {
    if (isThere[segment])
    {
      options.legend.push_back({ ColorOfSegment(segment), NameOfSegment(segment) });
    }
  }
}

/** Point of the loop nearest to the viewer, because labels inside the colon would be hidden. */
Eigen::Vector3d
FrontOfLoop(const ColonLandmarks & landmarks, const SegmentBorder & border, const PatientView & view)
{
  Eigen::Vector3d best = border.point;
  const auto &    to = view.GetForward();
  double          least = 1e30;
  for (const int vertex : border.loop.vertices)
  {
    const auto   point = landmarks.tube->Points().row(vertex);
    const double depth = point[0] * to[0] + point[1] * to[1] + point[2] * to[2];
    if (depth < least)
    {
      least = depth;
      best = point.transpose();
    }
  }
  return best;
}

void
AddTaeniae(const ColonTaeniae & taeniae, std::vector<CurveSet> & sets, SurfaceScene & scene)
{
  for (std::size_t t = 0; t < taeniae.taeniae.size(); ++t)
  {
    ColonTaeniae one;
    one.taeniae.push_back(taeniae.taeniae[t]);
    sets.push_back(TaeniaCurves(one));
  }
  for (std::size_t t = 0; t < sets.size(); ++t)
  {
    scene.curves.push_back({ &sets[t], radiusOfTaeniae, ColorOfTaenia(static_cast<int>(t) + 1) });
  }
}

/** Closed path on the map as a line. */
FlatLine
LineOfLoop(const ColonWallTube & tube, const SurfaceWalk & loop)
{
  FlatLine line{ {}, colorOfLoops, 3.0 };
  for (const int vertex : loop.vertices)
  {
    line.places.push_back(tube.Uv(vertex));
  }
  line.places.push_back(line.places.front());
  return line;
}

void
DrawOnStrip(const ColonLandmarks & landmarks, const FlatColonGrid & grid, Picture * strip)
{
  for (std::size_t t = 0; t < landmarks.taeniae.taeniae.size(); ++t)
  {
    DrawFlatLine(strip, grid, { landmarks.taeniae.taeniae[t].uv, ColorOfTaenia(static_cast<int>(t) + 1), 2.0 });
  }
  for (const SegmentBorder & border : landmarks.segments.borders)
  {
    DrawFlatLine(strip, grid, LineOfLoop(*landmarks.tube, border.loop));
  }
  if (landmarks.valve)
  {
    DrawFlatDot(strip, grid, { landmarks.valveUv, colorOfValve, 6.0 });
  }
  for (const UsedMarker & marker : landmarks.taeniae.markers)
  {
    DrawFlatDot(strip, grid, { FlatColonLocator(grid).Find(marker.point).uv, colorOfMarkers, 4.0 });
  }
}

FlatAnnotation
SegmentAnnotation(const std::string & name, double begin)
{
  return { FlatAnnotation::Kind::Segment, name, {}, {}, begin };
}

std::vector<FlatAnnotation>
SegmentNames(const ColonSegments & segments)
{
  std::vector<FlatAnnotation> annotations;
  const auto                  add = [&annotations](int segment, double distance) {
    annotations.push_back(SegmentAnnotation(NameOfSegment(segment), distance));
  };
  if (!segments.borders.empty() && segments.borders.front().number == 1)
  {
    add(1, 0.0);
  }
  for (std::size_t i = 0; i < segments.borders.size(); ++i)
  {
    const int  number = segments.borders[i].number;
    const bool isKnown =
      number == 5 || (i + 1 < segments.borders.size() && segments.borders[i + 1].number == number + 1);
    add(isKnown ? number + 1 : 0, segments.borders[i].arcLength);
  }
  return annotations;
}
} // namespace

RGBColor
ColorOfSegment(int segment)
{
  static const RGBColor colors[lastSegment + 1] = { MakeColor(170, 170, 170), MakeColor(214, 120, 108),
                                                    MakeColor(232, 182, 92),  MakeColor(150, 186, 96),
                                                    MakeColor(96, 178, 176),  MakeColor(110, 140, 208),
                                                    MakeColor(176, 120, 190) };
  return colors[segment >= 1 && segment <= lastSegment ? segment : 0];
}

RGBColor
ColorOfTaenia(int taenia)
{
  static const RGBColor yellow = MakeColor(255, 214, 10);
  static const RGBColor blue = MakeColor(30, 144, 255);
  static const RGBColor pink = MakeColor(255, 60, 160);
  return taenia == 1 ? yellow : taenia == 2 ? blue : pink;
}

std::vector<FlatAnnotation>
SegmentAnnotations(const std::vector<ColonSegmentExtent> & segments)
{
  std::vector<FlatAnnotation> annotations;
  for (const ColonSegmentExtent & segment : segments)
  {
    annotations.push_back(SegmentAnnotation(segment.name, segment.begin));
  }
  return annotations;
}

Picture::Pointer
DrawColonLandmarks(const ColonLandmarkParts & parts, PatientSide side)
{
  const ColonLandmarks &  landmarks = *parts.landmarks;
  SurfaceRenderingOptions options = OptionsFor(side, "Segments, taeniae and flexures");
  AddSegmentLegend(landmarks.segments, options);
  SurfaceScene scene;
  SurfaceActor wall;
  wall.surface = &parts.flat->Surface();
  for (const int segment : landmarks.segments.segmentOfFace)
  {
    wall.faceColors.push_back(ColorOfSegment(segment));
  }
  scene.surfaces.push_back(wall);
  std::vector<CurveSet> taeniae;
  AddTaeniae(landmarks.taeniae, taeniae, scene);
  const CurveSet loops = FlexureCurves(landmarks);
  if (!loops.curves.empty())
  {
    scene.curves.push_back({ &loops, radiusOfLoops, colorOfLoops });
  }
  const PatientView view = ViewOfScene(scene, options);
  for (const SegmentBorder & border : landmarks.segments.borders)
  {
    if (border.number <= 4)
    {
      scene.markers.push_back(
        { FrontOfLoop(landmarks, border, view), radiusOfMarkers, colorOfLoops, NameOfFlexure(border.number) });
    }
  }
  if (landmarks.valve)
  {
    scene.markers.push_back({ landmarks.valve->position, radiusOfValve, colorOfValve, "ileocecal valve" });
  }
  for (const UsedMarker & marker : landmarks.taeniae.markers)
  {
    scene.markers.push_back({ marker.point, radiusOfMarkers, colorOfMarkers, "marker" });
  }
  return RenderSurfaces(scene, options);
}

Picture::Pointer
DrawSurfaceFolds(const ColonLandmarkParts & parts, PatientSide side)
{
  SurfaceScene scene;
  SurfaceActor wall;
  wall.surface = &parts.flat->Surface();
  for (const int fold : parts.landmarks->folds.foldOfFace)
  {
    wall.faceColors.push_back(fold > 0 ? colorOfSurfaceFolds : TissueColor);
  }
  scene.surfaces.push_back(wall);
  return RenderSurfaces(
    scene, OptionsFor(side, std::to_string(parts.landmarks->folds.number) + " folds found on the surface"));
}

Picture::Pointer
DrawFlatLandmarks(const ColonLandmarkParts & parts, int greatestColumns)
{
  constexpr double     pixelSize = 0.7; // mm of the map
  FlatColonGridOptions gridOptions;
  gridOptions.normalLength = 1.0;
  gridOptions.pixelSize = pixelSize;
  const FlatColonGrid &  grid = parts.flat->Grid(gridOptions);
  const Picture::Pointer strip = PaintFlatRelief(grid, parts.flat->Axis(gridOptions));
  std::vector<double>    distances;
  for (int column = 0; column < grid.Columns(); ++column)
  {
    distances.push_back(parts.landmarks->tube->ArcLengthOfU(grid.UvOfPixel(column, 0).x()));
  }
  if (parts.landmarks->hindered)
  {
    DrawFlatHatching(strip, grid, distances, *parts.landmarks->hindered);
  }
  DrawOnStrip(*parts.landmarks, grid, strip);
  FlatColonPageOptions options{
    "Taeniae and flexures on the flat colon",
    std::string("Yellow, blue, pink: taeniae 1 to 3; black: borders of segments; ") +
      (parts.landmarks->valve ? "green: ileocecal valve; " : "") +
      "white: markers that were set. Seen from the lumen, rectum at the left. For research use; not a "
      "diagnosis.",
    greatestColumns
  };
  return DrawFlatColonPage(strip, grid, distances, SegmentNames(parts.landmarks->segments), options);
}
} // namespace shapeton
