#include "RandomScenes.h"

#include "SampledScenes.h"
#include "VoxelMorphology.h"

#include "shapetonParallelFor.h"
#include "shapetonSmoothVoxels.h"
#include "shapetonSquaredDistances.h"
#include "shapetonTestImages.h"

#include "itkMatrix.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace shapeton;

namespace
{
constexpr int           side = 96;                     // voxels
constexpr std::uint32_t purposeOfScenes = 0x4f626a73U; // of the random numbers
const VoxelGrid         grid(side, side, side);

using Field = std::vector<float>;
using Vector = itk::Vector<double, 3>;
using Rotation = itk::Matrix<double, 3, 3>;
/** Whether a voxel is inside, given its position relative to the axes of the shape, in voxels. */
using Inside = std::function<bool(const Vector & at, std::size_t voxel)>;

void
Smooth(double sigma, Field & field)
{
  SmoothVoxels(grid, { { sigma, sigma, sigma } }, field.data());
}

/** Random field of mean 0 and standard deviation 1; white for sigma 0. */
Field
Texture(SceneDice & dice, double sigma)
{
  Field field(grid.NumberOfVoxels());
  std::generate(field.begin(), field.end(), [&] { return static_cast<float>(dice.Normal()); });
  Smooth(sigma, field);
  const double squares = std::inner_product(field.begin(), field.end(), field.begin(), 0.0);
  const auto   factor = static_cast<float>(1.0 / std::sqrt(squares / static_cast<double>(field.size())));
  std::transform(field.begin(), field.end(), field.begin(), [=](float value) { return factor * value; });
  return field;
}

Vector
Direction(SceneDice & dice)
{
  Vector direction;
  std::generate(direction.Begin(), direction.End(), [&] { return dice.Normal(); });
  return direction / direction.GetNorm();
}

Vector
Place(SceneDice & dice, double low, double high)
{
  Vector place;
  std::generate(place.Begin(), place.End(), [&] { return dice.Between(low, high); });
  return place;
}

Rotation
RandomRotation(SceneDice & dice)
{
  const Vector x = Direction(dice);
  Vector       y = itk::CrossProduct(x, Direction(dice));
  y /= y.GetNorm();
  const Vector z = itk::CrossProduct(x, y);
  Rotation     rotation;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    rotation(0, axis) = x[axis];
    rotation(1, axis) = y[axis];
    rotation(2, axis) = z[axis];
  }
  return rotation;
}

VoxelMask
Fill(const Vector & center, const Rotation & rotation, const Inside & isInside)
{
  VoxelMask mask(grid.NumberOfVoxels());
  ParallelForBlocks(mask.size(), [&](std::size_t voxel) {
    const auto place = grid.Voxel(voxel);
    Vector     offset;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      offset[axis] = place[axis] - center[axis];
    }
    mask[voxel] = isInside(rotation * offset, voxel) ? 1 : 0;
  });
  return mask;
}

/** Position in units of the radii. */
Vector
InRadii(const Vector & at, const std::array<double, 3> & radii)
{
  Vector scaled;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    scaled[axis] = at[axis] / radii[axis];
  }
  return scaled;
}

Inside
Solid(SceneDice & dice, double size)
{
  const auto                  part = [&](double low, double high) { return size * dice.Between(low, high); };
  const int                   kind = dice.Count(0, 6);
  const std::array<double, 3> radii{ { part(0.5, 1.0), part(0.6, 1.2), size } };
  switch (kind)
  {
    case 0: // ball
      return [=](const Vector & at, std::size_t) { return at.GetNorm() < size; };
    case 1: // box
      return [=](const Vector & at, std::size_t) {
        const Vector scaled = InRadii(at, radii);
        return std::max({ std::abs(scaled[0]), std::abs(scaled[1]), std::abs(scaled[2]) }) < 1.0;
      };
    case 2: // cylinder
      return [=](const Vector & at, std::size_t) {
        return std::hypot(at[0], at[1]) < 0.7 * radii[0] && std::abs(at[2]) < 1.3 * size;
      };
    case 3: // ring
      return [=](const Vector & at, std::size_t) {
        return std::hypot(std::hypot(at[0], at[1]) - size, at[2]) < 0.5 * radii[0];
      };
    case 4: // blob: an ellipsoid with a deformed border
      return [=, texture = Texture(dice, size / 3.0)](const Vector & at, std::size_t voxel) {
        return InRadii(at, radii).GetSquaredNorm() < 1.0 + 0.35 * texture[voxel];
      };
    default: // ellipsoid
      return [=](const Vector & at, std::size_t) { return InRadii(at, radii).GetSquaredNorm() < 1.0; };
  }
}

