#include "shapetonColonPictures.h"

#include "shapetonCenterlineStations.h"
#include "shapetonLumenBox.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
const RGBColor background = MakeColor(18, 19, 25);
const RGBColor annotation = MakeColor(214, 218, 226);

/** Layout, pixels. */
constexpr int titleHeight = 44;
constexpr int greatestHeight = 760;
constexpr int greatestWidth = 900;

RGBColor
ThicknessColor(double share)
{
  static const RGBColor bright = MakeColor(236, 238, 240);
  constexpr double      mostBright = 0.85; // share of `bright` in the thickest part
  // The square root keeps thin parts visible.
  return MixColors(background, bright, mostBright * std::sqrt(share));
}

/** Lumen thickness (mm) behind each voxel of a plane. */
class ThicknessMap
{
public:
  ThicknessMap(const itk::Image<unsigned char, 3> * lumen, const itk::ImageRegion<3> & focus, const SliceAxes & axes)
    : m_Focus(focus), m_Axes(axes), m_Values(focus.GetSize(axes.across) * focus.GetSize(axes.down), 0.0)
  {
    const double        step = lumen->GetSpacing()[axes.through];
    const itk::Index<3> first = focus.GetIndex();
    const itk::Index<3> last = focus.GetUpperIndex();
    itk::Index<3>       index;
    for (index[2] = first[2]; index[2] <= last[2]; ++index[2])
    {
      for (index[1] = first[1]; index[1] <= last[1]; ++index[1])
      {
        for (index[0] = first[0]; index[0] <= last[0]; ++index[0])
        {
          m_Values[this->PlaceOf(index)] += lumen->GetPixel(index) != 0 ? step : 0.0;
        }
      }
    }
  }

  double
  At(const itk::Index<3> & index) const
  {
    return m_Values[this->PlaceOf(index)];
  }

  double
  Greatest() const
  {
    return std::max(*std::max_element(m_Values.begin(), m_Values.end()), 1.0);
  }

  /** Linearly interpolated between voxels. */
  double
  Between(const itk::ContinuousIndex<double, 3> & place) const
  {
    const itk::Index<3> last = m_Focus.GetUpperIndex();
    double              sum = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      itk::Index<3> index = m_Focus.GetIndex();
      double        weight = 1.0;
      for (const unsigned int axis : { m_Axes.across, m_Axes.down })
      {
        const bool   isSecond = axis == m_Axes.across ? (corner & 1) != 0 : (corner & 2) != 0;
        const double below = std::floor(place[axis]);
        const double share = place[axis] - below;
        weight *= isSecond ? share : 1.0 - share;
        index[axis] = std::min(static_cast<itk::IndexValueType>(below) + (isSecond ? 1 : 0), last[axis]);
      }
      sum += weight * this->At(index);
    }
    return sum;
  }

private:
  std::size_t
  PlaceOf(const itk::Index<3> & index) const
  {
    return static_cast<std::size_t>(index[m_Axes.down] - m_Focus.GetIndex(m_Axes.down)) *
             m_Focus.GetSize(m_Axes.across) +
           static_cast<std::size_t>(index[m_Axes.across] - m_Focus.GetIndex(m_Axes.across));
  }

  itk::ImageRegion<3> m_Focus;
  SliceAxes           m_Axes;
  std::vector<double> m_Values;
};

itk::Point<double, 2>
PixelOf(const SliceView & view, const Eigen::Vector3d & point)
{
  const itk::Point<double, 3> place(point.data());
  return view.PixelOf(view.GetVolume()->TransformPhysicalPointToContinuousIndex<double>(place));
}

/** Draws with a dark rim, for contrast with bright lumen. */
void
DrawCenterline(Picture *                              picture,
               const SliceView &                      view,
               const std::vector<CenterlineStation> & stations,
               const ColorScale &                     scale)
{
  constexpr double thickness = 3.0;
  constexpr double thicknessWithRim = 5.0;
  for (const bool isRim : { true, false })
  {
    for (std::size_t i = 1; i < stations.size(); ++i)
    {
      const bool     isGap = stations[i - 1].isGap || stations[i].isGap;
      const RGBColor color =
        isGap ? GapColor() : scale.ColorOf(0.5 * (stations[i - 1].distance + stations[i].distance));
      const auto a = PixelOf(view, stations[i - 1].point);
      const auto b = PixelOf(view, stations[i].point);
      DrawLine(picture, a[0], a[1], b[0], b[1], isRim ? background : color, isRim ? thicknessWithRim : thickness);
    }
  }
}

