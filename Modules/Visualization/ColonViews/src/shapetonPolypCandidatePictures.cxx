#include "shapetonPolypCandidatePictures.h"

#include "shapetonCandidateCrops.h"
#include "shapetonEndoscope.h"

#include "shapetonFlatColonLocator.h"
#include "shapetonFacePlace.h"
#include "shapetonFlatColonPictures.h"
#include "shapetonPageColors.h"
#include "shapetonParallelFor.h"
#include "shapetonPictureAnnotation.h"
#include "shapetonPolypSearch.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

/** Layout, pixels. */
constexpr unsigned int viewWidth = 400;
constexpr unsigned int viewHeight = 300;
constexpr unsigned int cropSize = 252;
constexpr int          cardGap = 6;
constexpr int          cardLabel = 22;
/** Magnification of the close-up relative to the flat colon. */
constexpr double magnification = 4.0;
/** Maximum width of wall in a close-up, mm. */
constexpr double widestCloseUp = 60.0;
/** The map shrinks heads on stalks more than any other wall. */
constexpr double greatestMagnification = 1000.0;
/** Pixels around the flat colon. */
constexpr double pixelsAroundFlat = 200.0;
/** Fraction of the color `head` on the head of a polyp; the mucosa shows through. */
constexpr double shareOfHead = 0.7;
const RGBColor   mucosa = MakeColor(232, 164, 144);
const RGBColor   head = MakeColor(92, 138, 236);
const RGBColor   ground = MakeColor(18, 19, 25);
const RGBColor   lightInk = MakeColor(222, 226, 234);
/** HU; C-RADS (Zalis et al., Radiology 2005) reads the colon with a wide window. */
constexpr IntensityWindow softTissueWindow{ -160.0, 240.0 };
constexpr IntensityWindow colonWindow{ -950.0, 550.0 };

/** Same light as on strips: from the left and slightly above. */
RGBColor
Lit(const RGBColor & color, const FlatColonFrame & frame, const Vector3d & normal)
{
  static const Vector3d toLight = Vector3d(-0.62, -0.22, 0.75).normalized();
  const Vector3d        n(normal.dot(frame.right), normal.dot(frame.down), normal.dot(frame.towards));
  constexpr double      wrap = 0.5;
  const double          light = 0.25 + 0.85 * std::max(0.0, (n.dot(toLight) + wrap) / (1.0 + wrap));
  RGBColor              lit;
  for (unsigned int k = 0; k < 3; ++k)
  {
    lit[k] = static_cast<unsigned char>(std::clamp(light * color[k], 0.0, 255.0));
  }
  return lit;
}

/** Local scale: mm of wall per mm on the map. The heads of polyps are small on the map. */
double
MeanScaleAround(const FlatColonGrid & grid, const FlatPixel & middle, int reach)
{
  const int step = std::max(1, reach / 6);
  double    sum = 0.0;
  int       number = 0;
  for (int column = std::max(0, middle.column - reach); column <= std::min(grid.Columns() - 1, middle.column + reach);
       column += step)
  {
    for (int row = middle.row - reach; row <= middle.row + reach; row += step)
    {
      const FlatSample sample = grid.SampleOfPixel(column, row);
      if (sample.face >= 0)
      {
        sum += sample.scale;
        ++number;
      }
    }
  }
  return number > 0 ? sum / number : 1.0;
}

/** The flat surface as a mesh in the plane of the map: x is u, y is v. */
SurfaceMesh
Unfolded(const SurfaceMesh & flat)
{
  const SurfaceArray * const uv = FindSurfaceArray(flat.pointArrays, "uv");
  SurfaceMesh                plane;
  plane.V = VertexMatrix::Zero(flat.V.rows(), 3);
  plane.V.leftCols<2>() = uv->values;
  plane.F = flat.F;
  return plane;
}

void
DrawLabel(Picture * picture, const std::string & text, int left, int top, unsigned int width)
{
  constexpr int size = 14;
  TextStyle     style{ size, lightInk };
  DrawText(picture, text, left, top, FitText(text, style, static_cast<int>(width) - 4));
}

