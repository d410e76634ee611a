#include "shapetonCatheterFilling.h"

#include "shapetonCatheterBalloon.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double TipReach = 20.0;         // mm around the inner end; chosen: holds the side holes and the bulb
constexpr double TipClosing = 2.3;        // mm, half the maximum wall thickness
constexpr double MembraneClosing = 1.5;   // mm; chosen: half a blurred membrane
constexpr double LargestPocketMl = 120.0; // a ball with a radius of 30 mm, as LargestBalloon

VoxelBox
BoxAround(const ColonGrid & grid, const Eigen::Vector3d & center, double reach)
{
  const Eigen::Vector3d voxel = grid.VoxelOf(center);
  VoxelBox              box;
  for (int a = 0; a < 3; ++a)
  {
    box.low[a] = std::clamp(static_cast<int>(std::lround(voxel[a])), 0, grid.size[a] - 1);
    box.high[a] = box.low[a] + 1;
  }
  return grid.Widened(box, reach + grid.spacing.maxCoeff());
}

/** Calls `body(index, position)` for the voxels of a box. */
template <typename TBody>
void
ForEachVoxelOf(const VoxelBox & box, const ColonGrid & grid, const TBody & body)
{
  for (int k = box.low[2]; k < box.high[2]; ++k)
  {
    for (int j = box.low[1]; j < box.high[1]; ++j)
    {
      for (int i = box.low[0]; i < box.high[0]; ++i)
      {
        body(grid.Index(i, j, k), grid.Position(Eigen::Vector3d(i, j, k)));
      }
    }
  }
}

/** Calls `body(index, ray, distance from the axis)` for the voxels in the slice of a tube that a section represents. */
template <typename TBody>
void
ForEachAcross(const ColonGrid & grid, const TubeSection & section, double reach, const TBody & body)
{
  const double half = std::max(0.75, 0.5 * grid.spacing.maxCoeff()); // mm, so that sections overlap
  ForEachVoxelOf(BoxAround(grid, section.center, reach), grid, [&](std::size_t p, const Eigen::Vector3d & x) {
    double    distance = 0.0;
    const int ray = section.RayTo(x, distance);
    if (std::abs((x - section.center).dot(section.along)) <= half && distance <= reach)
    {
      body(p, section.rays[ray], distance);
    }
  });
}

/** Fills the bore and the wall of a tube with fluid where the wall is next to fluid, and with gas elsewhere. Uses the
 * median outer radius where the outside of the wall is not visible, as in the anal canal. */
ClassVolume
VoxelsOfTube(const CatheterTube & tube, const ColonGrid & grid)
{
  // Distance (mm) from the axis; 1 mm allows for errors of the axis.
  constexpr double widest = LargestBoreRadius + 1.0 + ThickestTubeWall;
  ClassVolume      taken(grid.NumberOfVoxels(), Nothing);
  for (const auto & section : tube.sections)
  {
    ForEachAcross(grid, section, widest, [&](std::size_t p, const TubeRay & ray, double distance) {
      if (distance <= (ray.IsEnclosed() ? ray.outer : tube.outerRadius))
      {
        taken[p] = ray.behind == BehindLayer::Fluid ? ColonFluid : ColonGas;
      }
    });
  }
  return taken;
}

/** Voxels added by morphological closing of the lumen in a region. */
std::vector<unsigned char>
AddedByClosing(const ColonGrid & grid, const ClassVolume & classes, double radius)
{
  const auto                 square = static_cast<float>(radius * radius);
  std::vector<unsigned char> mask(classes.size());
  std::transform(classes.begin(), classes.end(), mask.begin(), [](unsigned char c) { return !IsColonLumen(c); });
  const auto toLumen = SquaredDistanceToBackground(grid, mask, radius);
  std::transform(toLumen.begin(), toLumen.end(), mask.begin(), [=](float d) { return d <= square; });
  const auto toFar = SquaredDistanceToBackground(grid, mask, radius);
  std::transform(classes.begin(), classes.end(), toFar.begin(), mask.begin(), [=](unsigned char c, float d) {
    return !IsColonLumen(c) && d > square;
  });
  return mask;
}

/** Matter around a balloon, according to the exit point in the nearest direction. */
class AroundBalloon
{
public:
  explicit AroundBalloon(const CatheterBalloon & balloon) : m_Center(balloon.center), m_Exits(balloon.exits)
  {
    for (BalloonExit & exit : m_Exits)
    {
      exit.position = (exit.position - m_Center).normalized();
    }
  }

