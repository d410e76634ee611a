#include "RandomScenes.h"

#include "SampledScenes.h"

#include "shapetonImageGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

using namespace shapeton;

namespace
{
using Json = nlohmann::ordered_json;
constexpr double        reach = 0.34;                  ///< centers of objects, in units of the side
constexpr std::uint32_t purposeOfScenes = 0x4f626a73U; ///< of the random numbers

Json
Solid(SceneDice & dice, double size)
{
  const auto part = [&] { return size * dice.Between(0.5, 1.0); };
  switch (dice.Count(0, 6))
  {
    case 0:
      return { { "kind", "sphere" }, { "radius", size } };
    case 1:
      return { { "kind", "ellipsoid" }, { "radii", { part(), part(), size } } };
    case 2:
      return { { "kind", "box" }, { "size", { 2.0 * part(), 2.0 * part(), 2.0 * size } } };
    case 3:
      return { { "kind", "cylinder" }, { "radius", part() }, { "length", 3.0 * size } };
    case 4:
      return { { "kind", "torus" }, { "ringRadius", size }, { "tubeRadius", size * dice.Between(0.25, 0.5) } };
    case 5:
      return { { "kind", "box" },
               { "size", { part(), 2.0 * part(), 3.0 * size } },
               { "deformations", { { { "kind", "twist" }, { "angle", dice.Between(20.0, 120.0) } } } } };
    default:
      return { { "kind", "capsule" },
               { "radius", 0.6 * part() },
               { "length", 3.0 * size },
               { "deformations", { { { "kind", "bend" }, { "angle", dice.Between(20.0, 120.0) } } } } };
  }
}

class SceneMaker
{
public:
  explicit SceneMaker(unsigned int seed) : m_Dice(seed, purposeOfScenes) {}

  Json
  Make()
  {
    if (m_Dice.Between(0.0, 1.0) < 0.6)
    {
      this->AddBones();
    }
    for (int solid = m_Dice.Count(4, 9); solid > 0; --solid)
    {
      this->AddSolid();
    }
    return Json{ { "units", "relative" }, { "objects", m_Objects } };
  }

private:
  void
  Add(Json object, double intensity)
  {
    object["intensity"] = intensity;
    object["label"] = m_Objects.size() + 1;
    m_Objects.push_back(object);
  }

  /** Adds a solid that may touch others but hardly overlaps them; adds nothing if there is no space. */
  void
  AddSolid()
  {
    constexpr int    tries = 30;
    constexpr double reachOfSize = 1.4; // of the middle one of the kinds
    for (int i = 0; i < tries; ++i)
    {
      const double size = m_Dice.Between(0.06, 0.16);
      const Json   center = m_Dice.Place(reach);
      if (!this->IsFree(center, reachOfSize * size))
      {
        continue;
      }
      Json object = Solid(m_Dice, size);
      object["center"] = center;
      object["rotation"] = m_Dice.Turn();
      this->Add(object, m_Dice.Between(500.0, 1000.0));
      m_Balls.push_back({ center, reachOfSize * size });
      if (m_Dice.Between(0.0, 1.0) < 0.2)
      {
        this->AddCore(object);
      }
      return;
    }
  }

  bool
  IsFree(const Json & center, double radius) const
  {
    return std::all_of(m_Balls.begin(), m_Balls.end(), [&](const Ball & ball) {
      double squares = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        squares += std::pow(center[axis].get<double>() - ball.center[axis].get<double>(), 2);
      }
      return std::sqrt(squares) >= radius + ball.radius;
    });
  }

  /** A ball of another intensity in the middle of an object. */
  void
  AddCore(const Json & object)
  {
    this->Add(Json{ { "kind", "sphere" }, { "radius", m_Dice.Between(0.03, 0.05) }, { "center", object["center"] } },
              m_Dice.Between(0.0, 1.0) < 0.5 ? 0.0 : m_Dice.Between(200.0, 2000.0));
  }

  /** Capsules in a line, with gaps from -1 to 2 percent of the side. */
  void
  AddBones()
  {
    const double radius = m_Dice.Between(0.045, 0.07);
    const double length = m_Dice.Between(0.12, 0.2); // between the middles of the caps
    const double y = m_Dice.Between(-reach, reach);
    const double z = m_Dice.Between(-reach, reach);
    double       x = -0.36;
    for (int bone = m_Dice.Count(2, 3); bone > 0; --bone)
    {
      const double whole = length + 2.0 * radius;
      this->Add(Json{ { "kind", "capsule" },
                      { "radius", radius },
                      { "length", whole },
                      { "center", { x + 0.5 * whole, y, z } },
                      { "rotation", { { "axis", { 0.0, 1.0, 0.0 } }, { "angle", 90.0 } } } },
                m_Dice.Between(700.0, 1000.0));
      m_Balls.push_back({ Json{ x + 0.5 * whole, y, z }, 0.5 * whole });
      x += whole + m_Dice.Between(-0.006, 0.02);
    }
  }

