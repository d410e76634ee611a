#include "itkColonPictures.h"

#include "itkCentrelineStations.h"
#include "itkLumenBox.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
const RGBColor background = MakeColor(18, 19, 25);
const RGBColor annotation = MakeColor(214, 218, 226);

constexpr int titleHeight = 44;
constexpr int greatestHeight = 760;
constexpr int greatestWidth = 900;

RGBColor
ThicknessColor(double share)
{
  // The square root keeps thin parts visible.
  return MixColors(background, MakeColor(236, 238, 240), 0.85 * std::sqrt(share));
}

/** Millimetres of lumen behind each voxel of a plane. */
class ThicknessMap
{
public:
  ThicknessMap(const Image<unsigned char, 3> * lumen, const ImageRegion<3> & focus, const SliceAxes & axes)
    : m_Focus(focus), m_Axes(axes), m_Values(focus.GetSize(axes.across) * focus.GetSize(axes.down), 0.0)
  {
    const double   step = lumen->GetSpacing()[axes.through];
    const Index<3> first = focus.GetIndex();
    const Index<3> last = focus.GetUpperIndex();
    Index<3>       index;
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
  At(const Index<3> & index) const
  {
    return m_Values[this->PlaceOf(index)];
  }

  /** At least 1. */
  double
  Greatest() const
  {
    return std::max(*std::max_element(m_Values.begin(), m_Values.end()), 1.0);
  }

  /** Linear between voxels. */
  double
  Between(const ContinuousIndex<double, 3> & place) const
  {
    const Index<3> last = m_Focus.GetUpperIndex();
    double         sum = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      Index<3> index = m_Focus.GetIndex();
      double   weight = 1.0;
      for (const unsigned int axis : { m_Axes.across, m_Axes.down })
      {
        const bool   isSecond = axis == m_Axes.across ? (corner & 1) != 0 : (corner & 2) != 0;
        const double below = std::floor(place[axis]);
        const double share = place[axis] - below;
        weight *= isSecond ? share : 1.0 - share;
        index[axis] = std::min(static_cast<IndexValueType>(below) + (isSecond ? 1 : 0), last[axis]);
      }
      sum += weight * this->At(index);
    }
    return sum;
  }

private:
  std::size_t
  PlaceOf(const Index<3> & index) const
  {
    return static_cast<std::size_t>(index[m_Axes.down] - m_Focus.GetIndex(m_Axes.down)) *
             m_Focus.GetSize(m_Axes.across) +
           static_cast<std::size_t>(index[m_Axes.across] - m_Focus.GetIndex(m_Axes.across));
  }

  ImageRegion<3>      m_Focus;
  SliceAxes           m_Axes;
  std::vector<double> m_Values;
};

Point<double, 2>
PixelOf(const SliceView & view, const Eigen::Vector3d & point)
{
  ContinuousIndex<double, 3> index;
  view.GetVolume()->TransformPhysicalPointToContinuousIndex(ImageBase<3>::PointType(point.data()), index);
  return view.PixelOf(index);
}

/** With a dark rim, so that it stands out from bright lumen. */
void
DrawCentreline(Picture *                              picture,
               const SliceView &                      view,
               const std::vector<CentrelineStation> & stations,
               const ColorScale &                     scale)
{
  for (const bool isRim : { true, false })
  {
    for (std::size_t i = 1; i < stations.size(); ++i)
    {
      const bool     isGap = stations[i - 1].isGap || stations[i].isGap;
      const RGBColor color =
        isGap ? GapColor() : scale.ColorOf(0.5 * (stations[i - 1].distance + stations[i].distance));
      const auto a = PixelOf(view, stations[i - 1].point);
      const auto b = PixelOf(view, stations[i].point);
      DrawLine(picture, a[0], a[1], b[0], b[1], isRim ? background : color, isRim ? 5.0 : 3.0);
    }
  }
}

