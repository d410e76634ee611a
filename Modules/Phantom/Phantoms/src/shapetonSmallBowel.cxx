#include "shapetonSmallBowel.h"

#include "shapetonColonBody.h"
#include "shapetonForEachCell.h"
#include "shapetonPhantomRandom.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
using PointType = PhantomBody::PointType;
using VectorType = itk::Vector<double, 3>;

constexpr int    numberOfLoops = 90; // chosen
constexpr double stepLength = 11.0;  // mm
constexpr double cellSide = 4.0;     // mm
constexpr int    cellsOfBlock = 4;   // cells
constexpr double reach = 6.0;        // mm around the loops; maximum distance
constexpr double cellMargin = 26.0;  // mm around the region of the axes; more than the widest loop and `reach`
constexpr double flatness = 0.7;     // loops run less toward front and back
constexpr double noGas = 1e9;        // mm, a level above all loops

constexpr DrawnRange loopRadius{ 10.0, 14.0 }; // mm
// HU of the content of a loop.
constexpr DrawnRange thinTagged{ 260.0, 460.0 };
constexpr DrawnRange fullTagged{ 560.0, 800.0 };
constexpr DrawnRange untaggedContent{ 20.0, 60.0 };

struct Loop
{
  std::vector<PointType> axis;
  double                 radius;
  double                 intensity;
  double                 gasHeight; // gas above this height: -down * p, mm
};

// The region of the abdomen filled by the loops.
const PointType  regionCenter = MakePoint(0.0, -32.0, -30.0);
const VectorType regionRadii = MakeVector(98.0, 52.0, 88.0);

bool
IsInRegion(const PointType & p)
{
  double sum = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double x = (p[i] - regionCenter[i]) / regionRadii[i];
    sum += x * x;
  }
  return sum < 1.0;
}

VectorType
RandomDirection(PhantomRandom & random)
{
  VectorType direction = MakeVector(random.Uniform(-1, 1), random.Uniform(-flatness, flatness), random.Uniform(-1, 1));
  direction.Normalize();
  return direction;
}

std::vector<PointType>
RandomAxis(PhantomRandom & random)
{
  PointType start = regionCenter;
  do
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      start[i] = regionCenter[i] + random.Uniform(-1, 1) * regionRadii[i];
    }
  } while (!IsInRegion(start));
  std::vector<PointType> axis{ start };
  VectorType             direction = RandomDirection(random);
  const VectorType       turn = RandomDirection(random) * 0.35;
  const auto             steps = static_cast<std::size_t>(random.Uniform(6.0, 12.0));
  while (axis.size() < steps)
  {
    direction += turn;
    direction.Normalize();
    const PointType next = axis.back() + direction * stepLength;
    if (!IsInRegion(next))
    {
      break;
    }
    axis.push_back(next);
  }
  return axis;
}

double
RandomIntensity(PhantomRandom & random, double tagged)
{
  constexpr double thinShare = 0.6875; // fraction of the tagged loops
  const double     kind = random.Uniform(0.0, 1.0);
  if (kind < thinShare * tagged)
  {
    return random.Uniform(thinTagged);
  }
  return random.Uniform(kind < tagged ? fullTagged : untaggedContent);
}

Loop
RandomLoop(PhantomRandom & random, const VectorType & down, double tagged)
{
  Loop loop;
  loop.axis = RandomAxis(random);
  loop.radius = random.Uniform(loopRadius);
  loop.intensity = RandomIntensity(random, tagged);
  double highest = -1e9;
  for (const auto & p : loop.axis)
  {
    highest = std::max(highest, -(down * p.GetVectorFromOrigin()));
  }
  const bool   holdsGas = random.Uniform(0.0, 1.0) < 0.3;
  const double bubble = random.Uniform(5.0, 11.0);
  loop.gasHeight = holdsGas ? highest + loop.radius - bowelWall - bubble : noGas;
  return loop;
}

class SmallBowel : public PhantomBody
{
public:
  SmallBowel(unsigned seed, const VectorType & down, double tagged) : m_Down(down)
  {
    PhantomRandom random(seed, 0x5b0);
    for (int i = 0; i < numberOfLoops; ++i)
    {
      m_Loops.push_back(RandomLoop(random, down, tagged));
    }
    this->FillCells();
  }

  double
  LumenDistance(const PointType & point) const
  {
    const Nearest near = this->FindNearest(point);
    return near.loop == nullptr ? reach : near.lumen;
  }

  BodyProbe
  Probe(const PointType & point) const override
  {
    const Nearest near = this->FindNearest(point);
    if (near.loop == nullptr)
    {
      return { near.outer, near.outer };
    }
    double clearance = std::min(std::abs(near.outer), std::abs(near.lumen));
    if (near.lumen < 0.0)
    {
      clearance = std::min(clearance, std::abs(this->AboveLevel(*near.loop, point)));
    }
    return { near.outer, clearance };
  }

  double
  Intensity(const PointType & point) const override
  {
    const Nearest near = this->FindNearest(point);
    if (near.loop == nullptr || near.lumen > 0.0)
    {
      return softTissueIntensity;
    }
    return this->AboveLevel(*near.loop, point) > 0.0 ? gasIntensity : near.loop->intensity;
  }

  void
  Paint(const PointType & point, double width, double & value) const override
  {
    const Nearest near = this->FindNearest(point);
    if (near.loop == nullptr)
    {
      return;
    }
    value += ShareInside(near.outer, width) * (softTissueIntensity - value);
    const double gas = ShareInside(-this->AboveLevel(*near.loop, point), width);
    const double content = near.loop->intensity + gas * (gasIntensity - near.loop->intensity);
    value += ShareInside(near.lumen, width) * (content - value);
  }

private:
  struct Segment
  {
    int loop;
    int end; // index of the second point on the axis
  };
  using Segments = std::vector<Segment>;
  using Cell = std::array<int, 3>;

