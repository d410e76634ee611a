#include "itkSliceMontage.h"

#include "itkAxisTicks.h"
#include "itkCsvTable.h"
#include "itkPatientOrientation.h"
#include "itkPictureAnnotation.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <tuple>
#include <stdexcept>

namespace itk
{
namespace
{
using ImageType = Image<float, 3>;

const RGBColor ink = MakeColor(30, 32, 38);
const RGBColor paper = MakeColor(255, 255, 255);
const RGBColor black = MakeColor(0, 0, 0);
const RGBColor letterColor = MakeColor(255, 236, 140);

constexpr int margin = 16;
constexpr int gap = 14;
constexpr int titleHeight = 40;
constexpr int captionHeight = 26;
constexpr int legendWidth = 190;
constexpr int greatestPanelHeight = 460;

/** How a slice lies in its picture: the volume's axes across, down and through it. */
struct SliceLayout
{
  const char * name;
  unsigned int across;
  unsigned int down;
  unsigned int through;
  /** Whether the picture runs against the index. */
  bool isAcrossReversed;
  bool isDownReversed;
};

Vector<double, 3>
DirectionOf(const ImageBase<3> * image, unsigned int axis)
{
  Vector<double, 3> direction;
  for (unsigned int i = 0; i < 3; ++i)
  {
    direction[i] = image->GetDirection()[i][axis];
  }
  return direction;
}

/** The volume's axis that runs most along each of the patient's axes (left, posterior, head). */
std::array<unsigned int, 3>
AxesOfPatient(const ImageBase<3> * image)
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

std::array<SliceLayout, 3>
LayoutsOf(const ImageBase<3> * image)
{
  const std::array<unsigned int, 3> axes = AxesOfPatient(image);
  const auto                        pointsTo = [&](unsigned int patientAxis) {
    return image->GetDirection()[patientAxis][axes[patientAxis]] > 0.0;
  };
  const bool toLeft = pointsTo(0);
  const bool toPosterior = pointsTo(1);
  const bool toHead = pointsTo(2);
  return { { { "axial", axes[0], axes[1], axes[2], !toLeft, !toPosterior },
             { "coronal", axes[0], axes[2], axes[1], !toLeft, toHead },
             { "sagittal", axes[1], axes[2], axes[0], !toPosterior, toHead } } };
}

/** Colours, coarsely, and coloured voxels of a slice. */
struct SliceScore
{
  std::bitset<4096> colors;
  std::size_t       voxels{ 0 };
};

/** The cut of DrawSliceMontage(); looks at every n-th voxel of each axis, at most some millions. */
Index<3>
MostColorfulCut(const ImageType * heat, const HeatColoring & coloring)
{
  const ImageType::RegionType            region = heat->GetBufferedRegion();
  const ImageType::SizeType              size = region.GetSize();
  const double                           voxels = static_cast<double>(region.GetNumberOfPixels());
  const auto                             stride = std::max<SizeValueType>(std::lround(std::cbrt(voxels / 4e6)), 1);
  std::array<std::vector<SliceScore>, 3> scores;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    scores[axis].resize(size[axis]);
  }
  const float * const heats = heat->GetBufferPointer();
  for (SizeValueType z = stride / 2; z < size[2]; z += stride)
  {
    for (SizeValueType y = stride / 2; y < size[1]; y += stride)
    {
      for (SizeValueType x = stride / 2; x < size[0]; x += stride)
      {
        const auto color = coloring(heats[(z * size[1] + y) * size[0] + x]);
        if (color)
        {
          const unsigned int coarse = ((*color)[0] >> 4) << 8 | ((*color)[1] >> 4) << 4 | (*color)[2] >> 4;
          for (SliceScore * score : { &scores[0][x], &scores[1][y], &scores[2][z] })
          {
            score->colors.set(coarse);
            ++score->voxels;
          }
        }
      }
    }
  }
  Index<3> cut;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto rank = [&](SizeValueType slice) {
      const double offMiddle = std::fabs(static_cast<double>(slice) - 0.5 * (size[axis] - 1.0));
      return std::make_tuple(scores[axis][slice].colors.count(), scores[axis][slice].voxels, -offMiddle);
    };
    SizeValueType best = 0;
    for (SizeValueType slice = 1; slice < size[axis]; ++slice)
    {
      best = rank(slice) > rank(best) ? slice : best;
    }
    cut[axis] = region.GetIndex(axis) + static_cast<IndexValueType>(best);
  }
  return cut;
}