/** Adds a title, orientation letters, a scale bar, and marks that point to the center. */
void
MarkCrop(Picture * crop, const CandidatePlane & plane, const std::string & title)
{
  constexpr int           padding = 5;
  constexpr int           mark = 10; // pixels
  constexpr int           letters = 13;
  const RGBColor          color = MakeColor(255, 214, 90);
  const double            middle = 0.5 * (cropSize - 1.0), last = cropSize - 1.0;
  OrientationLettersStyle style;
  itk::Vector<double, 3>  right(plane.right.data()), up(plane.up.data());
  style.size = letters;
  style.color = lightInk;
  style.margin = mark + 3;
  style.hasShadow = true;
  DrawLine(crop, middle, 0.0, middle, mark, color);
  DrawLine(crop, middle, last - mark, middle, last, color);
  DrawLine(crop, 0.0, middle, mark, middle, color);
  DrawLine(crop, last - mark, middle, last, middle, color);
  DrawOrientationLetters(crop, right, up, style);
  if (!title.empty())
  {
    FillRectangle(crop, 0, 0, static_cast<int>(cropSize), letters + padding, ground, shareOfHead);
    DrawLabel(crop, title, 3, 1, cropSize);
    constexpr int size = static_cast<int>(cropSize), scale = 28; // pixels
    FillRectangle(crop, 0, size - scale, size / 3 + 2 * padding, scale, ground, shareOfHead);
    DrawScaleBar(crop, padding, size - padding, size / 3, plane.width / cropSize, lightInk);
  }
}

/** Crops of one volume in one window. */
struct CropRow
{
  std::string                   title;
  std::vector<Picture::Pointer> crops;
};

/** In the soft-tissue window and in the colon window. */
std::vector<CropRow>
CropRowsOf(const itk::Image<float, 3> * ct, const std::string & name, const std::vector<CandidatePlane> & planes)
{
  std::vector<CropRow> rows{ { name + ", soft-tissue window", {} }, { name + ", colon window", {} } };
  for (const CandidatePlane & plane : planes)
  {
    rows[0].crops.push_back(PaintPlane(plane, ct, softTissueWindow, cropSize));
    rows[1].crops.push_back(PaintPlane(plane, ct, colonWindow, cropSize));
  }
  return rows;
}

bool
HaveSamePixels(const std::vector<CropRow> & a, const std::vector<CropRow> & b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const CropRow & one, const CropRow & other) {
    return std::equal(one.crops.begin(), one.crops.end(), other.crops.begin(), [](const auto & p, const auto & q) {
      return std::equal(p->GetBufferPointer(), p->GetBufferPointer() + cropSize * cropSize, q->GetBufferPointer());
    });
  });
}

std::vector<FlatAnnotation>
AnnotationsOf(const std::vector<PolypCandidate> & candidates)
{
  constexpr double            ringOfDiameter = 1.5;
  constexpr double            smallestRing = 10.0; // mm
  std::vector<FlatAnnotation> annotations;
  for (const PolypCandidate & candidate : candidates)
  {
    annotations.push_back({ IsListedAsPolyp(candidate) ? FlatAnnotation::Kind::Polyp : FlatAnnotation::Kind::Mark,
                            std::to_string(candidate.number),
                            {},
                            candidate.position,
                            {},
                            std::max(smallestRing, ringOfDiameter * candidate.diameter) });
  }
  return annotations;
}
} // namespace

struct PolypCandidatePictures::Data
{
  Data(const PolypColon & theColon, const std::vector<PolypCandidate> & candidates)
    : colon(theColon)
    , flatParts{ colon.flat.get(), &colon.centerline, nullptr, AnnotationsOf(candidates), {}, {} }
    , pixelSize(colon.flat->Grid().Circumference() / pixelsAroundFlat)
    , fine(colon.flat->Grid({ pixelSize / magnification, 0.0, 0.0 }))
    , axis(colon.flat->Axis({ pixelSize / magnification, 0.0, 0.0 }))
    , flat(fine)
    , unfolded(Unfolded(colon.flat->Surface()))
    , onMap(unfolded.V, unfolded.F)
    , wall(colon.wall.V, colon.wall.F)
    , inwardNormals(InwardNormalsOf(colon.wall))
  {
    SurfaceArray isHead{ "head", SurfaceArray::ValueMatrix::Zero(colon.wall.V.rows(), 1), true };
    for (const PolypCandidate & candidate : candidates)
    {
      for (const int vertex : candidate.vertices)
      {
        isHead.values(vertex, 0) = 1.0;
      }
    }
    wallWithHeads.V = colon.wall.V;
    wallWithHeads.F = colon.wall.F;
    wallWithHeads.pointArrays.push_back(std::move(isHead));
  }

