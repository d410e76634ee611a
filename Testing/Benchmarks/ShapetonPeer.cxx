#include "ShapetonPeer.h"

#include "shapetonPhilox.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace
{
constexpr float p1 = 3.14159265358979F, p2 = p1 * p1, p3 = p2 * p1, p4 = p2 * p2, p5 = p4 * p1, p6 = p3 * p3;

/** (8.6) as printed. */
float
VolumeOfOctant(float w1, float w2, float w3)
{
  return 1.0F / 12.0F *
         (2 * w1 * w1 * w1 * p3 - 16 * w1 * p1 * w2 * w2 + 48 * w1 * w1 * p1 * w2 - 16 * w1 * p1 * w3 * w3 -
          48 * w1 * w1 * w1 * p1 - 16 * w1 * p1 * w2 * w3 + 48 * w1 * w1 * p1 * w3 - 24 * w2 * w3 * w3 -
          4 * w1 * p2 * w2 * w2 + 3 * w2 * w2 * w3 * p2 + 96 * w1 * w1 * w1 + 96 * w1 * w2 * w2 +
          3 * w3 * w3 * w3 * p2 - 144 * w1 * w1 * w2 - 24 * w3 * w3 * w3 + 3 * w2 * w2 * w2 * p2 +
          3 * w2 * w3 * w3 * p2 - 144 * w3 * w1 * w1 - 24 * w2 * w2 * w3 + 96 * w1 * w3 * w3 - 4 * w3 * w1 * p2 * w2 -
          24 * w2 * w2 * w2 + 96 * w1 * w2 * w3 - 4 * w3 * w3 * w1 * p2) /
         p2;
}

/** c[0] angle + c[1] angle^2 + ... */
struct Polynomial
{
  float
  operator()(float angle) const
  {
    return (((c[3] * angle + c[2]) * angle + c[1]) * angle + c[0]) * angle;
  }
  float c[4];
};

/** (8.5) as printed; a search computes its coefficients once. */
Polynomial
PartialVolume(float w1, float w2, float w3)
{
  Polynomial v{};
  v.c[3] = -(1.0F / 12.0F) *
           (384 * w3 * w3 * w3 + 1152 * w2 * w2 * w3 - 144 * w2 * w2 * p2 * w3 + 144 * w2 * p2 * w3 * w3 +
            48 * w2 * w2 * w2 * p2 - 48 * w3 * w3 * w3 * p2 - 1152 * w2 * w3 * w3 - 384 * w2 * w2 * w2) /
           p6;
  v.c[2] = -(1.0F / 9.0F) *
           (576 * w2 * p1 * w3 * w3 - 192 * w1 * p2 * w2 * w3 + 144 * w2 * w2 * p3 * w3 - 576 * w1 * p1 * w3 * w3 -
            48 * w1 * p3 * w2 * w3 - 72 * w2 * w2 * w2 * p3 + 24 * w1 * p3 * w3 * w3 + 96 * w1 * p2 * w2 * w2 -
            1152 * w2 * w2 * p1 * w3 - 576 * w1 * p1 * w2 * w2 + 24 * w1 * p3 * w2 * w2 + 576 * w2 * w2 * w2 * p1 -
            72 * w2 * p3 * w3 * w3 + 96 * w1 * p2 * w3 * w3 + 1152 * w1 * p1 * w2 * w3) /
           p6;
  v.c[1] = -(1.0F / 6.0F) *
           (96 * w1 * p3 * w2 * w3 - 96 * w1 * p3 * w2 * w2 + 24 * w1 * p4 * w2 * w3 + 96 * w1 * w1 * p3 * w2 -
            576 * w1 * p2 * w2 * w3 + 36 * w2 * w2 * w2 * p4 - 288 * w1 * w1 * p2 * w2 - 36 * w2 * w2 * p4 * w3 -
            24 * w1 * p4 * w2 * w2 - 288 * w2 * w2 * w2 * p2 - 96 * w1 * w1 * p3 * w3 + 288 * w2 * w2 * p2 * w3 +
            576 * w1 * p2 * w2 * w2 + 288 * w1 * w1 * p2 * w3) /
           p6;
  v.c[0] = -(1.0F / 3.0F) *
           (144 * w1 * w1 * p3 * w2 + 48 * w2 * w2 * w2 * p3 + 24 * w1 * w1 * w1 * p4 - 48 * w1 * w1 * w1 * p3 -
            w1 * w1 * w1 * p6 - 48 * w1 * w1 * p4 * w2 - 6 * w2 * w2 * w2 * p5 + 6 * w1 * p5 * w2 * w2 +
            24 * w1 * p4 * w2 * w2 - 144 * w1 * p3 * w2 * w2) /
           p6;
  return v;
}

/** (8.7) as printed. */
Polynomial
PartialArea(float w1, float w2)
{
  return { { 0.5F * w1 * w1, w1 * (w2 - w1) / p1, 2.0F / (3.0F * p2) * (w2 - w1) * (w2 - w1), 0.0F } };
}

/** Angle in [0, pi/2] that bounds a fraction of the area (8.8, 8.9). */
float
Search(const Polynomial & part, float wanted, float tolerance)
{
  float angle = p1 / 4.0F;
  float change = p1 / 4.0F;
  for (int iteration = 0; iteration < 24; ++iteration)
  {
    const float value = part(angle);
    if (std::fabs(wanted - value) < tolerance)
    {
      break;
    }
    change *= 0.5F;
    angle += wanted < value ? -change : change;
  }
  return angle;
}

/** Returns a random number in (0, 1]. */
float
ToUnit(std::uint32_t word)
{
  return static_cast<float>((word >> 8) + 1) * (1.0F / 16777216.0F);
}

float
Reflect(float place, float size)
{
  place = place < 0.0F ? -place : place;
  place = place > size ? 2.0F * size - place : place;
  return std::min(place, size * (1.0F - 6e-8F));
}
} // namespace