/** The voxels near a random curve. */
VoxelMask
Tube(SceneDice & dice, double radius)
{
  constexpr double step = 1.25; // voxels
  VoxelMask        outside(grid.NumberOfVoxels(), 1);
  Vector           place = Place(dice, -5.0, side + 5.0);
  Vector           direction = Direction(dice);
  for (int steps = dice.Count(32, 120); steps > 0; --steps)
  {
    const auto nearest = [&](unsigned int axis) { return static_cast<int>(std::lround(place[axis])); };
    if (grid.Holds(nearest(0), nearest(1), nearest(2)))
    {
      outside[grid.Index(nearest(0), nearest(1), nearest(2))] = 0;
    }
    direction += 0.2 * Direction(dice);
    direction /= direction.GetNorm();
    place += step * direction;
  }
  const auto squares = SquaredDistances(grid, { { 1.0, 1.0, 1.0 } }, outside, radius + 1.0);
  VoxelMask  tube(outside.size());
  std::transform(squares.begin(), squares.end(), tube.begin(), [&](float s) { return s < radius * radius ? 1 : 0; });
  return tube;
}

/** Removes the voxels of the mask for which a condition does not hold. */
template <typename TCondition>
void
Keep(VoxelMask & mask, const TCondition & condition)
{
  for (std::size_t voxel = 0; voxel < mask.size(); ++voxel)
  {
    mask[voxel] = mask[voxel] != 0 && condition(voxel) ? 1 : 0;
  }
}

std::size_t
Count(const VoxelMask & mask)
{
  return std::count(mask.begin(), mask.end(), 1);
}

class SceneMaker
{
public:
  explicit SceneMaker(unsigned int seed)
    : m_IsOfBytes(seed % 2 == 1)
    , m_Dice(seed, purposeOfScenes)
    , m_Background(m_Dice.Between(0.0, 60.0))
    , m_Values(grid.NumberOfVoxels(), static_cast<float>(m_Background))
    , m_Labels(grid.NumberOfVoxels(), 0)
  {}

  SceneVolume
  Make()
  {
    if (m_Dice.IsTrue(0.55))
    {
      this->AddBody();
    }
    const double usual = this->Intensity();
    for (int object = m_Dice.Count(3, 10); object > 0; --object)
    {
      this->AddObject(usual);
    }
    if (m_Dice.IsTrue(0.3))
    {
      this->AddThin(Tube(m_Dice, m_Dice.Between(2.5, 7.0)));
    }
    if (m_Dice.IsTrue(0.15))
    {
      const double thickness = m_Dice.Between(1.5, 4.0);
      const Vector center = Place(m_Dice, 20.0, 76.0);
      this->AddThin(Fill(center, RandomRotation(m_Dice), [=](const Vector & at, std::size_t) {
        return std::abs(at[0]) < thickness && std::max(std::abs(at[1]), std::abs(at[2])) < 40.0;
      }));
    }
    this->Scan();
    return this->Images();
  }

private:
  /** An intensity that differs from the background, mostly a brighter one. */
  double
  Intensity()
  {
    const double step = m_Dice.Between(60.0, 200.0);
    return m_Background + (m_Dice.IsTrue(0.85) ? step : -0.3 * step);
  }

  /** Sets intensity and the next label; does nothing for a few voxels. */
  bool
  Put(const VoxelMask & mask, double intensity)
  {
    constexpr std::size_t least = 300;
    if (Count(mask) < least)
    {
      return false;
    }
    ++m_Number;
    this->Change(mask, [&](std::size_t voxel) {
      m_Values[voxel] = static_cast<float>(intensity);
      m_Labels[voxel] = static_cast<unsigned char>(m_Number);
    });
    return true;
  }

