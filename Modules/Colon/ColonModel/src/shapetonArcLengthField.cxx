#include "shapetonArcLengthField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Bucket size of the queue, mm. */
constexpr double QueueStep = 0.1;
/** Number of curve points around a site to search for the closest position. */
constexpr std::int32_t Reach = 8;

/** Bucket queue of voxels; the order is exact to within one QueueStep. */
class DistanceQueue
{
public:
  void
  Push(double distance, std::int64_t voxel)
  {
    const auto bucket = std::max(m_Current, static_cast<std::size_t>(distance / QueueStep));
    m_Buckets.resize(std::max(m_Buckets.size(), bucket + 1));
    m_Buckets[bucket].push_back(voxel);
  }

  /** Calls `body(voxel)`, which may push, until the queue is empty. */
  template <typename TBody>
  void
  Drain(const TBody & body)
  {
    for (; m_Current < m_Buckets.size(); ++m_Current)
    {
      for (std::size_t i = 0; i < m_Buckets[m_Current].size(); ++i)
      {
        body(m_Buckets[m_Current][i]);
      }
      std::vector<std::int64_t>().swap(m_Buckets[m_Current]);
    }
  }

private:
  std::vector<std::vector<std::int64_t>> m_Buckets;
  std::size_t                            m_Current{ 0 };
};
} // namespace

ArcLengthField::ArcLengthField(const LumenMaskImage * lumen, const CurveSet & centerline)
  : m_Grid(lumen)
  , m_Size(lumen->GetBufferedRegion().GetSize())
  , m_Sites(lumen->GetBufferedRegion().GetNumberOfPixels(), Nowhere)
{
  const Eigen::VectorXd    arcLengths = PointValues(centerline, "arcLength", "the centerline");
  const std::vector<int> & curve = centerline.curves.front();
  m_Points.resize(static_cast<Eigen::Index>(curve.size()), 3);
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    m_Points.row(static_cast<Eigen::Index>(i)) = centerline.V.row(curve[i]);
    m_ArcLengths.push_back(arcLengths[curve[i]]);
  }
  this->Spread(lumen);
}

Eigen::Vector3d
ArcLengthField::PointOfVoxel(std::int64_t voxel) const
{
  const auto nx = static_cast<std::int64_t>(m_Size[0]);
  const auto ny = static_cast<std::int64_t>(m_Size[1]);
  return m_Grid.PointOf(
    { static_cast<double>(voxel % nx), static_cast<double>(voxel / nx % ny), static_cast<double>(voxel / nx / ny) });
}

/** Propagates the sites between face neighbors, replacing sites by closer ones. */
void
ArcLengthField::Spread(const LumenMaskImage * lumen)
{
  const auto         nx = static_cast<std::int64_t>(m_Size[0]);
  const auto         slice = nx * static_cast<std::int64_t>(m_Size[1]);
  std::vector<float> squares(m_Sites.size(), std::numeric_limits<float>::infinity());
  DistanceQueue      queue;
  const auto         offer = [&](std::int64_t voxel, std::int32_t site) {
    const auto square = static_cast<float>((this->PointOfVoxel(voxel) - m_Points.row(site).transpose()).squaredNorm());
    if (lumen->GetBufferPointer()[voxel] != 0 && square < squares[voxel])
    {
      squares[voxel] = square;
      m_Sites[voxel] = site;
      queue.Push(std::sqrt(square), voxel);
    }
  };
  for (std::int32_t i = 0; i + 1 < m_Points.rows(); ++i)
  {
    ForVoxelsOfSegment(m_Grid, m_Size, m_Points.row(i), m_Points.row(i + 1), [&](std::array<long, 3> voxel) {
      offer(voxel[0] + nx * voxel[1] + slice * voxel[2], i);
      offer(voxel[0] + nx * voxel[1] + slice * voxel[2], i + 1);
    });
  }
  const auto last = static_cast<std::int64_t>(m_Sites.size());
  queue.Drain([&](std::int64_t voxel) {
    const std::int64_t x = voxel % nx;
    const std::int64_t y = voxel % slice / nx;
    const std::int32_t site = m_Sites[voxel];
    const std::array   neighbors{ x > 0 ? voxel - 1 : -1,  x + 1 < nx ? voxel + 1 : -1,
                                y > 0 ? voxel - nx : -1, (y + 1) * nx < slice ? voxel + nx : -1,
                                voxel - slice,           voxel + slice < last ? voxel + slice : -1 };
    for (const std::int64_t neighbor : neighbors)
    {
      if (neighbor >= 0 && m_Sites[neighbor] != site)
      {
        offer(neighbor, site);
      }
    }
  });
}

std::int32_t
ArcLengthField::SiteNear(const Eigen::Vector3d & point) const
{
  const Eigen::Vector3d index = m_Grid.IndexOf(point);
  std::int32_t          site = Nowhere;
  double                closest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 27; ++i)
  {
    const std::array<int, 3> step{ i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
    std::int64_t             voxel = 0;
    bool                     isInside = true;
    for (int k = 2; k >= 0; --k)
    {
      const std::int64_t place = std::llround(index[k]) + step[k];
      isInside = isInside && place >= 0 && place < static_cast<std::int64_t>(m_Size[k]);
      voxel = voxel * static_cast<std::int64_t>(m_Size[k]) + place;
    }
    if (!isInside || m_Sites[voxel] == Nowhere)
    {
      continue;
    }
    const double square = (this->PointOfVoxel(voxel) - point).squaredNorm();
    if (square < closest)
    {
      closest = square;
      site = m_Sites[voxel];
    }
  }
  return site;
}

std::int32_t
ArcLengthField::ClosestSite(const Eigen::Vector3d & point) const
{
  Eigen::Index closest = 0;
  (m_Points.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&closest);
  return static_cast<std::int32_t>(closest);
}

double
ArcLengthField::ArcLengthAt(const Eigen::Vector3d & point) const
{
  const std::int32_t near = this->SiteNear(point);
  const std::int32_t site = near == Nowhere ? this->ClosestSite(point) : near;
  const auto         end = static_cast<std::int32_t>(m_Points.rows()) - 1;
  double             closest = std::numeric_limits<double>::infinity();
  double             arcLength = 0.0;
  for (std::int32_t i = std::max(0, site - Reach); i < std::min(end, site + Reach); ++i)
  {
    const Eigen::Vector3d a = m_Points.row(i);
    const Eigen::Vector3d way = m_Points.row(i + 1).transpose() - a;
    const double          length = way.squaredNorm();
    const double          share = length > 0.0 ? std::clamp((point - a).dot(way) / length, 0.0, 1.0) : 0.0;
    const double          square = (point - a - share * way).squaredNorm();
    if (square < closest)
    {
      closest = square;
      arcLength = m_ArcLengths[i] + share * (m_ArcLengths[i + 1] - m_ArcLengths[i]);
    }
  }
  return arcLength;
}

double
ArcLengthField::ArcLengthOfVoxel(std::int64_t voxel) const
{
  const std::int32_t site = m_Sites[voxel];
  return m_ArcLengths[site == Nowhere ? this->ClosestSite(this->PointOfVoxel(voxel)) : site];
}
} // namespace shapeton
