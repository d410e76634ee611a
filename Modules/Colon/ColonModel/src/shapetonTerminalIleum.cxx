#include "shapetonTerminalIleum.h"

#include "shapetonCecalRegion.h"
#include "shapetonIlealCaliber.h"
#include "shapetonMappedImage.h"
#include "shapetonSquaredDistances.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <algorithm>

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

/** Squared distances (mm^2) of lumen to the wall, up to `most`. */
VoxelValues
ToWall(const CecalRegion & region, double most)
{
  return SquaredDistances(
    region.Grid(), { { CecalRegion::Step, CecalRegion::Step, CecalRegion::Step } }, region.Lumen(), most);
}

/** Mask of the lumen that is more than `left` (mm) away from its opening by a ball. */
std::vector<unsigned char>
NarrowLumen(const CecalRegion & region, double radius, double left)
{
  const std::array<double, 3> spacing{ { CecalRegion::Step, CecalRegion::Step, CecalRegion::Step } };
  const auto                  toWall = ToWall(region, radius);
  std::vector<unsigned char>  noMiddle(toWall.size());
  for (std::size_t voxel = 0; voxel < noMiddle.size(); ++voxel)
  {
    noMiddle[voxel] = toWall[voxel] < radius * radius ? 1 : 0;
  }
  const double               reach = radius + left; // mm
  const auto                 toMiddle = SquaredDistances(region.Grid(), spacing, noMiddle, reach);
  std::vector<unsigned char> narrow(toWall.size());
  for (std::size_t voxel = 0; voxel < narrow.size(); ++voxel)
  {
    narrow[voxel] = region.IsLumen(voxel) && toMiddle[voxel] > reach * reach ? 1 : 0;
  }
  return narrow;
}

/** Mask of the lumen without the slit of an open valve. */
std::vector<unsigned char>
LumenWithoutSlit(const CecalRegion & region, const IleocecalValve & valve)
{
  constexpr double           reach = fromValve - CecalRegion::Step; // mm; the mouth is beside the slit
  std::vector<unsigned char> lumen = NarrowLumen(region, OpenValve, 0.0);
  for (std::size_t voxel = 0; voxel < lumen.size(); ++voxel)
  {
    const bool isSlit = lumen[voxel] != 0 && (region.PointOf(voxel) - valve.position).norm() <= reach;
    lumen[voxel] = region.IsLumen(voxel) && !isSlit ? 1 : 0;
  }
  return lumen;
}

/** A branch of lumen, starting at other lumen. */
struct Branch
{
  std::vector<std::size_t> mouth;
  std::vector<std::size_t> voxels;
  double                   length{ 0.0 }; ///< see LengthOf()
};

bool
TouchesOtherLumen(const CecalRegion & region, const std::vector<unsigned char> & lumen, std::size_t voxel)
{
  bool touches = false;
  ForEachNeighbor(region.Grid(), voxel, [&](std::size_t neighbor) {
    touches = touches || (region.IsLumen(neighbor) && lumen[neighbor] == 0);
  });
  return touches;
}

/** Moves the connected part around a voxel from `free` to a branch. */
Branch
GrowBranch(const CecalRegion &                region,
           const std::vector<unsigned char> & lumen,
           std::size_t                        seed,
           std::vector<unsigned char> &       free)
{
  Branch branch;
  branch.voxels.push_back(seed);
  free[seed] = 0;
  for (std::size_t next = 0; next < branch.voxels.size(); ++next)
  {
    const std::size_t voxel = branch.voxels[next];
    if (TouchesOtherLumen(region, lumen, voxel))
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

/** Center of the opening. */
Eigen::Vector3d
MiddleOfMouth(const CecalRegion & region, const Branch & branch)
{
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const std::size_t voxel : branch.mouth)
  {
    middle += region.PointOf(voxel) / static_cast<double>(branch.mouth.size());
  }
  return middle;
}

/** Straight distance from the center of the mouth to the farthest voxel, mm. */
double
LengthOf(const CecalRegion & region, const Branch & branch)
{
  const Eigen::Vector3d mouth = MiddleOfMouth(region, branch);
  double                farthest = 0.0;
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

/** Whether the branch is connected to other lumen only at the valve. */
bool
LeavesAtValve(const CecalRegion & region, const Branch & branch, const IleocecalValve & valve)
{
  return !branch.mouth.empty() && std::all_of(branch.mouth.begin(), branch.mouth.end(), [&](std::size_t voxel) {
    return (region.PointOf(voxel) - valve.position).norm() <= fromValve;
  });
}

/** The longest part of some lumen that is connected to the rest only at the valve and does not contain the line. */
std::optional<Branch>
LongestBranch(const CecalRegion &                region,
              const std::vector<unsigned char> & lumen,
              const CurveSet &                   centerline,
              const IleocecalValve &             valve)
{
  std::vector<unsigned char> free = lumen;
  std::optional<Branch>      longest;
  for (std::size_t seed = 0; seed < free.size(); ++seed)
  {
    if (free[seed] == 0)
    {
      continue;
    }
    Branch branch = GrowBranch(region, lumen, seed, free);
    if (LeavesAtValve(region, branch, valve) && !HoldsLine(region, branch, centerline))
    {
      branch.length = LengthOf(region, branch);
      if (branch.length >= (longest ? longest->length : leastLength))
      {
        longest = std::move(branch);
      }
    }
  }
  return longest;
}

/** The longest branch behind the slit of an open valve, unless it is too wide for an ileum. */
std::optional<Branch>
BranchBehindSlit(const CecalRegion & region, const CurveSet & centerline, const IleocecalValve & valve)
{
  auto branch = LongestBranch(region, LumenWithoutSlit(region, valve), centerline, valve);
  if (branch)
  {
    const auto toWall = ToWall(region, DistendedIleum + CecalRegion::Step);
    const auto isWide = [&](std::size_t voxel) { return toWall[voxel] > DistendedIleum * DistendedIleum; };
    if (std::any_of(branch->voxels.begin(), branch->voxels.end(), isWide))
    {
      branch.reset();
    }
  }
  return branch;
}
} // namespace

std::optional<TerminalIleum>
FindTerminalIleum(const LumenMask * labels, const CurveSet & centerline, const IleocecalValve & valve)
{
  const CecalRegion     region(labels, nullptr, centerline, margin);
  std::optional<Branch> branch =
    LongestBranch(region, NarrowLumen(region, ilealRadius, leftWithColon), centerline, valve);
  if (!branch)
  {
    branch = BranchBehindSlit(region, centerline, valve);
  }
  if (!branch)
  {
    return std::nullopt;
  }
  const double cube = CecalRegion::Step * CecalRegion::Step * CecalRegion::Step;
  return TerminalIleum{ MaskOf(region, *branch, labels),
                        MiddleOfMouth(region, *branch),
                        branch->length,
                        1e-3 * cube * static_cast<double>(branch->voxels.size()) };
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
