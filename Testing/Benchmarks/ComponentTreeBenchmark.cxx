// Builds the max-tree and the min-tree of a heat-like volume of float numbers with BuildComponentTrees(), on 1 and 2
// threads, and with a sequential peer, alternately in one run; then selects an object as a click does. Arguments: side
// of the volume in voxels, default 256; number of rounds, default 3.
#include "Times.h"

#include "shapetonComponentTree.h"
#include "shapetonHeatObjects.h"
#include "shapetonParallelFor.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace
{
using namespace shapeton;
using HeatImage = itk::Image<float, 3>;
using Index = ComponentTree::Index;

constexpr double mostSeconds = 6.0; // for both trees, 2 threads
constexpr double leastSpeedup = 1.6;
constexpr double mostClickSeconds = 0.05;

void
PrintTimes(const char * text, const Times & times)
{
  std::printf("  %-42s elapsed: median %7.3f s, best %7.3f s   processor: median %7.3f s\n",
              text,
              UpperMedian(times.elapsed),
              *std::min_element(times.elapsed.begin(), times.elapsed.end()),
              UpperMedian(times.processor));
}

/** Smooth blobs of different size and heat, with noise of up to one percent of the value. */
HeatImage::Pointer
MakeHeat(int side)
{
  struct Blob
  {
    double x, y, z, perRadius, heat;
  };
  constexpr int                          blobs = 40;
  constexpr double                       noise = 0.01;
  constexpr double                       surroundings = 0.002;
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> place(0.0, side), radius(0.04 * side, 0.12 * side), share(0.1, 0.9);
  std::vector<Blob>                      scene;
  for (int i = 0; i < blobs; ++i)
  {
    scene.push_back({ place(random), place(random), place(random), 1.0 / radius(random), share(random) });
  }
  const auto image = HeatImage::New();
  image->SetRegions(HeatImage::SizeType::Filled(static_cast<itk::SizeValueType>(side)));
  image->Allocate();
  const VoxelGrid grid(side, side, side);
  ParallelFor(static_cast<std::size_t>(side), [&](std::size_t k) {
    std::minstd_rand                      ofSlice(static_cast<unsigned int>(k) + 1);
    std::uniform_real_distribution<float> weak(1.0F - noise, 1.0F + noise);
    for (std::size_t voxel = k * grid.stride[2]; voxel < (k + 1) * grid.stride[2]; ++voxel)
    {
      const auto at = grid.Voxel(voxel);
      double     heat = surroundings;
      for (const Blob & blob : scene)
      {
        const double distance = blob.perRadius * std::hypot(at[0] - blob.x, at[1] - blob.y, at[2] - blob.z);
        heat += distance < 3.0 ? blob.heat * std::exp(-distance * distance) : 0.0;
      }
      image->GetBufferPointer()[voxel] = static_cast<float>(heat) * weak(ofSlice);
    }
  });
  return image;
}

/** The peer: a max-tree by sorting and union-find with path compression (Berger et al. 2007), stored as the parent of
 * each voxel. Voxels with equal values and the root of their region have canonical parents. */
std::vector<Index>
PeerTree(const float * values, const VoxelGrid & grid, double sign)
{
  const std::size_t  voxels = grid.NumberOfVoxels();
  std::vector<Index> order(voxels), parent(voxels), root(voxels, ~Index{ 0 });
  std::iota(order.begin(), order.end(), Index{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return sign * values[a] > sign * values[b]; });
  const auto find = [&root](Index voxel) {
    Index top = voxel;
    while (root[top] != top)
    {
      top = root[top];
    }
    while (root[voxel] != top)
    {
      const Index next = root[voxel];
      root[voxel] = top;
      voxel = next;
    }
    return top;
  };
  for (const Index voxel : order)
  {
    parent[voxel] = root[voxel] = voxel;
    const auto at = grid.Voxel(voxel);
    for (std::size_t axis = 0; axis < at.size(); ++axis)
    {
      for (const int step : { -1, 1 })
      {
        const int to = at[axis] + step;
        if (to < 0 || to >= grid.size[axis])
        {
          continue;
        }
        const auto neighbor = static_cast<Index>(voxel + step * static_cast<std::ptrdiff_t>(grid.stride[axis]));
        if (root[neighbor] != ~Index{ 0 })
        {
          const Index top = find(neighbor);
          if (top != voxel)
          {
            parent[top] = root[top] = voxel;
          }
        }
      }
    }
  }
  for (auto voxel = order.rbegin(); voxel != order.rend(); ++voxel)
  {
    const Index above = parent[*voxel];
    if (values[parent[above]] == values[above])
    {
      parent[*voxel] = parent[above];
    }
  }
  return parent;
}

/** Compares the number of voxels of all regions, except those whose last voxel has the value of the next one. */
void
RequireSameRegions(const ComponentTree & tree, const std::vector<Index> & parent, const float * values, double sign)
{
  std::vector<Index> order(parent.size()), count(parent.size(), 1), position(parent.size());
  std::iota(order.begin(), order.end(), Index{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return sign * values[a] > sign * values[b]; });
  for (const Index voxel : order)
  {
    if (parent[voxel] != voxel)
    {
      count[parent[voxel]] += count[voxel];
    }
  }
  for (Index i = 0; i < position.size(); ++i)
  {
    position[tree.GetVoxels()[i]] = i;
  }
  std::size_t compared = 0;
  for (Index voxel = 0; voxel < parent.size(); ++voxel)
  {
    if (parent[voxel] != voxel && values[parent[voxel]] == values[voxel])
    {
      continue; // not the last voxel of its region
    }
    const auto & arc = tree.GetArcs()[tree.GetArcOfVoxel()[voxel]];
    const Index  ours = position[voxel] + 1 - arc.first;
    const auto & parentArc = tree.GetArcs()[arc.parent];
    const Index  next = position[voxel] + 1 < arc.end ? position[voxel] + 1 : parentArc.begin;
    const bool   isTie = next < parentArc.end && values[tree.GetVoxels()[next]] == values[voxel];
    if (!isTie && ours != count[voxel])
    {
      throw std::runtime_error("the trees differ at voxel " + std::to_string(voxel) + ": " + std::to_string(ours) +
                               " and " + std::to_string(count[voxel]) + " voxels");
    }
    compared += isTie ? 0 : 1;
  }
  std::printf("  %zu regions compared with the peer: equal\n", compared);
}

void
Run(int side, int rounds)
{
  const auto    image = MakeHeat(side);
  const float * values = image->GetBufferPointer();
  VoxelGrid     grid(side, side, side);
  Times         one, two, peer, click;
  std::printf("%d^3 voxels, %d rounds; machine of %u threads\n", side, rounds, NumberOfThreads());
  for (int round = 0; round < rounds; ++round)
  {
    ComponentTrees     trees;
    std::vector<Index> warm, cold;
    SetNumberOfThreads(1);
    one.Measure([&] { trees = BuildComponentTrees(values, grid); });
    SetNumberOfThreads(2);
    two.Measure([&] { trees = BuildComponentTrees(values, grid); });
    peer.Measure([&] {
      warm = PeerTree(values, grid, 1.0);
      cold = PeerTree(values, grid, -1.0);
    });
    if (round == 0)
    {
      std::printf("  arcs: %zu of the max-tree, %zu of the min-tree\n",
                  trees.maxTree.GetArcs().size(),
                  trees.minTree.GetArcs().size());
      RequireSameRegions(trees.maxTree, warm, values, 1.0);
      RequireSameRegions(trees.minTree, cold, values, -1.0);
    }
  }
  HeatObjectOptions options;
  options.leastProbability = 0.0; // clicks are timed, not judged
  const auto list = FindHeatObjects({ image }, options);
  for (int object = 1; object <= static_cast<int>(list.objects.size()) && object <= rounds; ++object)
  {
    click.Measure([&] { MaskOfObject(list, object); });
    std::printf("  object of %llu voxels: %.4f s\n",
                static_cast<unsigned long long>(list.objects[object - 1].voxels),
                click.elapsed.back());
  }
  PrintTimes("both trees, 1 thread", one);
  PrintTimes("both trees, 2 threads", two);
  PrintTimes("peer, both trees, sequential", peer);
  PrintBound("seconds of both trees, 2 threads", UpperMedian(two.elapsed), mostSeconds);
  const double speedup = UpperMedian(one.elapsed) / UpperMedian(two.elapsed);
  PrintBound("times faster with 2 threads", speedup, leastSpeedup, true);
  std::printf(
    "  %-42s %8.3f\n", "times faster than the peer, 1 thread", UpperMedian(peer.elapsed) / UpperMedian(one.elapsed));
  if (!click.elapsed.empty())
  {
    const double slowest = *std::max_element(click.elapsed.begin(), click.elapsed.end());
    PrintBound("seconds of a click, the largest objects", slowest, mostClickSeconds);
  }
  std::printf("  peak memory, with the peer: %.2f GB\n", PeakMegabytes() / 1024.0);
}
} // namespace

int
main(int argc, char * argv[])
{
  const int side = argc > 1 ? std::atoi(argv[1]) : 256;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 3;
  if (side < 2 || rounds < 1)
  {
    std::fprintf(stderr, "usage: ComponentTreeBenchmark [side of the volume] [rounds]\n");
    return EXIT_FAILURE;
  }
  try
  {
    Run(side, rounds);
  }
  catch (const std::exception & error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