/** A rectangle of pixels around its middle. */
struct Box
{
  bool
  Meets(const Box & other) const
  {
    return std::abs(x - other.x) < halfWidth + other.halfWidth && std::abs(y - other.y) < halfHeight + other.halfHeight;
  }
  int x;
  int y;
  int halfWidth;
  int halfHeight;
};

/** Whether a label is inside the picture and does not cover the orientation letters at the centers of the sides. */
bool
IsFree(const Box & text, int width, int height)
{
  constexpr int letter = 17; // half its size, with margin
  constexpr int marginX = 4;
  constexpr int marginY = 12; // half the height of a label, with margin
  bool isFree = text.x - text.halfWidth >= marginX && text.x + text.halfWidth <= width - marginX && text.y >= marginY &&
                text.y <= height - marginY;
  for (const auto & [x, y] : { std::make_pair(width / 2, letter),
                               std::make_pair(width / 2, height - letter),
                               std::make_pair(letter, height / 2),
                               std::make_pair(width - letter, height / 2) })
  {
    isFree = isFree && !text.Meets({ x, y, letter, letter });
  }
  return isFree;
}

/** Position of a label of this width next to a point: right, left, above or below, farther away if needed. */
Box
BoxBeside(int x, int y, int textWidth, int width, int height)
{
  constexpr int distance = 14;
  constexpr int lineHeight = 22;
  constexpr int halfHeight = 10;
  const int     half = textWidth / 2;
  const Box     right{ x + distance + half, y, half, halfHeight };
  for (int off = 0; off < 3; ++off)
  {
    const int away = lineHeight * (off + 1);
    for (const Box & box : { Box{ x + distance + half, y - lineHeight * off, half, halfHeight },
                             Box{ x - distance - half, y - lineHeight * off, half, halfHeight },
                             Box{ x, y - away, half, halfHeight },
                             Box{ x, y + away, half, halfHeight } })
    {
      if (IsFree(box, width, height))
      {
        return box;
      }
    }
  }
  return right;
}

void
DrawEnd(Picture *                 picture,
        const SliceView &         view,
        const CenterlineStation & station,
        const ColorScale &        scale,
        const std::string &       name)
{
  constexpr double diameter = 11.0;
  constexpr double diameterWithRim = 15.0;
  constexpr double shareOfWhite = 0.6; // in the color of the name
  const auto       place = PixelOf(view, station.point);
  DrawLine(picture, place[0], place[1], place[0], place[1], background, diameterWithRim);
  DrawLine(picture, place[0], place[1], place[0], place[1], scale.ColorOf(station.distance), diameter);
  TextStyle style{ 16,
                   MixColors(scale.ColorOf(station.distance), MakeColor(255, 255, 255), shareOfWhite),
                   true,
                   HorizontalAnchor::Center,
                   VerticalAnchor::Center };
  const Box box = BoxBeside(static_cast<int>(std::lround(place[0])),
                            static_cast<int>(std::lround(place[1])),
                            MeasureText(name, style).width,
                            static_cast<int>(view.GetWidth()),
                            static_cast<int>(view.GetHeight()));
  DrawRimmedText(picture, name, box.x, box.y, style, background);
}

SliceView
ViewOf(const itk::Image<unsigned char, 3> * lumen, const itk::ImageRegion<3> & focus, SlicePlane plane)
{
  const SliceAxes axes = AxesOf(lumen, plane);
  const auto &    spacing = lumen->GetSpacing();
  const double    across = spacing[axes.across] * static_cast<double>(focus.GetSize(axes.across));
  const double    down = spacing[axes.down] * static_cast<double>(focus.GetSize(axes.down));
  return { lumen, focus, plane, focus.GetIndex(axes.through), std::max(across / greatestWidth, down / greatestHeight) };
}