  /** Color of the wall point nearest to a point of the flat surface. */
  RGBColor
  ColorAt(const FlatColonFrame & frame, const Vector3d & point) const
  {
    const SurfaceLocator::Closest closest = wall.FindClosest(point);
    const Vector3d                weights = BarycentricOf(colon.wall, closest.face, closest.point);
    Vector3d                      normal = Vector3d::Zero();
    double                        share = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int vertex = colon.wall.F(closest.face, k);
      normal += weights[k] * inwardNormals.row(vertex).transpose();
      share += weights[k] * wallWithHeads.pointArrays.front().values(vertex, 0);
    }
    return Lit(MixColors(mucosa, head, shareOfHead * std::clamp(share, 0.0, 1.0)), frame, normal.normalized());
  }

  /** Point of the flat surface at a position on the map; NaN outside and in holes. */
  Vector3d
  PointAt(const Eigen::Vector2d & uv) const
  {
    constexpr double tolerance = 1e-6; // mm, for rounding
    for (const double turns : { 0.0, -1.0, 1.0 })
    {
      const Vector3d                place(uv.x(), uv.y() + turns * fine.Circumference(), 0.0);
      const SurfaceLocator::Closest closest = onMap.FindClosest(place);
      if (closest.distance <= tolerance)
      {
        const SurfaceMesh & surface = colon.flat->Surface();
        const Vector3d      weights = BarycentricOf(unfolded, closest.face, closest.point);
        Vector3d            point = Vector3d::Zero();
        for (int k = 0; k < 3; ++k)
        {
          point += weights[k] * surface.V.row(unfolded.F(closest.face, k)).transpose();
        }
        return point;
      }
    }
    return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }

  /** Relief of the map around a candidate; `step` is in mm on the map per pixel. */
  Picture::Pointer
  PaintMap(const PolypCandidate & candidate, double step, unsigned int width, unsigned int height) const
  {
    const auto   picture = NewPicture(width, height, ground);
    const double down = fine.IsMirrored() ? -step : step;
    ParallelFor(height, [&](std::size_t y) {
      for (unsigned int x = 0; x < width; ++x)
      {
        const Eigen::Vector2d uv = candidate.uv + Eigen::Vector2d(step * (x + 0.5 - 0.5 * width),
                                                                  down * (static_cast<double>(y) + 0.5 - 0.5 * height));
        const Vector3d        point = this->PointAt(uv);
        if (point.allFinite())
        {
          const int column = std::clamp(fine.PixelOfUv(uv).column, 0, fine.Columns() - 1);
          picture->GetBufferPointer()[y * width + x] = this->ColorAt(FrameAt(axis, column, point), point);
        }
      }
    });
    return picture;
  }

  /** Width of the head on the map, mm; nothing if the map does not show it, as in a pouch that was cut off. */
  std::optional<double>
  WidthOnMap(const PolypCandidate & candidate) const
  {
    constexpr double farthest = 2.0; // mm, mean distance of a head to the simplified wall that the map shows
    double           widest = 0.0, distance = 0.0;
    for (const int vertex : candidate.vertices)
    {
      const FlatPlace place = flat.Find(colon.wall.V.row(vertex).transpose());
      widest = std::max(widest, 2.0 * std::abs(place.uv.x() - candidate.uv.x()));
      distance += place.distance / static_cast<double>(candidate.vertices.size());
    }
    return distance <= farthest ? std::optional<double>(widest) : std::nullopt;
  }

  const PolypColon &    colon;
  FlatColonParts        flatParts;
  double                pixelSize;
  const FlatColonGrid & fine;
  const FlatColonAxis & axis;
  FlatColonLocator      flat;
  SurfaceMesh           unfolded;
  SurfaceLocator        onMap;
  SurfaceLocator        wall;
  VertexMatrix          inwardNormals;
  SurfaceMesh           wallWithHeads; ///< with one point array: 1 in the heads, else 0
};

PolypCandidatePictures::PolypCandidatePictures(const PolypColon & colon, const std::vector<PolypCandidate> & candidates)
{
  if (!colon.flat)
  {
    throw InputError("pictures of candidates require the flat colon; run VirtualColonoscopy or ColonFlattening");
  }
  m_Data = std::make_unique<const Data>(colon, candidates);
}

PolypCandidatePictures::~PolypCandidatePictures() = default;

Picture::Pointer
PolypCandidatePictures::DrawFlatColon() const
{
  const FlatColonPictures pictures(m_Data->flatParts, m_Data->pixelSize);
  return pictures.Draw(FlatColoring::Relief, "Polyp candidates (research use)");
}