IntensityWindow
WindowOf(const ImageType * grey, const IntensityWindow & window)
{
  if (window.lower < window.upper)
  {
    return window;
  }
  constexpr std::size_t greatestSample = 1000000;
  const std::size_t     number = grey->GetBufferedRegion().GetNumberOfPixels();
  const std::size_t     stride = number / greatestSample + 1;
  std::vector<float>    sample;
  for (std::size_t i = 0; i < number; i += stride)
  {
    sample.push_back(grey->GetBufferPointer()[i]);
  }
  const auto quantile = [&](double share) {
    const auto place = sample.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), place, sample.end());
    return static_cast<double>(*place);
  };
  const double lower = quantile(0.005);
  const double upper = quantile(0.995);
  return upper > lower ? IntensityWindow{ lower, upper } : IntensityWindow{ lower, lower + 1.0 };
}

/** The extent, in mm, of the volume along an axis. */
double
LengthOf(const ImageBase<3> * image, unsigned int axis)
{
  return image->GetSpacing()[axis] * image->GetBufferedRegion().GetSize(axis);
}

/** \class SlicePainter
 * \brief Paints one slice into a picture of its own. */
class SlicePainter
{
public:
  SlicePainter(const ImageType *           grey,
               const ImageType *           heat,
               const HeatColoring &        coloring,
               const SliceMontageOptions & options,
               const IntensityWindow &     window,
               double                      millimetresPerPixel)
    : m_Grey(grey)
    , m_Heat(heat)
    , m_Coloring(coloring)
    , m_Opacity(options.opacity)
    , m_Window(window)
    , m_MillimetresPerPixel(millimetresPerPixel)
  {}

  int
  PixelsAlong(unsigned int axis) const
  {
    return std::max(static_cast<int>(std::lround(LengthOf(m_Grey, axis) / m_MillimetresPerPixel)), 1);
  }

  Picture::Pointer
  Paint(const SliceLayout & layout, const Index<3> & cut) const
  {
    const int width = this->PixelsAlong(layout.across);
    const int height = this->PixelsAlong(layout.down);
    auto      picture = NewPicture(width, height, black);
    double    position[3];
    position[layout.through] =
      static_cast<double>(cut[layout.through] - m_Grey->GetBufferedRegion().GetIndex(layout.through));
    for (int y = 0; y < height; ++y)
    {
      position[layout.down] = this->Coordinate(layout.down, y, height, layout.isDownReversed);
      for (int x = 0; x < width; ++x)
      {
        position[layout.across] = this->Coordinate(layout.across, x, width, layout.isAcrossReversed);
        picture->GetBufferPointer()[static_cast<std::size_t>(y) * width + x] = this->ColorAt(layout, position);
      }
    }
    this->DrawLetters(picture, layout);
    return picture;
  }

private:
  double
  Coordinate(unsigned int axis, int pixel, int pixels, bool isReversed) const
  {
    const double size = static_cast<double>(m_Grey->GetBufferedRegion().GetSize(axis));
    const double along = (pixel + 0.5) / pixels * size - 0.5;
    return std::clamp(isReversed ? size - 1.0 - along : along, 0.0, size - 1.0);
  }

  std::size_t
  OffsetOf(const int index[3]) const
  {
    const ImageType::SizeType size = m_Grey->GetBufferedRegion().GetSize();
    return (static_cast<std::size_t>(index[2]) * size[1] + index[1]) * size[0] + index[0];
  }

