#include "shapetonLabelSurfaces.h"

#include "shapetonLevelSurface.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceSmoothing.h"

#include <algorithm>
#include <array>
#include <map>

namespace shapeton
{
namespace
{
using LabelImage = itk::Image<unsigned short, 3>;

/** The smallest region that contains the voxels of a label. */
struct Box
{
  std::array<long, 3> first;
  std::array<long, 3> last;

  void
  Include(const std::array<long, 3> & voxel)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = std::min(first[axis], voxel[axis]);
      last[axis] = std::max(last[axis], voxel[axis]);
    }
  }
};

/** Calls visit(label, voxel) for the ends of each run of equal labels in a row. */
template <typename TVisit>
void
VisitRuns(const LabelImage * image, const TVisit & visit)
{
  const auto             size = image->GetBufferedRegion().GetSize();
  const unsigned short * row = image->GetBufferPointer();
  for (std::size_t i = 0; i < size[1] * size[2]; ++i, row += size[0])
  {
    const auto y = static_cast<long>(i % size[1]), z = static_cast<long>(i / size[1]);
    for (std::size_t x = 0; x < size[0]; ++x)
    {
      if (x == 0 || x + 1 == size[0] || row[x] != row[x - 1] || row[x] != row[x + 1])
      {
        visit(row[x], std::array<long, 3>{ static_cast<long>(x), y, z });
      }
    }
  }
}

std::map<unsigned short, Box>
BoxesOfLabels(const LabelImage * image)
{
  std::map<unsigned short, Box> boxes;
  VisitRuns(image, [&](unsigned short label, const std::array<long, 3> & voxel) {
    boxes.try_emplace(label, Box{ voxel, voxel }).first->second.Include(voxel);
  });
  return boxes;
}

/** 1 in the voxels of the label, 0 elsewhere and in a layer around the box. */
std::vector<float>
FieldOf(const LabelImage * image, unsigned short label, const Box & box, const std::array<int, 3> & size)
{
  const auto         extent = image->GetBufferedRegion().GetSize();
  std::vector<float> values(static_cast<std::size_t>(size[0]) * size[1] * size[2], 0.0F);
  for (long z = box.first[2]; z <= box.last[2]; ++z)
  {
    for (long y = box.first[1]; y <= box.last[1]; ++y)
    {
      const unsigned short * const row = image->GetBufferPointer() + (z * extent[1] + y) * extent[0];
      const auto padded = static_cast<std::size_t>(z - box.first[2] + 1) * size[1] + (y - box.first[1] + 1);
      std::transform(row + box.first[0],
                     row + box.last[0] + 1,
                     values.data() + padded * size[0] + 1,
                     [label](auto voxel) { return voxel == label ? 1.0F : 0.0F; });
    }
  }
  return values;
}

SurfaceMesh
SurfaceInBox(const LabelImage * image, unsigned short label, const Box & box)
{
  std::array<int, 3> size{};
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<int>(box.last[axis] - box.first[axis]) + 3; // with a layer on both sides
  }
  std::vector<float> values = FieldOf(image, label, box, size);
  SurfaceMesh        mesh = LevelSurface(values, size, 0.5, -1.0);
  const auto         start = image->GetBufferedRegion().GetIndex();
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    itk::ContinuousIndex<double, 3> index;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = mesh.V(i, axis) + static_cast<double>(start[axis] + box.first[axis]);
    }
    const auto point = image->TransformContinuousIndexToPhysicalPoint<double>(index);
    mesh.V.row(i) << point[0], point[1], point[2];
  }
  if (EnclosedVolume(mesh.V, mesh.F) < 0.0) // as for a left-handed grid
  {
    mesh.F.col(1).swap(mesh.F.col(2));
  }
  const auto              spacing = image->GetSpacing();
  SurfaceSmoothingOptions smoothing;
  smoothing.normalLimit = smoothing.tangentialLimit = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });
  return SmoothSurface(mesh, smoothing);
}
} // namespace

std::vector<SurfaceMesh>
SurfacesOfLabels(const LabelImage * image, const std::vector<unsigned short> & labels)
{
  const auto               boxes = BoxesOfLabels(image);
  std::vector<SurfaceMesh> surfaces;
  for (const unsigned short label : labels)
  {
    const auto box = boxes.find(label);
    surfaces.push_back(box == boxes.end() ? SurfaceMesh{} : SurfaceInBox(image, label, box->second));
  }
  return surfaces;
}
} // namespace shapeton
