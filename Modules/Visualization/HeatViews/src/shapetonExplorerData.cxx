#include "shapetonExplorerData.h"

#include "shapetonColorMap.h"
#include "shapetonFileBytes.h"
#include "shapetonHtmlReport.h"
#include "shapetonObjectColors.h"
#include "shapetonPatientOrientation.h"
#include "shapetonScriptPage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
extern const char * const ExplorerScript[];
extern const char * const ExplorerStyle[];

namespace
{
using ImageType = itk::Image<float, 3>;

/** Subsampling factor of each axis, chosen so that the page opens within seconds. */
class ShownGrid
{
public:
  explicit ShownGrid(const itk::ImageBase<3> * image, std::size_t greatestNumber = ExplorerVoxels) : m_Image(image)
  {
    do
    {
      ++m_Stride;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        m_Size[axis] = (image->GetBufferedRegion().GetSize(axis) + m_Stride - 1) / m_Stride;
      }
    } while (m_Size[0] * m_Size[1] * m_Size[2] > greatestNumber);
  }

  std::size_t
  VoxelsOfSlice() const
  {
    return m_Size[0] * m_Size[1];
  }

  /** Values of the voxels of an image of the same size. */
  template <typename TValue, typename TPixel, typename TFunction>
  std::vector<TValue>
  Values(const itk::Image<TPixel, 3> * image, const TFunction & valueOf) const
  {
    const auto           size = image->GetBufferedRegion().GetSize();
    const TPixel * const voxels = image->GetBufferPointer();
    std::vector<TValue>  values;
    values.reserve(this->VoxelsOfSlice() * m_Size[2]);
    for (std::size_t z = 0; z < size[2]; z += m_Stride)
    {
      for (std::size_t y = 0; y < size[1]; y += m_Stride)
      {
        for (std::size_t x = 0; x < size[0]; x += m_Stride)
        {
          values.push_back(valueOf(voxels[(z * size[1] + y) * size[0] + x]));
        }
      }
    }
    return values;
  }

  /** The voxel of the subsampled grid at or next to a voxel of the image. */
  Json
  PlaceOf(const itk::Index<3> & voxel) const
  {
    const auto start = m_Image->GetBufferedRegion().GetIndex();
    Json       place = Json::array();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      place.push_back(static_cast<std::size_t>(voxel[axis] - start[axis]) / m_Stride);
    }
    return place;
  }

  /** Size, spacing, origin and axes of the subsampled grid. */
  Json
  Geometry() const
  {
    ImageType::PointType origin;
    m_Image->TransformIndexToPhysicalPoint(m_Image->GetBufferedRegion().GetIndex(), origin);
    Json geometry{ { "stride", m_Stride }, { "size", m_Size } };
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto & direction = m_Image->GetDirection();
      geometry["origin"].push_back(origin[axis]);
      geometry["spacing"].push_back(m_Image->GetSpacing()[axis] * static_cast<double>(m_Stride));
      geometry["axes"].push_back({ direction[0][axis], direction[1][axis], direction[2][axis] });
    }
    return geometry;
  }

private:
  const itk::ImageBase<3> *  m_Image;
  std::size_t                m_Stride{ 0 };
  std::array<std::size_t, 3> m_Size{};
};

/** Orientation of the slices of a plane on the screen: image axes, flips, letters. */
Json
PlaneOf(const ImageType * image, SlicePlane plane)
{
  const SliceAxes axes = AxesOf(image, plane);
  const auto      letters = [image](unsigned int axis, bool isReversed) {
    itk::Vector<double, 3> direction;
    for (unsigned int k = 0; k < 3; ++k)
    {
      direction[k] = image->GetDirection()[k][axis] * (isReversed ? -1.0 : 1.0);
    }
    return OrientationLetters(direction);
  };
  return { { "name", NameOf(plane) },
           { "across", axes.across },
           { "down", axes.down },
           { "through", axes.through },
           { "flipAcross", axes.isAcrossReversed },
           { "flipDown", axes.isDownReversed },
           { "right", letters(axes.across, axes.isAcrossReversed) },
           { "left", letters(axes.across, !axes.isAcrossReversed) },
           { "bottom", letters(axes.down, axes.isDownReversed) },
           { "top", letters(axes.down, !axes.isDownReversed) } };
}

Json
JsonOf(const HeatRanges & ranges)
{
  Json list = Json::array();
  for (const HeatRange & range : ranges)
  {
    list.push_back({ range.lower, range.upper });
  }
  return list;
}