  struct Nearest
  {
    const Loop * loop;
    double       outer; // signed distances, negative inside
    double       lumen;
  };

  double
  AboveLevel(const Loop & loop, const PointType & point) const
  {
    return -(m_Down * point.GetVectorFromOrigin()) - loop.gasHeight;
  }

  // Finds the candidates of a block, then of its cells.
  void
  FillCells()
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Corner[i] = regionCenter[i] - regionRadii[i] - cellMargin;
      m_Size[i] =
        cellsOfBlock * static_cast<int>(std::ceil(2.0 * (regionRadii[i] + cellMargin) / (cellsOfBlock * cellSide)));
    }
    m_Cells.resize(static_cast<std::size_t>(m_Size[0]) * m_Size[1] * m_Size[2]);
    const Segments all = this->AllSegments();
    ForEachCell({ 0, 0, 0 }, m_Size, cellsOfBlock, [&](const Cell & block) {
      const Segments near = this->SegmentsNear(this->PointOf(block, cellsOfBlock), cellsOfBlock * cellSide, all);
      const Cell     end{ { block[0] + cellsOfBlock, block[1] + cellsOfBlock, block[2] + cellsOfBlock } };
      ForEachCell(block, end, 1, [&](const Cell & cell) {
        m_Cells[(static_cast<std::size_t>(cell[2]) * m_Size[1] + cell[1]) * m_Size[0] + cell[0]] =
          this->SegmentsNear(this->PointOf(cell, 1), cellSide, near);
      });
    });
  }

  Segments
  AllSegments() const
  {
    Segments all;
    for (int i = 0; i < numberOfLoops; ++i)
    {
      const auto & axis = m_Loops[i].axis;
      for (std::size_t k = 0; k + 1 < std::max<std::size_t>(axis.size(), 2); ++k)
      {
        all.push_back({ i, static_cast<int>(std::min(k + 1, axis.size() - 1)) });
      }
    }
    return all;
  }

  double
  DistanceTo(const Segment & segment, const PointType & point) const
  {
    const Loop & loop = m_Loops[segment.loop];
    const int    start = std::max(segment.end - 1, 0);
    return DistanceToSegment(point, loop.axis[start], loop.axis[segment.end]) - loop.radius;
  }

  // Loops that may be among the two nearest to any point of a cube.
  Segments
  SegmentsNear(const PointType & center, double side, const Segments & among) const
  {
    const double        radius = 0.87 * side;
    std::vector<double> distances;
    double              nearest = reach;
    double              second = reach;
    int                 nearestLoop = -1;
    for (const Segment & segment : among)
    {
      const double distance = this->DistanceTo(segment, center);
      distances.push_back(distance);
      if (segment.loop != nearestLoop && distance < nearest)
      {
        second = nearest;
        nearestLoop = segment.loop;
      }
      else if (segment.loop != nearestLoop)
      {
        second = std::min(second, distance);
      }
      nearest = std::min(nearest, distance);
    }
    Segments near;
    for (std::size_t i = 0; i < among.size(); ++i)
    {
      if (distances[i] < second + 2.0 * radius)
      {
        near.push_back(among[i]);
      }
    }
    return near;
  }

  // The center of a cube of `side` cells.
  PointType
  PointOf(const Cell & first, int side) const
  {
    return m_Corner + MakeVector(first[0] + 0.5 * side, first[1] + 0.5 * side, first[2] + 0.5 * side) * cellSide;
  }

  const Segments *
  CellAt(const PointType & point) const
  {
    std::size_t cell = 0;
    for (int i = 2; i >= 0; --i)
    {
      const double x = (point[i] - m_Corner[i]) / cellSide;
      if (x < 0.0 || x >= m_Size[i])
      {
        return nullptr;
      }
      cell = cell * m_Size[i] + static_cast<std::size_t>(x);
    }
    return &m_Cells[cell];
  }

  // The walls of the two nearest loops meet halfway.
  Nearest
  FindNearest(const PointType & point) const
  {
    const auto * const cell = this->CellAt(point);
    Nearest            nearest{ nullptr, reach, reach };
    double             second = reach;
    if (cell == nullptr)
    {
      return nearest;
    }
    for (const auto & segment : *cell)
    {
      const Loop & loop = m_Loops[segment.loop];
      const double distance = this->DistanceTo(segment, point);
      if (&loop == nearest.loop)
      {
        nearest.outer = std::min(nearest.outer, distance);
      }
      else if (distance < nearest.outer)
      {
        second = nearest.outer;
        nearest = { &loop, distance, 0.0 };
      }
      else
      {
        second = std::min(second, distance);
      }
    }
    nearest.lumen = std::max(nearest.outer + bowelWall, 0.5 * (bowelWall - (second - nearest.outer)));
    return nearest;
  }

  VectorType            m_Down;
  std::vector<Loop>     m_Loops;
  PointType             m_Corner;
  Cell                  m_Size;
  std::vector<Segments> m_Cells;
};
} // namespace

SmallBowelLoops
MakeSmallBowel(unsigned seed, const itk::Vector<double, 3> & down, double tagged)
{
  const auto bowel = std::make_shared<const SmallBowel>(seed, down, tagged);
  return { bowel, { [bowel](const PointType & p) { return bowel->LumenDistance(p); } } };
}
} // namespace shapeton