  RGBColor
  ColorAt(const SliceLayout & layout, const double position[3]) const
  {
    const double grey =
      std::clamp((this->GreyAt(layout, position) - m_Window.lower) / (m_Window.upper - m_Window.lower), 0.0, 1.0);
    const RGBColor shown = MixColors(black, paper, grey);
    int            nearest[3];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      nearest[axis] = static_cast<int>(position[axis] + 0.5);
    }
    const auto color = m_Coloring(m_Heat->GetBufferPointer()[this->OffsetOf(nearest)]);
    return color ? MixColors(shown, *color, m_Opacity) : shown;
  }

  /** Linear inside the slice. */
  double
  GreyAt(const SliceLayout & layout, const double position[3]) const
  {
    int first[3];
    int second[3];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      first[axis] = static_cast<int>(position[axis]);
      second[axis] = std::min(first[axis] + 1, static_cast<int>(m_Grey->GetBufferedRegion().GetSize(axis)) - 1);
    }
    double sum = 0.0;
    for (const bool isRight : { false, true })
    {
      for (const bool isLower : { false, true })
      {
        int          index[3] = { first[0], first[1], first[2] };
        const double right = position[layout.across] - first[layout.across];
        const double lower = position[layout.down] - first[layout.down];
        index[layout.across] = isRight ? second[layout.across] : first[layout.across];
        index[layout.down] = isLower ? second[layout.down] : first[layout.down];
        sum += (isRight ? right : 1.0 - right) * (isLower ? lower : 1.0 - lower) *
               m_Grey->GetBufferPointer()[this->OffsetOf(index)];
      }
    }
    return sum;
  }

  void
  DrawLetters(Picture * picture, const SliceLayout & layout) const
  {
    const int               width = static_cast<int>(picture->GetBufferedRegion().GetSize(0));
    const int               height = static_cast<int>(picture->GetBufferedRegion().GetSize(1));
    const Vector<double, 3> right = DirectionOf(m_Grey, layout.across) * (layout.isAcrossReversed ? -1.0 : 1.0);
    const Vector<double, 3> below = DirectionOf(m_Grey, layout.down) * (layout.isDownReversed ? -1.0 : 1.0);
    const auto              draw =
      [&](const Vector<double, 3> & direction, int x, int y, HorizontalAnchor horizontal, VerticalAnchor vertical) {
        TextStyle style;
        style.size = 17;
        style.bold = true;
        style.horizontal = horizontal;
        style.vertical = vertical;
        style.color = black;
        DrawText(picture, OrientationLetters(direction), x + 1, y + 1, style);
        style.color = letterColor;
        DrawText(picture, OrientationLetters(direction), x, y, style);
      };
    draw(-right, 4, height / 2, HorizontalAnchor::Left, VerticalAnchor::Center);
    draw(right, width - 4, height / 2, HorizontalAnchor::Right, VerticalAnchor::Center);
    draw(-below, width / 2, 3, HorizontalAnchor::Center, VerticalAnchor::Top);
    draw(below, width / 2, height - 3, HorizontalAnchor::Center, VerticalAnchor::Bottom);
  }

  const ImageType *    m_Grey;
  const ImageType *    m_Heat;
  const HeatColoring & m_Coloring;
  double               m_Opacity;
  IntensityWindow      m_Window;
  double               m_MillimetresPerPixel;
};

/** The scale at which three slices side by side fill the width without being too high. */
double
ScaleFor(const ImageBase<3> * image, const std::array<SliceLayout, 3> & layouts, int width)
{
  double lengths = 0.0;
  double greatestHeight = 0.0;
  for (const SliceLayout & layout : layouts)
  {
    lengths += LengthOf(image, layout.across);
    greatestHeight = std::max(greatestHeight, LengthOf(image, layout.down));
  }
  return std::max(lengths / (width - 2 * gap), greatestHeight / greatestPanelHeight);
}