  template <typename TBody>
  void
  Change(const VoxelMask & mask, const TBody & body)
  {
    for (std::size_t voxel = 0; voxel < mask.size(); ++voxel)
    {
      if (mask[voxel] != 0)
      {
        body(voxel);
      }
    }
  }

  /** An elliptic body around the middle; half of them are cut by the border at both ends. */
  void
  AddBody()
  {
    const Vector                center = Place(m_Dice, 42.0, 54.0);
    const double                length = m_Dice.IsTrue(0.5) ? m_Dice.Between(38.0, 80.0) : 200.0;
    const std::array<double, 3> radii{ { length, m_Dice.Between(36.0, 46.0), m_Dice.Between(36.0, 46.0) } };
    Rotation                    rotation;
    rotation.SetIdentity();
    m_Body =
      Fill(center, rotation, [&](const Vector & at, std::size_t) { return InRadii(at, radii).GetSquaredNorm() < 1.0; });
    m_Around = m_Background + m_Dice.Between(60.0, 120.0);
    this->Put(m_Body, m_Around);
  }

  /** Whether the voxel belongs to the background or the body. */
  bool
  IsFree(std::size_t voxel) const
  {
    return m_Labels[voxel] <= (m_Body.empty() ? 0 : 1);
  }

  /** An object of random kind; it may be omitted if others take its place. */
  void
  AddObject(double usual)
  {
    const double    size = m_Dice.Between(6.0, 30.0);
    const Vector    center = m_Dice.IsTrue(0.6) ? Place(m_Dice, 2.0, 94.0) : Place(m_Dice, 20.0, 76.0);
    const Inside    isInside = Solid(m_Dice, size);
    VoxelMask       mask = Fill(center, RandomRotation(m_Dice), isInside);
    double          intensity = m_Dice.IsTrue(0.4) ? usual : this->Intensity();
    const VoxelMask within = m_Body.empty() ? VoxelMask() : Eroded(m_Body, grid, m_Dice.Count(1, 3));
    if (!m_Body.empty())
    {
      Keep(mask, [&](std::size_t voxel) { return within[voxel] != 0; });
      const double step = m_Dice.Between(12.0, 60.0);
      const double similar = m_Dice.IsTrue(0.5) ? m_Around + step : m_Around - step;
      intensity = m_Dice.IsTrue(0.7) ? similar : intensity;
    }
    const auto voxels = Count(mask);
    VoxelMask  free = mask;
    Keep(free, [&](std::size_t voxel) { return this->IsFree(voxel); });
    if (10 * Count(free) >= 7 * voxels || m_Dice.IsTrue(0.2)) // at least 70 % of it are free
    {
      const bool isOver = m_Body.empty() && m_Dice.IsTrue(0.2);
      this->AddParts(isOver ? mask : free, intensity);
    }
  }

  /** The object with its texture, cortex, and shell or core. */
  void
  AddParts(const VoxelMask & mask, double intensity)
  {
    if (!this->Put(mask, intensity))
    {
      return;
    }
    const double contrast = std::abs(intensity - (m_Body.empty() ? m_Background : m_Around));
    if (m_Dice.IsTrue(0.65))
    {
      const double amplitude = contrast * m_Dice.Between(0.02, 0.25);
      const Field  texture = Texture(m_Dice, m_Dice.Between(1.2, 5.0));
      this->Change(mask, [&](std::size_t voxel) { m_Values[voxel] += static_cast<float>(amplitude * texture[voxel]); });
    }
    if (m_Dice.IsTrue(0.35))
    {
      const double step = contrast * m_Dice.Between(0.15, 0.8);
      this->Change(Layer(mask, m_Dice.Count(1, 3)),
                   [&](std::size_t voxel) { m_Values[voxel] += static_cast<float>(step); });
    }
    const double kind = m_Dice.Between(0.0, 1.0);
    const int    depth = m_Dice.Count(2, 6);
    const double other = this->Intensity();
    if (kind < 0.08) // a shell
    {
      this->Put(Layer(mask, depth), other);
    }
    else if (kind < 0.22) // a core
    {
      this->Put(Eroded(mask, grid, depth), other);
    }
  }