ShapetonPeer::ShapetonPeer(const std::vector<float> &                intensities,
                           const std::array<std::size_t, 3> &        size,
                           const Parameters &                        parameters,
                           const std::array<std::vector<float>, 3> & places)
  : m_Intensities(intensities), m_Size(size), m_Parameters(parameters), m_Places(places), m_Visits(intensities.size())
{}

std::array<float, 6>
ShapetonPeer::WeightsAt(const std::array<std::size_t, 3> & index) const
{
  const std::size_t    strides[3] = { 1, m_Size[0], m_Size[0] * m_Size[1] };
  const std::size_t    voxel = index[2] * strides[2] + index[1] * strides[1] + index[0];
  const float          own = m_Intensities[voxel];
  std::array<float, 6> weights{};
  const auto weight = [&](float other) { return std::max(0.0F, 1.0F - m_Parameters.p * std::fabs(other - own)); };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    weights[2 * axis] = index[axis] > 0 ? weight(m_Intensities[voxel - strides[axis]]) : 1.0F;
    weights[2 * axis + 1] = index[axis] + 1 < m_Size[axis] ? weight(m_Intensities[voxel + strides[axis]]) : 1.0F;
  }
  return weights;
}

ShapetonPeer::Direction
ShapetonPeer::DrawDirection(const std::array<float, 6> & w, float first, float second) const
{
  float volumes[8];
  float whole = 0.0F;
  for (unsigned int octant = 0; octant < 8; ++octant)
  {
    volumes[octant] = VolumeOfOctant(w[octant & 1], w[2 + (octant >> 1 & 1)], w[4 + (octant >> 2)]);
    whole += volumes[octant];
  }
  if (!(whole > 0.0F))
  {
    return {};
  }
  const float  wanted = first * whole;
  unsigned int octant = 0;
  float        below = volumes[0];
  while (octant < 7 && wanted > below)
  {
    below += volumes[++octant];
  }
  const float w1 = w[octant & 1];
  const float w2 = w[2 + (octant >> 1 & 1)];
  const float w3 = w[4 + (octant >> 2)];
  const float phi = Search(PartialVolume(w1, w2, w3), below - wanted, m_Parameters.tolerance);
  const float across = (w2 * (p1 / 2 - phi) + w3 * phi) / (p1 / 2);
  const float area = p1 / 12.0F * (w1 * w1 + across * across + w1 * across);
  const float theta = Search(PartialArea(w1, across), area * second, m_Parameters.tolerance);
  const float sine = std::sin(theta);
  return { octant & 1 ? std::cos(theta) : -std::cos(theta),
           octant & 2 ? sine * std::cos(phi) : -sine * std::cos(phi),
           octant & 4 ? sine * std::sin(phi) : -sine * std::sin(phi) };
}

std::size_t
ShapetonPeer::MoveOne(std::size_t shapeton, std::uint64_t step)
{
  float &    x = m_Places[0][shapeton];
  float &    y = m_Places[1][shapeton];
  float &    z = m_Places[2][shapeton];
  const auto weights =
    this->WeightsAt({ static_cast<std::size_t>(x), static_cast<std::size_t>(y), static_cast<std::size_t>(z) });
  const auto      words = shapeton::Philox4x32(m_Parameters.seed,
                                          { static_cast<std::uint32_t>(shapeton),
                                                 static_cast<std::uint32_t>(step),
                                                 static_cast<std::uint32_t>(step >> 32),
                                                 0 });
  const Direction direction = this->DrawDirection(weights, ToUnit(words.a), ToUnit(words.b));
  x = Reflect(x + m_Parameters.stepInVoxels * direction.x, static_cast<float>(m_Size[0]));
  y = Reflect(y + m_Parameters.stepInVoxels * direction.y, static_cast<float>(m_Size[1]));
  z = Reflect(z + m_Parameters.stepInVoxels * direction.z, static_cast<float>(m_Size[2]));
  return (static_cast<std::size_t>(z) * m_Size[1] + static_cast<std::size_t>(y)) * m_Size[0] +
         static_cast<std::size_t>(x);
}

void
ShapetonPeer::RunPart(std::size_t begin, std::size_t end, unsigned int steps, bool shared)
{
  for (unsigned int step = 1; step <= steps; ++step)
  {
    for (std::size_t shapeton = begin; shapeton < end; ++shapeton)
    {
      const std::size_t voxel = this->MoveOne(shapeton, m_Step + step);
      if (shared)
      {
        __atomic_fetch_add(&m_Visits[voxel], 1U, __ATOMIC_RELAXED);
      }
      else
      {
        ++m_Visits[voxel];
      }
    }
  }
}

void
ShapetonPeer::Run(unsigned int steps, unsigned int threads)
{
  const std::size_t        number = m_Places[0].size();
  std::vector<std::thread> others;
  for (unsigned int thread = 1; thread < threads; ++thread)
  {
    others.emplace_back(
      &ShapetonPeer::RunPart, this, number * thread / threads, number * (thread + 1) / threads, steps, true);
  }
  this->RunPart(0, number / threads, steps, threads > 1);
  for (std::thread & other : others)
  {
    other.join();
  }
  m_Step += steps;
}
