#include "shapetonSliceView.h"

#include "shapetonPictureAnnotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace shapeton
{
namespace
{
const RGBColor black = MakeColor(0, 0, 0);
const RGBColor white = MakeColor(255, 255, 255);

/** Volume axis closest to each of the patient's axes (left, posterior, head). */
std::array<unsigned int, 3>
AxesOfPatient(const itk::ImageBase<3> * image)
{
  std::array<unsigned int, 3> axes{ { 0, 1, 2 } };
  std::array<unsigned int, 3> best = axes;
  double                      bestSum = -1.0;
  do
  {
    double sum = 0.0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      sum += std::fabs(image->GetDirection()[i][axes[i]]);
    }
    if (sum > bestSum)
    {
      bestSum = sum;
      best = axes;
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return best;
}

itk::Vector<double, 3>
DirectionOf(const itk::ImageBase<3> * image, unsigned int axis)
{
  itk::Vector<double, 3> direction;
  for (unsigned int i = 0; i < 3; ++i)
  {
    direction[i] = image->GetDirection()[i][axis];
  }
  return direction;
}

unsigned int
PixelsAlong(const itk::ImageBase<3> *   volume,
            const itk::ImageRegion<3> & focus,
            unsigned int                axis,
            double                      millimetersPerPixel)
{
  const double length = volume->GetSpacing()[axis] * static_cast<double>(focus.GetSize(axis));
  return static_cast<unsigned int>(std::max(std::lround(length / millimetersPerPixel), 1L));
}

double
GrayAt(const itk::Image<float, 3> * gray, const SliceAxes & axes, const itk::ContinuousIndex<double, 3> & place)
{
  const itk::Index<3> last = gray->GetBufferedRegion().GetUpperIndex();
  itk::Index<3>       first;
  itk::Index<3>       second;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    first[axis] = static_cast<itk::IndexValueType>(std::floor(place[axis]));
    second[axis] = std::min(first[axis] + 1, last[axis]);
  }
  double sum = 0.0;
  for (const bool isRight : { false, true })
  {
    for (const bool isLower : { false, true })
    {
      itk::Index<3> index = first;
      const double  right = place[axes.across] - static_cast<double>(first[axes.across]);
      const double  lower = place[axes.down] - static_cast<double>(first[axes.down]);
      index[axes.across] = isRight ? second[axes.across] : first[axes.across];
      index[axes.down] = isLower ? second[axes.down] : first[axes.down];
      sum += (isRight ? right : 1.0 - right) * (isLower ? lower : 1.0 - lower) * gray->GetPixel(index);
    }
  }
  return sum;
}

/** \class MaskSlice
 * \brief A mask in a slice, padded by one outside voxel. */
class MaskSlice
{
public:
  MaskSlice(const SliceView & view, const std::function<bool(const itk::Index<3> &)> & isInside)
    : m_View(view)
    , m_Columns(static_cast<int>(view.GetFocus().GetSize(view.GetAxes().across)) + 2)
    , m_Rows(static_cast<int>(view.GetFocus().GetSize(view.GetAxes().down)) + 2)
    , m_IsInside(static_cast<std::size_t>(m_Columns) * m_Rows, 0)
  {
    for (int row = 1; row < m_Rows - 1; ++row)
    {
      for (int column = 1; column < m_Columns - 1; ++column)
      {
        itk::Index<3> index;
        index[view.GetAxes().through] = view.GetSlice();
        index[view.GetAxes().across] = view.GetFocus().GetIndex(view.GetAxes().across) + column - 1;
        index[view.GetAxes().down] = view.GetFocus().GetIndex(view.GetAxes().down) + row - 1;
        m_IsInside[static_cast<std::size_t>(row) * m_Columns + column] = isInside(index) ? 1 : 0;
      }
    }
  }

  void
  Draw(Picture * picture, const RGBColor & color, double thickness) const
  {
    for (int row = 0; row + 1 < m_Rows; ++row)
    {
      for (int column = 0; column + 1 < m_Columns; ++column)
      {
        this->DrawCell(picture, row, column, color, thickness);
      }
    }
  }

private:
  bool
  At(int row, int column) const
  {
    return m_IsInside[static_cast<std::size_t>(row) * m_Columns + column] != 0;
  }

  itk::Point<double, 2>
  PixelAt(double row, double column) const
  {
    itk::ContinuousIndex<double, 3> index;
    index[m_View.GetAxes().through] = static_cast<double>(m_View.GetSlice());
    index[m_View.GetAxes().across] =
      static_cast<double>(m_View.GetFocus().GetIndex(m_View.GetAxes().across)) + column - 1.0;
    index[m_View.GetAxes().down] = static_cast<double>(m_View.GetFocus().GetIndex(m_View.GetAxes().down)) + row - 1.0;
    return m_View.PixelOf(index);
  }

  /** Cuts off each corner of the cell that differs from both neighbors, or cuts the cell in half. */
  void
  DrawCell(Picture * picture, int row, int column, const RGBColor & color, double thickness) const
  {
    // Corners, each followed by the edge to the next one.
    const std::array<bool, 4> corner{
      { this->At(row, column), this->At(row, column + 1), this->At(row + 1, column + 1), this->At(row + 1, column) }
    };
    const std::array<std::array<double, 2>, 4> middle{ { { { row + 0.0, column + 0.5 } },
                                                         { { row + 0.5, column + 1.0 } },
                                                         { { row + 1.0, column + 0.5 } },
                                                         { { row + 0.5, column + 0.0 } } } };
    const auto                                 draw = [&](int a, int b) {
      const auto from = this->PixelAt(middle[a][0], middle[a][1]);
      const auto to = this->PixelAt(middle[b][0], middle[b][1]);
      DrawLine(picture, from[0], from[1], to[0], to[1], color, thickness);
    };
    const int inside = corner[0] + corner[1] + corner[2] + corner[3];
    if (inside == 2 && corner[0] != corner[2])
    {
      corner[0] == corner[1] ? draw(3, 1) : draw(0, 2);
      return;
    }
    for (int k = 0; k < 4; ++k)
    {
      // One inside corner, or two diagonal ones: cut off the inside corners.
      const bool isAlone = inside == 3 ? !corner[k] : inside < 3 && corner[k];
      if (isAlone)
      {
        draw((k + 3) % 4, k);
      }
    }
  }

  const SliceView & m_View;
  int               m_Columns;
  int               m_Rows;
  std::vector<char> m_IsInside;
};
} // namespace

std::string
NameOf(SlicePlane plane)
{
  return plane == SlicePlane::Axial ? "axial" : plane == SlicePlane::Coronal ? "coronal" : "sagittal";
}

SliceAxes
AxesOf(const itk::ImageBase<3> * volume, SlicePlane plane)
{
  const std::array<unsigned int, 3> axes = AxesOfPatient(volume);
  const auto                        pointsTo = [&](unsigned int patientAxis) {
    return volume->GetDirection()[patientAxis][axes[patientAxis]] > 0.0;
  };
  const bool toLeft = pointsTo(0);
  const bool toPosterior = pointsTo(1);
  const bool toHead = pointsTo(2);
  switch (plane)
  {
    case SlicePlane::Axial:
      return { axes[0], axes[1], axes[2], !toLeft, !toPosterior };
    case SlicePlane::Coronal:
      return { axes[0], axes[2], axes[1], !toLeft, toHead };
    default:
      return { axes[1], axes[2], axes[0], !toPosterior, toHead };
  }
}

SliceView::SliceView(const itk::ImageBase<3> *   volume,
                     const itk::ImageRegion<3> & focus,
                     SlicePlane                  plane,
                     itk::IndexValueType         slice,
                     double                      millimetersPerPixel)
  : m_Volume(volume)
  , m_Focus(focus)
  , m_Axes(AxesOf(volume, plane))
  , m_Slice(slice)
  , m_MillimetersPerPixel(millimetersPerPixel)
{
  const itk::ImageRegion<3> region = volume->GetLargestPossibleRegion();
  if (focus.GetNumberOfPixels() == 0 || !region.IsInside(focus) || slice < region.GetIndex(m_Axes.through) ||
      slice > region.GetUpperIndex()[m_Axes.through] || !(millimetersPerPixel > 0.0))
  {
    throw std::invalid_argument("the view of a slice requires a part of its volume and a positive scale");
  }
  m_Width = PixelsAlong(volume, focus, m_Axes.across, millimetersPerPixel);
  m_Height = PixelsAlong(volume, focus, m_Axes.down, millimetersPerPixel);
}

itk::Vector<double, 3>
SliceView::GetRight() const
{
  return DirectionOf(m_Volume, m_Axes.across) * (m_Axes.isAcrossReversed ? -1.0 : 1.0);
}

itk::Vector<double, 3>
SliceView::GetUp() const
{
  return DirectionOf(m_Volume, m_Axes.down) * (m_Axes.isDownReversed ? 1.0 : -1.0);
}

itk::ContinuousIndex<double, 3>
SliceView::IndexOfPixel(int x, int y) const
{
  const auto along = [&](unsigned int axis, int pixel, unsigned int pixels, bool isReversed) {
    const auto   size = static_cast<double>(m_Focus.GetSize(axis));
    const double place = (pixel + 0.5) / pixels * size - 0.5;
    return static_cast<double>(m_Focus.GetIndex(axis)) +
           std::clamp(isReversed ? size - 1.0 - place : place, 0.0, size - 1.0);
  };
  itk::ContinuousIndex<double, 3> index;
  index[m_Axes.through] = static_cast<double>(m_Slice);
  index[m_Axes.across] = along(m_Axes.across, x, m_Width, m_Axes.isAcrossReversed);
  index[m_Axes.down] = along(m_Axes.down, y, m_Height, m_Axes.isDownReversed);
  return index;
}

itk::Point<double, 2>
SliceView::PixelOf(const itk::ContinuousIndex<double, 3> & index) const
{
  const auto along = [&](unsigned int axis, unsigned int pixels, bool isReversed) {
    const auto   size = static_cast<double>(m_Focus.GetSize(axis));
    const double place = index[axis] - static_cast<double>(m_Focus.GetIndex(axis));
    return ((isReversed ? size - 1.0 - place : place) + 0.5) / size * pixels - 0.5;
  };
  itk::Point<double, 2> pixel;
  pixel[0] = along(m_Axes.across, m_Width, m_Axes.isAcrossReversed);
  pixel[1] = along(m_Axes.down, m_Height, m_Axes.isDownReversed);
  return pixel;
}

Picture::Pointer
PaintSlice(const SliceView & view, const itk::Image<float, 3> * gray, const IntensityWindow & window)
{
  auto picture = NewPicture(view.GetWidth(), view.GetHeight(), black);
  for (unsigned int y = 0; y < view.GetHeight(); ++y)
  {
    for (unsigned int x = 0; x < view.GetWidth(); ++x)
    {
      const auto   place = view.IndexOfPixel(static_cast<int>(x), static_cast<int>(y));
      const double value = GrayAt(gray, view.GetAxes(), place);
      const double share = std::clamp((value - window.lower) / (window.upper - window.lower), 0.0, 1.0);
      picture->GetBufferPointer()[std::size_t{ y } * view.GetWidth() + x] = MixColors(black, white, share);
    }
  }
  return picture;
}

void
ColorSlice(Picture *                                                             picture,
           const SliceView &                                                     view,
           const std::function<std::optional<RGBColor>(const itk::Index<3> &)> & colorOf,
           double                                                                opacity)
{
  for (unsigned int y = 0; y < view.GetHeight(); ++y)
  {
    for (unsigned int x = 0; x < view.GetWidth(); ++x)
    {
      const auto    place = view.IndexOfPixel(static_cast<int>(x), static_cast<int>(y));
      itk::Index<3> nearest;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        nearest[axis] = static_cast<itk::IndexValueType>(std::floor(place[axis] + 0.5));
      }
      const std::optional<RGBColor> color = colorOf(nearest);
      if (color)
      {
        RGBColor & pixel = picture->GetBufferPointer()[std::size_t{ y } * view.GetWidth() + x];
        pixel = MixColors(pixel, *color, opacity);
      }
    }
  }
}