  /** The outermost voxels of a mask. */
  static VoxelMask
  Layer(VoxelMask mask, int thickness)
  {
    const VoxelMask inside = Eroded(mask, grid, thickness);
    Keep(mask, [&](std::size_t voxel) { return inside[voxel] == 0; });
    return mask;
  }

  void
  AddThin(VoxelMask mask)
  {
    Keep(mask, [&](std::size_t voxel) { return this->IsFree(voxel); });
    this->Put(mask, this->Intensity());
  }

  void
  AddField(double amplitude, const Field & field)
  {
    for (std::size_t voxel = 0; voxel < field.size(); ++voxel)
    {
      m_Values[voxel] += static_cast<float>(amplitude * field[voxel]);
    }
  }

  double
  Range() const
  {
    const auto extremes = std::minmax_element(m_Values.begin(), m_Values.end());
    return *extremes.second - *extremes.first;
  }

  /** Texture of everything, bias field, blur, noise, and the intensities of the scanner. */
  void
  Scan()
  {
    constexpr std::array<double, 4> blurs = { { 0.4, 0.7, 1.0, 1.4 } };            // voxels
    constexpr std::array<double, 5> noises = { { 0.0, 0.005, 0.01, 0.02, 0.05 } }; // of the range
    const double                    range = this->Range();
    if (m_Dice.IsTrue(0.6))
    {
      const double amplitude = range * m_Dice.Between(0.0, 0.02);
      this->AddField(amplitude, Texture(m_Dice, m_Dice.Between(1.0, 5.0)));
    }
    if (m_Dice.IsTrue(0.3))
    {
      const double amplitude = m_Dice.Between(0.0, 0.1);
      const Field  bias = Texture(m_Dice, 30.0);
      for (std::size_t voxel = 0; voxel < bias.size(); ++voxel)
      {
        m_Values[voxel] *= static_cast<float>(1.0 + amplitude * std::clamp(bias[voxel], -2.0F, 2.0F));
      }
    }
    Smooth(blurs[m_Dice.Count(0, 3)], m_Values);
    const double noise = range * noises[m_Dice.Count(0, 4)];
    this->AddField(noise, Texture(m_Dice, m_Dice.IsTrue(0.4) ? 0.7 : 0.0));
    m_IsOfBytes ? this->ToBytes() : this->ToHounsfieldUnits();
  }

  void
  ToBytes()
  {
    const float  least = *std::min_element(m_Values.begin(), m_Values.end());
    const double factor = m_Dice.Between(120.0, 255.0) / this->Range();
    const double removed = m_Dice.IsTrue(0.5) ? m_Dice.Between(5.0, 40.0) : 0.0;
    for (float & value : m_Values)
    {
      const double byte = std::round(factor * (value - least));
      value = byte < removed ? 0.0F : static_cast<float>(byte);
    }
  }

  void
  ToHounsfieldUnits()
  {
    std::transform(m_Values.begin(), m_Values.end(), m_Values.begin(), [](float value) {
      return std::round(10.0F * value - 500.0F);
    });
  }

  SceneVolume
  Images() const
  {
    const auto        size = itk::Size<3>::Filled(side);
    const SceneVolume volume{ basetest::NewImage<itk::Image<float, 3>>(size),
                              basetest::NewImage<itk::Image<unsigned char, 3>>(size) };
    std::copy(m_Values.begin(), m_Values.end(), volume.image->GetBufferPointer());
    std::copy(m_Labels.begin(), m_Labels.end(), volume.labels->GetBufferPointer());
    return volume;
  }

  bool      m_IsOfBytes;
  SceneDice m_Dice;
  double    m_Background;
  double    m_Around{ 0.0 }; ///< intensity of the body
  VoxelMask m_Body;          ///< empty without body
  Field     m_Values;
  VoxelMask m_Labels;
  int       m_Number{ 0 }; ///< of labels
};
} // namespace

SceneVolume
RandomScene(unsigned int seed)
{
  return SceneMaker(seed).Make();
}
