#include "shapetonPolypCandidatePictures.h"

#include "shapetonEndoscope.h"

#include "shapetonFacePlace.h"
#include "shapetonFlatColonPictures.h"
#include "shapetonPageColors.h"
#include "shapetonParallelFor.h"
#include "shapetonPictureAnnotation.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

constexpr unsigned int viewWidth = 400;
constexpr unsigned int viewHeight = 300;
constexpr int          heightOfTitle = 34;
/** Magnification of the close-up relative to the flat colon. */
constexpr double magnification = 4.0;
/** Maximum width of wall in a close-up, mm. */
constexpr double widestCloseUp = 60.0;
/** Pixels around the flat colon. */
constexpr double pixelsAroundFlat = 200.0;
/** Share of the color `head` on the head of a polyp; the mucosa shines through. */
constexpr double shareOfHead = 0.7;
const RGBColor   mucosa = MakeColor(232, 164, 144);
const RGBColor   head = MakeColor(92, 138, 236);
const RGBColor   ground = MakeColor(18, 19, 25);
const RGBColor   lightInk = MakeColor(222, 226, 234);

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

/** Local scale: mm of wall per mm of the map. The heads of polyps are small on the map. */
double
MeanScaleAround(const FlatColonGrid & grid, const FlatPixel & middle)
{
  constexpr int reach = 60, step = 10; // pixels
  double        sum = 0.0;
  int           number = 0;
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

/** Bilinear interpolation between pixel centers; NaN outside and in holes. */
Vector3d
PointBetweenPixels(const FlatColonGrid & grid, double column, double row)
{
  const int left = static_cast<int>(std::floor(column)), top = static_cast<int>(std::floor(row));
  if (left < 0 || left + 1 >= grid.Columns())
  {
    return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const double x = column - left, y = row - top;
  return (1.0 - y) * ((1.0 - x) * grid.PointOfPixel(left, top) + x * grid.PointOfPixel(left + 1, top)) +
         y * ((1.0 - x) * grid.PointOfPixel(left, top + 1) + x * grid.PointOfPixel(left + 1, top + 1));
}

std::vector<FlatAnnotation>
AnnotationsOf(const std::vector<PolypCandidate> & candidates)
{
  constexpr double            ringOfDiameter = 1.5;
  constexpr double            smallestRing = 10.0; // mm
  std::vector<FlatAnnotation> annotations;
  for (const PolypCandidate & candidate : candidates)
  {
    FlatAnnotation one;
    one.kind = FlatAnnotation::Kind::Polyp;
    one.text = std::to_string(candidate.number);
    one.point = candidate.position;
    one.diameter = std::max(smallestRing, ringOfDiameter * candidate.diameter);
    annotations.push_back(one);
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

  const PolypColon &    colon;
  FlatColonParts        flatParts;
  double                pixelSize;
  const FlatColonGrid & fine;
  const FlatColonAxis & axis;
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
  const FlatColonGrid & grid = m_Data->fine;
  const FlatPixel       middle = grid.PixelOfUv(candidate.uv);
  const double          scale = MeanScaleAround(grid, middle);
  const double          enlargement = std::clamp(viewWidth * grid.PixelSize() * scale / widestCloseUp, 1.0, 8.0);
  const auto            picture = NewPicture(viewWidth, viewHeight, ground);
  ParallelFor(viewHeight, [&](std::size_t y) {
    for (unsigned int x = 0; x < viewWidth; ++x)
    {
      const double   column = middle.column + (x - 0.5 * viewWidth) / enlargement;
      const double   row = middle.row + (static_cast<double>(y) - 0.5 * viewHeight) / enlargement;
      const Vector3d point = PointBetweenPixels(grid, column, row);
      if (point.allFinite())
      {
        const FlatColonFrame frame = FrameAt(m_Data->axis, static_cast<int>(column), point);
        picture->GetBufferPointer()[y * viewWidth + x] = m_Data->ColorAt(frame, point);
      }
    }
  });
  DrawScaleBar(picture, 10, viewHeight - 10, viewWidth / 4, scale * grid.PixelSize() / enlargement, InkColor);
  return picture;
}

Picture::Pointer
PolypCandidatePictures::DrawFromWithin(const PolypCandidate & candidate) const
{
  PerspectiveCamera camera = ChooseEye(m_Data->wall, m_Data->colon.centerline, candidate);
  camera.width = viewWidth;
  camera.height = viewHeight;
  const SurfaceMesh     part = WallAround(m_Data->wallWithHeads, camera.focus, 80.0);
  std::vector<RGBColor> colors;
  for (int vertex = 0; vertex < part.NumberOfVertices(); ++vertex)
  {
    colors.push_back(MixColors(mucosa, head, shareOfHead * part.pointArrays.front().values(vertex, 0)));
  }
  return RenderPerspective(part, colors, camera);
}

Picture::Pointer
PolypCandidatePictures::DrawCandidate(const PolypCandidate & candidate) const
{
  constexpr int gap = 8;
  constexpr int titleSize = 18;
  constexpr int titleLeft = 10;
  constexpr int titleTop = 7;
  const auto    page = NewPicture(2 * viewWidth + gap, viewHeight + heightOfTitle, ground);
  TextStyle     style;
  style.size = titleSize;
  style.bold = true;
  style.color = lightInk;
  const std::string title = "Candidate " + std::to_string(candidate.number) + ": " +
                            CsvTable::Rounded(candidate.diameter, 3) + " mm, score " +
                            CsvTable::Rounded(candidate.score, 2) + " (research use)";
  DrawText(page, title, titleLeft, titleTop, FitText(title, style, 2 * viewWidth - 2 * titleLeft));
  PastePicture(page, this->DrawCloseUp(candidate), 0, heightOfTitle);
  PastePicture(page, this->DrawFromWithin(candidate), viewWidth + gap, heightOfTitle);
  return page;
}
} // namespace shapeton