ColorScale
ThicknessScale(double greatest, SlicePlane plane)
{
  const std::string way = plane == SlicePlane::Coronal    ? "front to back"
                          : plane == SlicePlane::Sagittal ? "side to side"
                                                          : "head to foot";
  return { "gas and fluid, " + way + " (mm)", 0.0, greatest, ThicknessColor };
}

Picture::Pointer
PaintThickness(const SliceView & view, const ThicknessMap & map, const ColorScale & thickness)
{
  auto panel = NewPicture(view.GetWidth(), view.GetHeight(), background);
  for (unsigned int y = 0; y < view.GetHeight(); ++y)
  {
    for (unsigned int x = 0; x < view.GetWidth(); ++x)
    {
      const double mm = map.Between(view.IndexOfPixel(static_cast<int>(x), static_cast<int>(y)));
      panel->GetBufferPointer()[std::size_t{ y } * view.GetWidth() + x] = thickness.ColorOf(mm);
    }
  }
  DrawSliceLetters(panel, view);
  return panel;
}

/** The panel framed with title and color bars. */
Picture::Pointer
MakePage(const Picture * panel, const std::string & title, const std::vector<ColorScale> & scales, bool hasGaps)
{
  constexpr int edge = 12;
  constexpr int footHeight = 46;
  constexpr int titleSize = 20;
  constexpr int legendTop = 14;
  constexpr int legendBottom = 40;
  constexpr int distanceOfBars = 14;
  const int     width = static_cast<int>(panel->GetBufferedRegion().GetSize(0));
  const int     height = static_cast<int>(panel->GetBufferedRegion().GetSize(1));
  const int     barStep = colorBarWidth + 10;
  const int     bars = static_cast<int>(scales.size()) * barStep + 34;
  auto      page = NewPicture(static_cast<unsigned int>(width + bars), height + titleHeight + footHeight, background);
  TextStyle style{ titleSize, annotation, true };
  DrawText(page, title, edge, 10, style);
  if (hasGaps)
  {
    const int left = edge + 30 + MeasureText(title, style).width;
    DrawLegend(page, { { GapColor(), "gap in the lumen" } }, left, legendTop, legendBottom, annotation);
  }
  PastePicture(page, panel, edge, titleHeight);
  const int barTop = titleHeight + height / 10;
  const int barHeight = height - height / 5;
  int       left = edge + width + distanceOfBars;
  for (const ColorScale & scale : scales)
  {
    DrawColorBar(page, left, barTop, barHeight, scale, annotation);
    left += barStep;
  }
  return page;
}
} // namespace

Picture::Pointer
DrawColonProjection(const ColonParts & colon, SlicePlane plane)
{
  CheckParts(colon);
  constexpr double          surroundings = 22.0;
  const itk::ImageRegion<3> focus = LumenBox(colon.lumen, AreasOf(colon.lumen), surroundings);
  const SliceView           view = ViewOf(colon.lumen, focus, plane);
  const ThicknessMap        map(colon.lumen, focus, view.GetAxes());
  std::vector<ColorScale>   scales{ ThicknessScale(map.Greatest(), plane) };
  auto                      panel = PaintThickness(view, map, scales[0]);
  bool                      hasGaps = false;
  if (colon.centerline)
  {
    const std::vector<CenterlineStation> stations = StationsOf(*colon.centerline);
    scales.push_back(DistanceScale(stations));
    DrawCenterline(panel, view, stations, scales[1]);
    DrawEnd(panel, view, stations.front(), scales[1], "anal verge");
    DrawEnd(panel, view, stations.back(), scales[1], "cecum");
    hasGaps = std::any_of(stations.begin(), stations.end(), [](const CenterlineStation & s) { return s.isGap; });
  }
  auto          page = MakePage(panel, "Projection, " + NameOf(plane), scales, hasGaps);
  const int     below = titleHeight + static_cast<int>(view.GetHeight()) + 34;
  constexpr int barLeft = 12;
  constexpr int barLength = 180;
  DrawScaleBar(page, barLeft, below, barLength, view.GetMillimetersPerPixel(), annotation);
  return page;
}
} // namespace shapeton