  unsigned char
  ClassAt(const Eigen::Vector3d & place) const
  {
    const Eigen::Vector3d direction = place - m_Center;
    const auto nearest = std::max_element(m_Exits.begin(), m_Exits.end(), [&](const auto & s, const auto & t) {
      return direction.dot(s.position) < direction.dot(t.position);
    });
    return nearest->into == BehindLayer::Fluid ? ColonFluid : ColonGas;
  }

private:
  Eigen::Vector3d          m_Center;
  std::vector<BalloonExit> m_Exits; ///< contain directions instead of positions
};

/** Sets the class PocketGas for gas outside the colon that does not touch the border of the region. */
void
MarkPockets(CatheterRegion & region)
{
  const ColonGrid & grid = region.grid;
  const VoxelRuns   set = CollectRuns(grid, [&](std::size_t p) { return region.classes[p] == OtherGas; });
  const RunLabels   labels = LabelRuns(set);
  const auto        pieces = PiecesOfRuns(set, labels);
  std::vector<char> isPocket(pieces.size(), 0);
  for (std::size_t p = 1; p < pieces.size(); ++p)
  {
    isPocket[p] = pieces[p].voxels * grid.VoxelVolume() * 1e-3 <= LargestPocketMl;
    for (int a = 0; a < 3; ++a)
    {
      isPocket[p] = isPocket[p] && pieces[p].box.low[a] > 0 && pieces[p].box.high[a] < grid.size[a];
    }
  }
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    const auto first = region.classes.begin() + static_cast<std::ptrdiff_t>(grid.Index(0, j, k));
    if (isPocket[labels.ofRun[r]])
    {
      std::fill(first + set.runs[r].begin, first + set.runs[r].end, PocketGas);
    }
  });
}

/** Adds the catheter to the lumen, part by part. */
class CatheterFilling
{
public:
  CatheterFilling(const CatheterTube & tube, CatheterRegion & region)
    : m_Region(region), m_Filled(VoxelsOfTube(tube, region.grid))
  {
    for (std::size_t p = 0; p < m_Filled.size(); ++p)
    {
      if (m_Filled[p] && !IsColonLumen(region.classes[p]))
      {
        region.classes[p] = m_Filled[p];
      }
    }
    this->FillPockets();
  }

  /** Adds the content of a balloon and its membrane; the class of gas outside the colon is unchanged. */
  void
  FillBalloon(const CatheterBalloon & balloon)
  {
    const ColonGrid &   grid = m_Region.grid;
    const AroundBalloon around(balloon);
    ForEachVoxelOf(
      BoxAround(grid, balloon.center, balloon.radius), grid, [&](std::size_t p, const Eigen::Vector3d & x) {
        unsigned char & c = m_Region.classes[p];
        if ((x - balloon.center).norm() <= balloon.radius && !IsColonLumen(c) && c != OtherGas)
        {
          const bool isGas = m_Region.hu[p] < m_Region.thresholds.gasBoundary;
          c = m_Filled[p] = isGas ? static_cast<unsigned char>(ColonGas) : around.ClassAt(x);
        }
      });
    this->FillHanging(balloon.center, balloon.radius + 1.0, MembraneClosing, [&](const Eigen::Vector3d & x) {
      return around.ClassAt(x);
    });
  }

  /** Adds the part of the closing of the lumen that is within `reach` of a position and connected to the filled part,
   * with the class `classAt(position)`. Returns the added voxels. */
  template <typename TClassAt>
  VoxelSet
  FillHanging(const Eigen::Vector3d & place, double reach, double closing, const TClassAt & classAt)
  {
    const VoxelBox  box = BoxAround(m_Region.grid, place, reach + 2.0 * closing);
    const ColonGrid part = m_Region.grid.Part(box);
    const auto      whole = [&](std::size_t p) {
      const auto v = part.Voxel(p);
      return m_Region.grid.Index(v[0] + box.low[0], v[1] + box.low[1], v[2] + box.low[2]);
    };
    ClassVolume classes(part.NumberOfVoxels());
    VoxelSet    front;
    for (std::size_t p = 0; p < classes.size(); ++p)
    {
      classes[p] = m_Region.classes[whole(p)];
      if (m_Filled[whole(p)])
      {
        front.push_back(p);
      }
    }
    auto     added = AddedByClosing(part, classes, closing);
    VoxelSet hanging;
    while (!front.empty())
    {
      const auto p = front.back();
      front.pop_back();
      ForEachNeighbor(part, p, [&](std::size_t q) {
        if (added[q] && (part.Position(q) - place).norm() <= reach)
        {
          added[q] = 0;
          m_Region.classes[whole(q)] = m_Filled[whole(q)] = classAt(part.Position(q));
          front.push_back(q);
          hanging.push_back(whole(q));
        }
      });
    }
    return hanging;
  }

private:
  /** Adds the pockets of gas around the tube to the lumen. */
  void
  FillPockets()
  {
    const ColonGrid & grid = m_Region.grid;
    VoxelSet          front;
    const auto        take = [&](std::size_t p) {
      if (m_Region.classes[p] == PocketGas)
      {
        m_Region.classes[p] = ColonGas;
        front.push_back(p);
      }
    };
    for (std::size_t p = 0; p < m_Filled.size(); ++p)
    {
      if (m_Filled[p])
      {
        ForEachNeighbor(grid, p, take);
      }
    }
    while (!front.empty())
    {
      const auto p = front.back();
      front.pop_back();
      ForEachNeighbor(grid, p, take);
    }
  }