Picture::Pointer
PolypCandidatePictures::DrawCloseUp(const PolypCandidate & candidate) const
{
  constexpr int          reach = 60;       // pixels of the fine map
  constexpr double       leastHead = 12.0; // pixels; smaller heads are magnified
  constexpr double       headInset = 40.0; // pixels
  constexpr unsigned int insetWidth = 150, insetHeight = 110;
  const FlatColonGrid &  grid = m_Data->fine;
  const double           scale = MeanScaleAround(grid, grid.PixelOfUv(candidate.uv), reach);
  const double           step = std::min(widestCloseUp / (viewWidth * scale), grid.PixelSize());
  const auto             picture = m_Data->PaintMap(candidate, step, viewWidth, viewHeight);
  DrawScaleBar(picture, 10, viewHeight - 10, viewWidth / 4, scale * step, InkColor);
  const std::optional<double> widthOnMap = m_Data->WidthOnMap(candidate);
  if (!widthOnMap)
  {
    FillRectangle(picture, 0, 0, viewWidth, cardLabel, ground, shareOfHead);
    DrawLabel(picture, "Head not drawn: its surface cannot be flattened", 3, 3, viewWidth);
    return picture;
  }
  const double headOnMap = *widthOnMap / step;
  if (headOnMap < leastHead)
  {
    const double magnified = headInset / std::max(headOnMap, headInset / greatestMagnification);
    const int    left = viewWidth - insetWidth, top = viewHeight - insetHeight;
    PastePicture(picture, m_Data->PaintMap(candidate, step / magnified, insetWidth, insetHeight), left, top);
    DrawRectangle(picture, left, top, insetWidth, insetHeight, lightInk);
    DrawLabel(picture, "enlarged " + std::to_string(std::lround(magnified)) + " times", left + 3, top + 2, insetWidth);
    const int size = static_cast<int>(std::lround(candidate.diameter / (scale * step))); // as if it lay on the wall
    DrawRectangle(
      picture, (static_cast<int>(viewWidth) - size) / 2, (static_cast<int>(viewHeight) - size) / 2, size, size, head);
  }
  return picture;
}

PerspectiveCamera
PolypCandidatePictures::EndoluminalCamera(const PolypCandidate & candidate) const
{
  PerspectiveCamera camera =
    ChooseEye(m_Data->colon.wall, m_Data->inwardNormals, m_Data->wall, m_Data->colon.centerline, candidate);
  camera.width = viewWidth;
  camera.height = viewHeight;
  return camera;
}

Picture::Pointer
PolypCandidatePictures::DrawFromWithin(const PolypCandidate & candidate) const
{
  const PerspectiveCamera camera = this->EndoluminalCamera(candidate);
  const SurfaceMesh       part = WallAround(m_Data->wallWithHeads, camera.focus, 80.0);
  std::vector<RGBColor>   colors;
  for (int vertex = 0; vertex < part.NumberOfVertices(); ++vertex)
  {
    colors.push_back(MixColors(mucosa, head, shareOfHead * part.pointArrays.front().values(vertex, 0)));
  }
  return RenderPerspective(part, colors, camera);
}

Picture::Pointer
PolypCandidatePictures::DrawCrops(const PolypCandidate & candidate) const
{
  const PolypColon & colon = m_Data->colon;
  if (!colon.ct)
  {
    return nullptr;
  }
  const std::vector<CandidatePlane> planes = PlanesOf(colon.wall, colon.ct, candidate);
  std::vector<CropRow> rows = colon.original ? CropRowsOf(colon.original, "CT", planes) : std::vector<CropRow>();
  std::vector<CropRow> cleansed = CropRowsOf(colon.ct, "Cleansed CT", planes);
  if (rows.empty() || !HaveSamePixels(rows, cleansed))
  {
    rows.insert(rows.end(), cleansed.begin(), cleansed.end());
  }
  const int  step = static_cast<int>(cropSize) + cardGap;
  const auto page = NewPicture(static_cast<unsigned int>(static_cast<int>(planes.size()) * step - cardGap),
                               static_cast<unsigned int>(cardLabel + static_cast<int>(rows.size()) * step - cardGap),
                               ground);
  for (std::size_t column = 0; column < planes.size(); ++column)
  {
    const int left = static_cast<int>(column) * step;
    DrawLabel(page, planes[column].title, left + 2, 2, cropSize);
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      const Picture::Pointer & crop = rows[row].crops[column];
      MarkCrop(crop, planes[column], column == 0 ? rows[row].title : "");
      PastePicture(page, crop, left, cardLabel + static_cast<int>(row) * step);
    }
  }
  return page;
}

Picture::Pointer
PolypCandidatePictures::DrawCard(const PolypCandidate & candidate) const
{
  const auto crops = this->DrawCrops(candidate);
  const auto size = crops ? crops->GetLargestPossibleRegion().GetSize() : itk::Size<2>{ { 0, 0 } };
  const int  left = crops ? static_cast<int>(size[0]) + 2 * cardGap : 0;
  const int  block = cardLabel + static_cast<int>(viewHeight) + cardGap;
  const auto height = std::max(static_cast<unsigned int>(size[1]), static_cast<unsigned int>(2 * block));
  const auto page = NewPicture(static_cast<unsigned int>(left) + viewWidth, height, ground);
  if (crops)
  {
    PastePicture(page, crops, 0, 0);
  }
  DrawLabel(page, "Endoluminal view", left + 2, 2, viewWidth);
  PastePicture(page, this->DrawFromWithin(candidate), left, cardLabel);
  DrawLabel(page, "Virtual dissection (unfolded view)", left + 2, block + 2, viewWidth);
  PastePicture(page, this->DrawCloseUp(candidate), left, block + cardLabel);
  return page;
}
} // namespace shapeton
