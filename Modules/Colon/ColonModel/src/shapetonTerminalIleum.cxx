#include "shapetonTerminalIleum.h"

#include "shapetonCecalRegion.h"
#include "shapetonMappedImage.h"
#include "shapetonSquaredDistances.h"

#include "itkImageRegionIteratorWithIndex.h"

namespace shapeton
{
namespace
{
/** Maximum inscribed radius (mm) of an ileum. Haustra are wider, except for their corners. */
constexpr double ilealRadius = 8.5;
/** Length (mm) of the part of the ileum next to the wide lumen that is not removed; crevices next to lips are
 * shallower. */
constexpr double leftWithColon = 4.0;
/** Maximum distance (mm) of the ileum from the line. */
constexpr double margin = 110.0;
/** Maximum distance (mm) of the opening from the valve. */
constexpr double fromValve = 25.0;
/** Minimum length, mm; corners of haustra are shallower. */
constexpr double leastLength = 30.0;

/** Mask of the lumen that is more than leftWithColon away from its opening by a ball of the ileal radius. */
std::vector<unsigned char>
NarrowLumen(const CecalRegion & region)
{
  const std::array<double, 3> spacing{ { CecalRegion::Step, CecalRegion::Step, CecalRegion::Step } };
  const auto                  toWall = SquaredDistances(region.Grid(), spacing, region.Lumen(), ilealRadius);
  std::vector<unsigned char>  noMiddle(toWall.size());
  for (std::size_t voxel = 0; voxel < noMiddle.size(); ++voxel)
  {
    noMiddle[voxel] = toWall[voxel] < ilealRadius * ilealRadius ? 1 : 0;
  }
  constexpr double           reach = ilealRadius + leftWithColon; // mm
  const auto                 toMiddle = SquaredDistances(region.Grid(), spacing, noMiddle, reach);
  std::vector<unsigned char> narrow(toWall.size());
  for (std::size_t voxel = 0; voxel < narrow.size(); ++voxel)
  {
    narrow[voxel] = region.IsLumen(voxel) && toMiddle[voxel] > reach * reach ? 1 : 0;
  }
  return narrow;
}

/** A branch of narrow lumen, starting at the wide lumen. */
struct Branch
{
  std::vector<std::size_t> mouth;
  std::vector<std::size_t> voxels;
};

bool
TouchesWideLumen(const CecalRegion & region, const std::vector<unsigned char> & narrow, std::size_t voxel)
{
  bool touches = false;
  ForEachNeighbor(region.Grid(), voxel, [&](std::size_t neighbor) {
    touches = touches || (region.IsLumen(neighbor) && narrow[neighbor] == 0);
  });
  return touches;
}

/** Moves the connected part around a voxel from `free` to a branch. */
Branch
GrowBranch(const CecalRegion &                region,
           const std::vector<unsigned char> & narrow,
           std::size_t                        seed,
           std::vector<unsigned char> &       free)
{
  Branch branch;
  branch.voxels.push_back(seed);
  free[seed] = 0;
  for (std::size_t next = 0; next < branch.voxels.size(); ++next)
  {
    const std::size_t voxel = branch.voxels[next];
    if (TouchesWideLumen(region, narrow, voxel))
    {
      branch.mouth.push_back(voxel);
    }
    ForEachNeighbor(region.Grid(), voxel, [&](std::size_t neighbor) {
      if (free[neighbor] != 0)
      {
        free[neighbor] = 0;
        branch.voxels.push_back(neighbor);
      }
    });
  }
  return branch;
}

/** Straight distance from the mouth to the farthest voxel, mm. */
double
LengthOf(const CecalRegion & region, const Branch & branch, const Eigen::Vector3d & mouth)
{
  double farthest = 0.0;
  for (const std::size_t voxel : branch.voxels)
  {
    farthest = std::max(farthest, (region.PointOf(voxel) - mouth).norm());
  }
  return farthest;
}

/** Mask of the branch on the voxels of the region. */
std::vector<unsigned char>
VoxelsOf(const CecalRegion & region, const Branch & branch)
{
  std::vector<unsigned char> isBranch(region.Grid().NumberOfVoxels(), 0);
  for (const std::size_t voxel : branch.voxels)
  {
    isBranch[voxel] = 1;
  }
  return isBranch;
}

bool
HoldsLine(const CecalRegion & region, const Branch & branch, const CurveSet & centerline)
{
  const std::vector<unsigned char> isBranch = VoxelsOf(region, branch);
  for (Eigen::Index i = 0; i < centerline.V.rows(); ++i)
  {
    const std::ptrdiff_t voxel = region.VoxelAt(centerline.V.row(i).transpose());
    if (voxel >= 0 && isBranch[voxel] != 0)
    {
      return true;
    }
  }
  return false;
}

LumenMask::Pointer
MaskOf(const CecalRegion & region, const Branch & branch, const LumenMask * labels)
{
  const std::vector<unsigned char> isBranch = VoxelsOf(region, branch);
  const auto                       mask = NewImageOn<LumenMask>(labels, true);
  for (itk::ImageRegionIteratorWithIndex<LumenMask> one(mask, mask->GetBufferedRegion()); !one.IsAtEnd(); ++one)
  {
    if (labels->GetPixel(one.GetIndex()) != 0)
    {
      const auto           point = labels->TransformIndexToPhysicalPoint<double>(one.GetIndex());
      const std::ptrdiff_t voxel = region.VoxelAt(Eigen::Vector3d(point.GetDataPointer()));
      one.Set(voxel >= 0 ? isBranch[voxel] : 0);
    }
  }
  return mask;
}

/** Whether the branch is connected to the wide lumen only at the valve; sets `middle` to the center of the opening. */
bool
LeavesAtValve(const CecalRegion & region, const Branch & branch, const IleocecalValve & valve, Eigen::Vector3d & middle)
{
  middle.setZero();
  for (const std::size_t voxel : branch.mouth)
  {
    if ((region.PointOf(voxel) - valve.position).norm() > fromValve)
    {
      return false;
    }
    middle += region.PointOf(voxel) / static_cast<double>(branch.mouth.size());
  }
  return !branch.mouth.empty();
}
} // namespace

std::optional<TerminalIleum>
FindTerminalIleum(const LumenMask * labels, const CurveSet & centerline, const IleocecalValve & valve)
{
  const CecalRegion                region(labels, nullptr, centerline, margin);
  const std::vector<unsigned char> narrow = NarrowLumen(region);
  std::vector<unsigned char>       free = narrow;
  std::optional<TerminalIleum>     longest;
  for (std::size_t seed = 0; seed < free.size(); ++seed)
  {
    if (free[seed] == 0)
    {
      continue;
    }
    const Branch    branch = GrowBranch(region, narrow, seed, free);
    Eigen::Vector3d mouth;
    if (!LeavesAtValve(region, branch, valve, mouth) || HoldsLine(region, branch, centerline))
    {
      continue;
    }
    const double length = LengthOf(region, branch, mouth);
    if (length >= leastLength && (!longest || length > longest->length))
    {
      const double cube = CecalRegion::Step * CecalRegion::Step * CecalRegion::Step;
      longest = TerminalIleum{
        MaskOf(region, branch, labels), mouth, length, 1e-3 * cube * static_cast<double>(branch.voxels.size())
      };
    }
  }
  return longest;
}

template <typename TImage>
void
TakeOut(const TerminalIleum & ileum, TImage * image)
{
  using Iterator = itk::ImageRegionIteratorWithIndex<TImage>;
  for (Iterator one(image, image->GetBufferedRegion()); !one.IsAtEnd(); ++one)
  {
    LumenMask::IndexType index;
    const auto           point = image->template TransformIndexToPhysicalPoint<double>(one.GetIndex());
    if (one.Get() != 0 && ileum.mask->TransformPhysicalPointToIndex(point, index) && ileum.mask->GetPixel(index) != 0)
    {
      one.Set(0);
    }
  }
}

template void
TakeOut(const TerminalIleum &, LumenMask *);
template void
TakeOut(const TerminalIleum &, itk::Image<float, 3> *);
} // namespace shapeton