template <typename TFunction>
Json
Colors(int number, const TFunction & colorOf)
{
  Json colors = Json::array();
  for (int i = 0; i < number; ++i)
  {
    colors.push_back(HexOf(colorOf(i)));
  }
  return colors;
}
} // namespace

void
PutBins(PageBlocks & blocks, const std::string & name, const ImageType * values)
{
  const ShownGrid grid(values);
  const auto      bins = grid.Values<std::uint16_t>(
    values, [](float value) { return static_cast<std::uint16_t>(HeatHistogram::BinOf(value)); });
  blocks.Put(name, bins, grid.VoxelsOfSlice());
}

void
PutGray(PageBlocks & blocks, const ImageType * gray, const IntensityWindow & window)
{
  const ShownGrid grid(gray);
  const auto      grayOf = [&window](float intensity) {
    const double share = (intensity - window.lower) / (window.upper - window.lower);
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
  };
  blocks.Put("gray", grid.Values<std::uint8_t>(gray, grayOf), grid.VoxelsOfSlice());
}

void
PutLabels(PageBlocks & blocks, const HeatObjectList::LabelImage * labels)
{
  const ShownGrid grid(labels);
  blocks.Put(
    "labels", grid.Values<std::uint16_t>(labels, [](unsigned short label) { return label; }), grid.VoxelsOfSlice());
}

void
PutCounts(PageBlocks & blocks, const std::string & name, const HeatHistogram & histogram)
{
  const std::uint32_t * const      counts = histogram.GetRow(0);
  const std::vector<std::uint32_t> all(counts, counts + histogram.GetNumberOfRows() * HeatHistogram::NumberOfBins);
  blocks.Put(name, all);
}

Json
JsonOf(const ShapeQuantity & quantity)
{
  return { { "name", quantity.name }, { "greatestVisits", quantity.greatestVisits } };
}

Json
JsonOf(const ShapeTransferFunction & transferFunction)
{
  Json lines = Json::array();
  for (const TransferFunctionLine & line : transferFunction.GetLines())
  {
    lines.push_back({ { "lower", line.lowerHeat },
                      { "upper", line.upperHeat },
                      { "color", HexOf(line.color) },
                      { "opacity", line.opacity } });
  }
  return lines;
}

Json
JsonOf(const HeatObjectList & objects)
{
  constexpr int digits = 3;
  Json          list = Json::array();
  for (const HeatObject & object : objects.objects)
  {
    const auto number = static_cast<int>(list.size() + 1);
    list.push_back({ { "number", number },
                     { "color", HexOf(ColorOfObject(number)) },
                     { "parent", object.parent },
                     { "isOffer", objects.IsOffer(number) },
                     { "heat", RoundedJson(object.meanHeat) },
                     { "voxels", object.voxels },
                     { "volume", RoundedJson(object.volume) },
                     { "center", { object.center[0], object.center[1], object.center[2] } },
                     { "score", RoundedJson(object.score, digits) },
                     { "probability", RoundedJson(object.probability, digits) } });
  }
  return list;
}

Json
InfoOf(const HeatExplorerContent & content, std::size_t greatestVoxels)
{
  constexpr int         heatColors = 33;
  constexpr int         lineColors = 12; // ClassColor() repeats after these
  const IntensityWindow window = WindowOf(content.gray, content.window);
  Json                  planes = Json::array();
  for (const SlicePlane plane : { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    planes.push_back(PlaneOf(content.gray, plane));
  }
  const ShownGrid grid(content.gray, greatestVoxels);
  Json            info{ { "title", content.title },
             { "isEqualized", content.scale == HeatScale::Equalized },
             { "heatColors", Colors(heatColors, [](int i) { return HeatColor(i / (heatColors - 1.0)); }) },
             { "lineColors", Colors(lineColors, [](int i) { return ClassColor(i + 1); }) },
             { "volume", grid.Geometry() },
             { "ranges", JsonOf(content.ranges) },
             { "window", { window.lower, window.upper } },
             { "planes", planes } };
  if (content.place)
  {
    info["place"] = grid.PlaceOf(*content.place);
  }
  return info;
}

void
WriteExplorerPage(const std::string & path, const std::string & dataFolder)
{
  const ScriptPage page{ "Heat explorer",
                         PageText(ExplorerStyle),
                         PageText(ExplorerScript),
                         "startHeatExplorer(" + ScriptText(dataFolder) + ");" };
  WriteFileBytes(path, TextOf(page, PageBlocks("", true, nullptr)));
}
} // namespace shapeton
