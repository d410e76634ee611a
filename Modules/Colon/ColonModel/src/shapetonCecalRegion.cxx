#include "shapetonCecalRegion.h"

#include "shapetonParallelFor.h"
#include "shapetonSquaredDistances.h"

#include "itkLinearInterpolateImageFunction.h"

#include <Eigen/Geometry>

#include <cmath>

namespace shapeton
{
namespace
{
/** Far beyond Reach. */
constexpr float notReached = 1e6F;
} // namespace

CecalRegion::CecalRegion(const LumenMask *            labels,
                         const itk::Image<float, 3> * ct,
                         const CurveSet &             centerline,
                         double                       margin)
{
  const Eigen::VectorXd arcLength = PointValues(centerline, "arcLength", "the centerline");
  const Eigen::VectorXd beforeEnd = arcLength.maxCoeff() - arcLength.array();
  this->PlaceGrid(centerline, beforeEnd, margin);
  this->Sample(labels, ct);
  this->MeasureBeforeEnd(centerline, beforeEnd);
  this->MeasureFromLumen();
}

std::ptrdiff_t
CecalRegion::VoxelAt(const Eigen::Vector3d & point) const
{
  const Eigen::Array3i v = ((point - m_Origin) / Step).array().round().cast<int>();
  return m_Grid.Holds(v[0], v[1], v[2]) ? static_cast<std::ptrdiff_t>(m_Grid.Index(v[0], v[1], v[2])) : -1;
}

void
CecalRegion::PlaceGrid(const CurveSet & centerline, const Eigen::VectorXd & beforeEnd, double margin)
{
  Eigen::AlignedBox3d box;
  for (Eigen::Index i = 0; i < beforeEnd.size(); ++i)
  {
    if (beforeEnd[i] <= Reach)
    {
      box.extend(centerline.V.row(i).transpose());
    }
  }
  // The grid is centered in the box, so that the voxels of a mirrored patient are mirrored, too.
  const Eigen::Array3i half = ((0.5 * box.sizes().array() + margin) / Step).ceil().cast<int>();
  m_Grid.SetSize({ { 2 * half[0] + 1, 2 * half[1] + 1, 2 * half[2] + 1 } });
  m_Origin = box.center() - Step * half.cast<double>().matrix();
}

void
CecalRegion::Sample(const LumenMask * labels, const itk::Image<float, 3> * ct)
{
  m_IsLumen.assign(m_Grid.NumberOfVoxels(), 0);
  m_Hounsfield.assign(ct != nullptr ? m_Grid.NumberOfVoxels() : 0, 0.0F);
  const auto interpolator = itk::LinearInterpolateImageFunction<itk::Image<float, 3>, double>::New();
  interpolator->SetInputImage(ct);
  ParallelFor(m_Grid.size[2], [&](std::size_t k) {
    const std::size_t slice = m_Grid.stride[2];
    for (std::size_t voxel = k * slice; voxel < (k + 1) * slice; ++voxel)
    {
      const itk::Point<double, 3> point(this->PointOf(voxel).data());
      LumenMask::IndexType        index;
      if (!labels->TransformPhysicalPointToIndex(point, index))
      {
        continue;
      }
      m_IsLumen[voxel] = labels->GetPixel(index) != 0;
      if (ct != nullptr)
      {
        m_Hounsfield[voxel] = static_cast<float>(interpolator->Evaluate(point));
      }
    }
  });
}

// Propagates distances through the lumen, to exclude adjacent loops, then slightly into the tissue.
void
CecalRegion::MeasureBeforeEnd(const CurveSet & centerline, const Eigen::VectorXd & beforeEnd)
{
  constexpr int layersOfTissue = 8; // voxels of 1.25 mm; chosen: 10 mm hold the wall
  m_BeforeEnd.assign(m_Grid.NumberOfVoxels(), notReached);
  std::vector<std::size_t> front;
  for (Eigen::Index i = 0; i < beforeEnd.size(); ++i)
  {
    const std::ptrdiff_t voxel = this->VoxelAt(centerline.V.row(i).transpose());
    if (voxel >= 0 && m_IsLumen[voxel] && m_BeforeEnd[voxel] == notReached)
    {
      m_BeforeEnd[voxel] = static_cast<float>(beforeEnd[i]);
      front.push_back(voxel);
    }
  }
  const auto enter = [&](std::size_t from, bool lumen, std::vector<std::size_t> & next) {
    ForEachNeighbor(m_Grid, from, [&](std::size_t to) {
      if (m_BeforeEnd[to] == notReached && IsLumen(to) == lumen)
      {
        m_BeforeEnd[to] = m_BeforeEnd[from];
        next.push_back(to);
      }
    });
  };
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    enter(front[i], true, front);
  }
  for (int layer = 0; layer < layersOfTissue; ++layer)
  {
    std::vector<std::size_t> next;
    for (const std::size_t voxel : front)
    {
      enter(voxel, false, next);
    }
    front = std::move(next);
  }
}

void
CecalRegion::MeasureFromLumen()
{
  std::vector<unsigned char> tissue(m_IsLumen.size());
  for (std::size_t i = 0; i < tissue.size(); ++i)
  {
    tissue[i] = m_IsLumen[i] == 0;
  }
  m_FromLumen = SquaredDistances(m_Grid, { { Step, Step, Step } }, tissue);
  for (float & value : m_FromLumen)
  {
    value = std::sqrt(value);
  }
}
} // namespace shapeton
