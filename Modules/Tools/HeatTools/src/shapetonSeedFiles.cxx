#include "shapetonSeedFiles.h"
#include "shapetonCsvTable.h"

#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Marks the voxels of one markups node. */
class SeedPen
{
public:
  SeedPen(SeedImage * seeds, const Markup & markup, unsigned short label)
    : m_Seeds(seeds), m_Markup(markup), m_Label(label)
  {}

  void
  MarkPoint(std::size_t number)
  {
    this->Mark(m_Markup.points[number], number);
  }

  /** The voxels of the segment between two points: the midpoint of two consecutive face crossings is in the voxel
   * between these faces. */
  void
  MarkPiece(std::size_t from, std::size_t to)
  {
    this->MarkPoint(from);
    this->MarkPoint(to);
    const Eigen::Vector3d     a = m_Markup.points[from];
    const Eigen::Vector3d     b = m_Markup.points[to];
    const std::vector<double> crossings = this->CrossingsOf(a, b);
    for (std::size_t i = 1; i < crossings.size(); ++i)
    {
      if (crossings[i] - crossings[i - 1] > 1e-9)
      {
        this->Mark(a + 0.5 * (crossings[i - 1] + crossings[i]) * (b - a), to);
      }
    }
  }

private:
  Eigen::Vector3d
  IndexOf(const Eigen::Vector3d & place) const
  {
    SeedImage::PointType point;
    std::copy_n(place.data(), 3, point.begin());
    itk::ContinuousIndex<double, 3> index;
    m_Seeds->TransformPhysicalPointToContinuousIndex(point, index);
    return Eigen::Vector3d(index.GetDataPointer());
  }

  /** 0, 1, and the crossings of voxel faces, which are halfway between indices, from a to b; ascending. */
  std::vector<double>
  CrossingsOf(const Eigen::Vector3d & a, const Eigen::Vector3d & b) const
  {
    const Eigen::Vector3d from = this->IndexOf(a);
    const Eigen::Vector3d along = this->IndexOf(b) - from;
    std::vector<double>   crossings{ 0.0, 1.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = std::min(from[axis], from[axis] + along[axis]);
      const double high = std::max(from[axis], from[axis] + along[axis]);
      for (double face = std::floor(low + 0.5) + 0.5; face < high; face += 1.0)
      {
        crossings.push_back((face - from[axis]) / along[axis]);
      }
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
  }

  std::string
  NameOf(std::size_t number) const
  {
    return "point " + std::to_string(number + 1) + " of the markup \"" + m_Markup.name + '"';
  }

  void
  Mark(const Eigen::Vector3d & place, std::size_t number)
  {
    SeedImage::PointType point;
    std::copy_n(place.data(), 3, point.begin());
    SeedImage::IndexType index;
    if (!m_Seeds->TransformPhysicalPointToIndex(point, index))
    {
      throw InputError(NameOf(number) + " is outside the volume; move it into the segmented volume");
    }
    unsigned short & voxel = m_Seeds->GetPixel(index);
    if (voxel != 0 && voxel != m_Label)
    {
      throw InputError(NameOf(number) + " is in a voxel that is already a seed of label " + std::to_string(voxel) +
                       "; a voxel can have only one label");
    }
    voxel = m_Label;
  }

  SeedImage *          m_Seeds;
  const Markup &       m_Markup;
  const unsigned short m_Label;
};
} // namespace

SeedImage::Pointer
LabelsOfVolume(const Volume & volume, const std::string & path, const itk::ImageBase<3> * image)
{
  if (!HaveSameGrid(image, volume.image))
  {
    throw InputError(path + ": the labels and the volume have different grids; use labels on the grid of the volume");
  }
  const auto        seeds = NewImageOn<SeedImage>(image, true);
  const std::size_t number = image->GetLargestPossibleRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < number; ++i)
  {
    const float     value = volume.image->GetBufferPointer()[i];
    constexpr float greatest = 65535.0F; // of 16 bits
    if (!(value >= 0.0F && value <= greatest) || value != std::floor(value))
    {
      throw InputError(path + ": labels must be whole numbers from 0 to 65535, found " + CsvTable::Number(value) +
                       "; use a label map, not intensities or heat");
    }
    seeds->GetBufferPointer()[i] = static_cast<unsigned short>(value);
  }
  return seeds;
}

SeedImage::Pointer
SeedsOfMarkups(const std::vector<Markup> & markups, const itk::ImageBase<3> * image)
{
  const auto     seeds = NewImageOn<SeedImage>(image, true);
  unsigned short label = 0;
  for (const Markup & markup : markups)
  {
    SeedPen           pen(seeds, markup, ++label);
    const std::size_t number = markup.points.size();
    if (number == 0)
    {
      throw InputError("the markup \"" + markup.name + "\" has no point, so label " + std::to_string(label) +
                       " would have no seed");
    }
    for (std::size_t i = 0; i < number; ++i)
    {
      pen.MarkPoint(i);
      if (markup.kind != Markup::Kind::Points && i > 0)
      {
        pen.MarkPiece(i - 1, i);
      }
    }
    if (markup.kind == Markup::Kind::ClosedCurve)
    {
      pen.MarkPiece(number - 1, 0);
    }
  }
  return seeds;
}
} // namespace shapeton