  struct Ball
  {
    Json   center;
    double radius;
  };

  SceneDice         m_Dice;
  Json              m_Objects = Json::array();
  std::vector<Ball> m_Balls; ///< around the solids
};
} // namespace

ShapeScene
RandomScene(unsigned int seed)
{
  return ShapeScene::FromJson(SceneMaker(seed).Make(), "random scene " + std::to_string(seed));
}

SceneVolume
SampleScene(unsigned int seed, unsigned int side)
{
  SceneDice           dice(seed + 1'000'000, purposeOfScenes);
  ShapePhantomOptions options;
  options.blur = dice.Between(0.0, 1.0);
  options.noise = dice.Between(0.0, 80.0);
  options.seed = seed;
  const auto source = SampledScene(RandomScene(seed), itk::Size<3>::Filled(side), options);
  return { ToFloat(source->GetOutput()), source->GetLabelOutput() };
}

namespace
{
/** For labels that touch only one other label, excluding the background: that other label. */
std::map<int, int>
NestedLabels(const itk::Image<unsigned char, 3> * labels)
{
  const VoxelGrid              grid = GridOf(labels);
  const unsigned char * const  values = labels->GetBufferPointer();
  std::map<int, std::set<int>> touched;
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    ForEachNeighbor(grid, voxel, [&](std::size_t neighbor) {
      if (values[neighbor] != values[voxel])
      {
        touched[values[voxel]].insert(values[neighbor]);
      }
    });
  }
  std::map<int, int> nested;
  for (const auto & [label, others] : touched)
  {
    if (label != 0 && others.size() == 1 && *others.begin() != 0)
    {
      nested[label] = *others.begin();
    }
  }
  return nested;
}

/** The labels that make up each whole object: each label, and each label with those nested in it. */
std::vector<std::set<int>>
WholeObjects(const itk::Image<unsigned char, 3> * labels)
{
  const unsigned char * const first = labels->GetBufferPointer();
  const std::set<int>         present(first, first + labels->GetBufferedRegion().GetNumberOfPixels());
  std::vector<std::set<int>>  wholes;
  for (const int label : present)
  {
    if (label != 0)
    {
      wholes.push_back({ label });
    }
  }
  std::map<int, std::set<int>> filled;
  for (const auto & [inner, outer] : NestedLabels(labels))
  {
    filled[outer].insert({ inner, outer });
  }
  for (const auto & [outer, parts] : filled)
  {
    wholes.push_back(parts);
  }
  return wholes;
}
} // namespace

ObjectAgreement
CompareObjects(const HeatObjectList & list, const itk::Image<unsigned char, 3> * labels)
{
  const auto wholes = WholeObjects(labels);
  const auto voxels = labels->GetBufferedRegion().GetNumberOfPixels();
  using Counts = std::array<double, 256>; // by label
  Counts total{};
  std::for_each(
    labels->GetBufferPointer(), labels->GetBufferPointer() + voxels, [&](int label) { total[label] += 1.0; });
  const auto sum = [](const Counts & counts, const std::set<int> & parts) {
    double all = 0.0;
    for (const int label : parts)
    {
      all += counts[label];
    }
    return all;
  };
  ObjectAgreement agreement;
  agreement.diceOfLabel.assign(wholes.size(), 0.0);
  for (int object = 1; object <= static_cast<int>(list.objects.size()); ++object)
  {
    const auto mask = MaskOfObject(list, object);
    Counts     counts{};
    double     size = 0.0;
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
    {
      if (mask->GetBufferPointer()[voxel] != 0)
      {
        counts[labels->GetBufferPointer()[voxel]] += 1.0;
        size += 1.0;
      }
    }
    double best = 0.0;
    for (std::size_t whole = 0; whole < wholes.size(); ++whole)
    {
      const double dice = 2.0 * sum(counts, wholes[whole]) / (size + sum(total, wholes[whole]));
      best = std::max(best, dice);
      agreement.diceOfLabel[whole] = std::max(agreement.diceOfLabel[whole], dice);
    }
    agreement.dice.push_back(best);
  }
  return agreement;
}