void
DrawMaskOutline(Picture *                                          picture,
                const SliceView &                                  view,
                const std::function<bool(const itk::Index<3> &)> & isInside,
                const RGBColor &                                   color,
                double                                             thickness)
{
  MaskSlice(view, isInside).Draw(picture, color, thickness);
}

void
DrawSurfaceCut(Picture *           picture,
               const SliceView &   view,
               const SurfaceMesh & surface,
               const RGBColor &    color,
               double              thickness)
{
  std::vector<itk::ContinuousIndex<double, 3>> places(surface.V.rows());
  for (Eigen::Index i = 0; i < surface.V.rows(); ++i)
  {
    const itk::Point<double, 3> point(surface.V.row(i).data());
    places[i] = view.GetVolume()->TransformPhysicalPointToContinuousIndex<double>(point);
  }
  const unsigned int through = view.GetAxes().through;
  const auto         plane = static_cast<double>(view.GetSlice());
  for (Eigen::Index face = 0; face < surface.F.rows(); ++face)
  {
    itk::Point<double, 2> ends[2];
    int                   found = 0;
    for (int k = 0; k < 3; ++k)
    {
      const auto & a = places[surface.F(face, k)];
      const auto & b = places[surface.F(face, (k + 1) % 3)];
      // A vertex in the plane counts as above it: each cut face is cut at exactly two edges.
      if ((a[through] < plane) != (b[through] < plane))
      {
        const double                    share = (plane - a[through]) / (b[through] - a[through]);
        itk::ContinuousIndex<double, 3> cut;
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          cut[axis] = a[axis] + share * (b[axis] - a[axis]);
        }
        ends[found++] = view.PixelOf(cut);
      }
    }
    if (found == 2)
    {
      DrawLine(picture, ends[0][0], ends[0][1], ends[1][0], ends[1][1], color, thickness);
    }
  }
}

void
DrawSliceLetters(Picture * picture, const SliceView & view)
{
  static const RGBColor   paleYellow = MakeColor(255, 236, 140);
  constexpr int           size = 17;
  OrientationLettersStyle style{ size, paleYellow, 4, true };
  DrawOrientationLetters(picture, view.GetRight(), view.GetUp(), style);
}
} // namespace shapeton