  CatheterRegion & m_Region;
  ClassVolume      m_Filled;
};

RectalCatheter
Described(const CatheterTube & tube)
{
  RectalCatheter catheter;
  catheter.isSure = tube.evidence.confidence >= LeastCatheterConfidence;
  catheter.boreDiameter = 2.0 * tube.boreRadius;
  catheter.outerDiameter = 2.0 * tube.outerRadius;
  catheter.wallHU = tube.wallHU;
  catheter.evidence = tube.evidence;
  for (const auto & section : tube.sections)
  {
    catheter.axis.emplace_back(section.center.data());
  }
  return catheter;
}

/** Extends the axis through the middle of the tip to its end. */
void
ExtendToTip(const ColonGrid & grid, const VoxelSet & tip, RectalCatheter & catheter)
{
  const auto            place = [&](std::size_t n) { return Eigen::Vector3d(catheter.axis[n].GetDataPointer()); };
  const Eigen::Vector3d end = place(catheter.axis.size() - 1);
  const Eigen::Vector3d ahead = end - place(catheter.axis.size() / 2);
  Eigen::Vector3d       onwards = Eigen::Vector3d::Zero();
  for (const auto p : tip)
  {
    const Eigen::Vector3d d = grid.Position(p) - end;
    onwards += d.dot(ahead) > 0.0 ? d : Eigen::Vector3d::Zero();
  }
  if (onwards.norm() == 0.0)
  {
    return;
  }
  onwards.normalize();
  double length = 0.0;
  for (const auto p : tip)
  {
    const Eigen::Vector3d d = grid.Position(p) - end;
    length = std::max(length, d.dot(onwards));
    catheter.tipRadius = std::max(catheter.tipRadius, (d - d.dot(onwards) * onwards).norm());
  }
  for (double t = 1.0; t <= length; t += 1.0)
  {
    catheter.axis.emplace_back(Eigen::Vector3d(end + t * onwards).data());
  }
}

double
LumenMl(const CatheterRegion & region)
{
  const auto number = std::count_if(region.classes.begin(), region.classes.end(), IsColonLumen);
  return 1e-3 * static_cast<double>(number) * region.grid.VoxelVolume();
}

void
FillIn(const CatheterTube & tube, CatheterRegion & region, RectalCatheter & catheter)
{
  const double    before = LumenMl(region);
  const auto      balloon = FindBalloon(tube, region);
  CatheterFilling filling(tube, region);
  if (balloon)
  {
    catheter.balloonDiameter = 2.0 * balloon->radius;
    catheter.balloonCenter = itk::Point<double, 3>(balloon->center.data());
    filling.FillBalloon(*balloon);
  }
  const auto     gas = [](const Eigen::Vector3d &) -> unsigned char { return ColonGas; };
  const VoxelSet tip = filling.FillHanging(tube.sections.back().center, TipReach, TipClosing, gas);
  ExtendToTip(region.grid, tip, catheter);
  catheter.filledMl = LumenMl(region) - before;
}
} // namespace

std::optional<RectalCatheter>
FillRectalCatheter(LumenField & field)
{
  const VoxelBox box = BoxOfCatheter(field.grid, field.classes);
  const auto     first = static_cast<std::ptrdiff_t>(box.low[2] * field.grid.stride[2]);
  const auto     last = static_cast<std::ptrdiff_t>(box.high[2] * field.grid.stride[2]);
  CatheterRegion region{ field.grid.Part(box),
                         { field.hu.begin() + first, field.hu.begin() + last },
                         { field.classes.begin() + first, field.classes.begin() + last },
                         field.evidence.thresholds };
  MarkPockets(region);
  const auto tube = FindCatheterTube(region);
  if (!tube)
  {
    return std::nullopt;
  }
  RectalCatheter catheter = Described(*tube);
  if (catheter.isSure)
  {
    FillIn(*tube, region, catheter);
    std::replace(region.classes.begin(), region.classes.end(), PocketGas, static_cast<unsigned char>(OtherGas));
    std::copy(region.classes.begin(), region.classes.end(), field.classes.begin() + first);
  }
  return catheter;
}
} // namespace shapeton