void
DrawEnd(Picture *                 picture,
        const SliceView &         view,
        const CentrelineStation & station,
        const ColorScale &        scale,
        const std::string &       name)
{
  const auto place = PixelOf(view, station.point);
  DrawLine(picture, place[0], place[1], place[0], place[1], background, 15.0);
  DrawLine(picture, place[0], place[1], place[0], place[1], scale.ColorOf(station.distance), 11.0);
  TextStyle style;
  style.size = 16;
  style.bold = true;
  style.color = MixColors(scale.ColorOf(station.distance), MakeColor(255, 255, 255), 0.6);
  style.vertical = VerticalAnchor::Center;
  const int  width = static_cast<int>(view.GetWidth());
  const int  x = static_cast<int>(std::lround(place[0]));
  const int  y = static_cast<int>(std::lround(place[1]));
  const bool isLeft = x + 14 + MeasureText(name, style).width > width - 4;
  style.horizontal = isLeft ? HorizontalAnchor::Right : HorizontalAnchor::Left;
  DrawRimmedText(picture, name, isLeft ? x - 14 : x + 14, y, style, background);
}

/** Scale, ticks and so on beside the picture. */
void
DrawBars(Picture * page, int left, int height, const ColorScale & thickness, const ColorScale * distance)
{
  DrawColorBar(page, left, titleHeight + height / 10, height - height / 5, thickness, annotation);
  if (distance)
  {
    DrawColorBar(
      page, left + colorBarWidth + 10, titleHeight + height / 10, height - height / 5, *distance, annotation);
  }
}
} // namespace

Picture::Pointer
DrawColonProjection(const ColonParts & colon, SlicePlane plane)
{
  CheckParts(colon);
  constexpr double     surroundings = 22.0;
  const ImageRegion<3> focus = LumenBox(colon.lumen, AreasOf(colon.lumen), surroundings);
  const SliceAxes      axes = AxesOf(colon.lumen, plane);
  const auto &         spacing = colon.lumen->GetSpacing();
  const double scale = std::max(spacing[axes.across] * static_cast<double>(focus.GetSize(axes.across)) / greatestWidth,
                                spacing[axes.down] * static_cast<double>(focus.GetSize(axes.down)) / greatestHeight);
  const SliceView    view(colon.lumen, focus, plane, focus.GetIndex(axes.through), scale);
  const ThicknessMap map(colon.lumen, focus, axes);
  ColorScale         thickness{ "gas and fluid, front to back (mm)", 0.0, map.Greatest(), ThicknessColor };
  if (plane != SlicePlane::Coronal)
  {
    thickness.title = plane == SlicePlane::Sagittal ? "gas and fluid, side to side (mm)" : "gas and fluid (mm)";
  }
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
  ColorScale distance;
  if (colon.centreline)
  {
    const std::vector<CentrelineStation> stations = StationsOf(*colon.centreline);
    distance = DistanceScale(stations);
    DrawCentreline(panel, view, stations, distance);
    if (!stations.empty())
    {
      DrawEnd(panel, view, stations.front(), distance, "anal verge");
      DrawEnd(panel, view, stations.back(), distance, "caecum");
    }
  }
  const int width = static_cast<int>(view.GetWidth());
  const int height = static_cast<int>(view.GetHeight());
  const int bars = (colon.centreline ? 2 : 1) * (colorBarWidth + 10) + 10;
  auto      page = NewPicture(static_cast<unsigned int>(width + bars + 24), height + titleHeight + 46, background);
  TextStyle style;
  style.size = 20;
  style.bold = true;
  style.color = annotation;
  const std::string title = "Projection, " + NameOf(plane);
  DrawText(page, title, 12, 10, style);
  PastePicture(page, panel, 12, titleHeight);
  DrawBars(page, 12 + width + 14, height, thickness, colon.centreline ? &distance : nullptr);
  DrawScaleBar(page, 12, titleHeight + height + 34, 180, scale, annotation);
  return page;
}
} // namespace itk