void
Check(const ImageType * grey, const ImageType * heat, const SliceMontageOptions & options)
{
  if (!grey || !heat || grey->GetBufferedRegion() != heat->GetBufferedRegion() ||
      grey->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    throw std::invalid_argument("a montage needs an image and a heat volume of the same size");
  }
  if (options.cut && !grey->GetBufferedRegion().IsInside(*options.cut))
  {
    throw std::invalid_argument("the cut of a montage lies outside of the volume");
  }
  if (options.width < 600)
  {
    throw std::invalid_argument("a montage needs a width of at least 600 pixels");
  }
}
} // namespace

Picture::Pointer
DrawSliceMontage(const Image<float, 3> *     grey,
                 const Image<float, 3> *     heat,
                 const HeatColoring &        coloring,
                 const SliceMontageOptions & options)
{
  Check(grey, heat, options);
  const std::array<SliceLayout, 3> layouts = LayoutsOf(grey);
  const Index<3>                   cut = options.cut ? *options.cut : MostColorfulCut(heat, coloring);
  const int          width = static_cast<int>(options.width) - 2 * margin - (options.legend.empty() ? 0 : legendWidth);
  const double       scale = ScaleFor(grey, layouts, width);
  const SlicePainter painter(grey, heat, coloring, options, WindowOf(grey, options.window), scale);
  int                panelHeight = 0;
  for (const SliceLayout & layout : layouts)
  {
    panelHeight = std::max(panelHeight, painter.PixelsAlong(layout.down));
  }
  const int top = options.title.empty() ? margin : margin + titleHeight;
  auto      picture =
    NewPicture(options.width, static_cast<unsigned int>(top + captionHeight + panelHeight + margin + 24), paper);
  TextStyle style;
  style.size = 22;
  style.bold = true;
  style.color = ink;
  DrawText(picture,
           options.title,
           margin,
           margin,
           FitText(options.title, style, static_cast<int>(options.width) - 2 * margin));
  style.size = 15;
  style.bold = false;
  int left = margin;
  for (const SliceLayout & layout : layouts)
  {
    const IndexValueType slice = cut[layout.through] - grey->GetBufferedRegion().GetIndex(layout.through) + 1;
    const int            panelWidth = painter.PixelsAlong(layout.across);
    const std::string    caption = std::string(layout.name) + ", slice " + std::to_string(slice) + " of " +
                                std::to_string(grey->GetBufferedRegion().GetSize(layout.through));
    DrawText(picture, caption, left, top, FitText(caption, style, panelWidth));
    PastePicture(picture, painter.Paint(layout, cut), left, top + captionHeight);
    left += panelWidth + gap;
  }
  const int bottom = top + captionHeight + panelHeight;
  DrawScaleBar(picture, margin, bottom + 28, 160, scale, ink);
  DrawLegend(
    picture, options.legend, static_cast<int>(options.width) - margin - legendWidth + gap, top + captionHeight, bottom);
  return picture;
}

std::vector<LegendEntry>
LegendOf(const std::vector<HeatClass> & classes, const HeatAxis & axis, const ShapeQuantity & quantity)
{
  std::vector<LegendEntry> legend;
  for (const HeatClass & heatClass : classes)
  {
    if (heatClass.label != 0)
    {
      legend.push_back(
        { axis.ColorOf(heatClass.meanHeat),
          "class " + std::to_string(heatClass.label) + ": " + quantity.name + " " + HeatLabel(heatClass.meanHeat) });
    }
  }
  return legend;
}

std::vector<LegendEntry>
LegendOf(const ShapeTransferFunction & transferFunction)
{
  std::vector<LegendEntry> legend;
  for (const TransferFunctionLine & line : transferFunction.GetLines())
  {
    legend.push_back({ line.color, HeatLabel(line.lowerHeat) + " to " + HeatLabel(line.upperHeat) });
  }
  return legend;
}
} // namespace itk
