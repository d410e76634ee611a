#ifndef shapetonParticleExactWalk_h
#define shapetonParticleExactWalk_h

#include "shapetonDiffusionTestVolumes.h"
#include "shapetonParticleDirection.h"
#include "shapetonPrintedEquations.h"

#include <algorithm>
#include <array>
#include <vector>

namespace shapeton
{
namespace test
{
/** The steps of PathRule::Traversal in double precision, with all outcomes and probabilities instead of random
 * numbers. Independent of the code under test. */
class ExactWalk
{
public:
  /** Probability that a step ends in a voxel. */
  using Density = std::vector<double>;

  ExactWalk(const Volume & volume, double p)
    : m_Size(volume.size), m_Strides{ 1, m_Size[0], m_Size[0] * m_Size[1] }, m_Weights(volume.values.size())
  {
    const double range = volume.Window()[1] - volume.Window()[0];
    for (std::size_t voxel = 0; voxel < m_Weights.size(); ++voxel)
    {
      for (unsigned int edge = 0; edge < 6; ++edge)
      {
        const double contrast =
          this->IsInside(voxel, edge) ? volume.values[voxel] - volume.values[this->Neighbor(voxel, edge)] : 0.0;
        m_Weights[voxel][edge] = std::clamp(1.0 - p * std::abs(contrast) / range, 0.0, 1.0);
      }
    }
  }

  /** Weights for the sampling of directions: 1 at the border of the volume. */
  const EdgeWeights &
  GetWeights(std::size_t voxel) const
  {
    return m_Weights[voxel];
  }

  /** The probability of passing a face: 0 at the border of the volume. */
  double
  GetPassage(std::size_t voxel, unsigned int edge) const
  {
    return this->IsInside(voxel, edge) ? m_Weights[voxel][edge] : 0.0;
  }

  std::size_t
  Neighbor(std::size_t voxel, unsigned int edge) const
  {
    return edge % 2 ? voxel + m_Strides[edge / 2] : voxel - m_Strides[edge / 2];
  }

  /** Follows a displacement, in voxels, from a position in a voxel, and adds `probability` to its end voxel. At each
   * face both outcomes are followed. */
  void
  Follow(std::size_t voxel, std::array<double, 3> place, std::array<double, 3> way, double probability, Density & ends)
    const
  {
    double       share = 1.0;
    unsigned int face = 3;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const double distance = way[axis] > 0.0 ? 1.0 - place[axis] : place[axis];
      if (distance < std::abs(way[axis]) * share)
      {
        share = distance / std::abs(way[axis]);
        face = axis;
      }
    }
    if (face == 3)
    {
      ends[voxel] += probability;
      return;
    }
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      place[axis] = std::clamp(place[axis] + share * way[axis], 0.0, 1.0);
      way[axis] *= 1.0 - share;
    }
    const bool         forwards = way[face] > 0.0;
    const unsigned int edge = 2 * face + (forwards ? 1 : 0);
    const double       passage = this->GetPassage(voxel, edge);
    if (passage > 0.0)
    {
      place[face] = forwards ? 0.0 : 1.0;
      this->Follow(this->Neighbor(voxel, edge), place, way, probability * passage, ends);
    }
    if (passage < 1.0)
    {
      place[face] = forwards ? 1.0 : 0.0;
      way[face] = -way[face];
      this->Follow(voxel, place, way, probability * (1.0 - passage), ends);
    }
  }

private:
  bool
  IsInside(std::size_t voxel, unsigned int edge) const
  {
    const std::size_t index = voxel / m_Strides[edge / 2] % m_Size[edge / 2];
    return edge % 2 ? index + 1 < m_Size[edge / 2] : index > 0;
  }

  Size                       m_Size;
  std::array<std::size_t, 3> m_Strides;
  std::vector<EdgeWeights>   m_Weights;
};

/** The transition matrix of steps no longer than a voxel, exactly.
 *
 * Such a step meets the face of each axis at most once, at a uniformly distributed time, because the position in the
 * voxel is uniform, and independently of the other faces. So the probability of meeting exactly the faces of a set of
 * axes in a given order is
 *
 *   product of |way| over the set * product of 1 - |way| over the others / factorial of the size of the set,
 *
 * and its mean over the directions, a polynomial in their components, is computed by quadrature. */
template <int Points>
class TransitionMatrix
{
public:
  TransitionMatrix(const ExactWalk & walk, std::size_t voxels, DirectionSampling sampling, double step)
    : m_Walk(walk), m_Rows(voxels)
  {
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
    {
      double whole = 0.0;
      for (unsigned int octant = 0; octant < 8; ++octant)
      {
        const Means means = this->MeansOf(walk.GetWeights(voxel), octant, sampling, step);
        whole += means[0];
        for (unsigned int axes = 0; axes < 8; ++axes)
        {
          this->Meet(voxel, octant, axes, this->ExactlyThese(means, axes), voxel);
        }
      }
      for (auto & [end, probability] : m_Rows[voxel])
      {
        probability = whole > 0.0 ? probability / whole : 0.0;
      }
    }
  }

  /** The probability of a step from one voxel to another. */
  double
  Get(std::size_t from, std::size_t to) const
  {
    double sum = 0.0;
    for (const auto & [end, probability] : m_Rows[from])
    {
      sum += end == to ? probability : 0.0;
    }
    return sum;
  }

  const std::vector<std::pair<std::size_t, double>> &
  GetRow(std::size_t voxel) const
  {
    return m_Rows[voxel];
  }

  /** A density after one more step. */
  std::vector<double>
  Apply(const std::vector<double> & density) const
  {
    std::vector<double> next(density.size(), 0.0);
    for (std::size_t voxel = 0; voxel < density.size(); ++voxel)
    {
      for (const auto & [end, probability] : m_Rows[voxel])
      {
        next[end] += density[voxel] * probability;
      }
    }
    return next;
  }

private:
  /** The integral over an octant of the density of directions times the product of |way| over a set of axes, for each
   * of the eight sets. */
  using Means = std::array<double, 8>;

  Means
  MeansOf(const EdgeWeights & weights, unsigned int octant, DirectionSampling sampling, double step) const
  {
    const bool   even = sampling == DirectionSampling::Uniform;
    const double w1 = even ? 1.0 : weights[octant & 1];
    const double w2 = even ? 1.0 : weights[2 + (octant >> 1 & 1)];
    const double w3 = even ? 1.0 : weights[4 + (octant >> 2)];
    Means        means{};
    m_Rule.ForNodes(0.0, halfPi, [&](double phi, double phiWeight) {
      const double across = w2 + (w3 - w2) * phi / halfPi;
      Means        ofPhi{};
      double       volume = 0.0;
      m_Rule.ForNodes(0.0, halfPi, [&](double theta, double thetaWeight) {
        const double radius = w1 + (across - w1) * theta / halfPi;
        const double ofVolume = thetaWeight * radius * radius * radius * std::sin(theta);
        const double density = sampling == DirectionSampling::SectorArea ? thetaWeight * radius * radius : ofVolume;
        const double way[3] = { step * std::cos(theta),
                                step * std::sin(theta) * std::cos(phi),
                                step * std::sin(theta) * std::sin(phi) };
        volume += ofVolume;
        for (unsigned int axes = 0; axes < 8; ++axes)
        {
          ofPhi[axes] += density * (axes & 1 ? way[0] : 1.0) * (axes & 2 ? way[1] : 1.0) * (axes & 4 ? way[2] : 1.0);
        }
      });
      for (unsigned int axes = 0; axes < 8; ++axes)
      {
        means[axes] += ofPhi[0] > 0.0 ? phiWeight * volume * ofPhi[axes] / ofPhi[0] : 0.0;
      }
    });
    return means;
  }

  /** The mean of the product of |way| over a set of axes and of 1 - |way| over the others, divided by the number of
   * orders. */
  static double
  ExactlyThese(const Means & means, unsigned int axes)
  {
    double sum = 0.0;
    for (unsigned int more = 0; more < 8; ++more)
    {
      if ((more & axes) == 0)
      {
        sum += (__builtin_popcount(more) % 2 ? -1.0 : 1.0) * means[axes | more];
      }
    }
    const int number = __builtin_popcount(axes);
    return sum / (number == 3 ? 6.0 : number == 2 ? 2.0 : 1.0);
  }

  /** Crosses the faces of the remaining axes in every order, and adds the end voxel of the step to the row of `start`.
   */
  void
  Meet(std::size_t start, unsigned int octant, unsigned int axes, double probability, std::size_t voxel)
  {
    if (axes == 0 && probability != 0.0)
    {
      this->Add(start, voxel, probability);
    }
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      if (axes >> axis & 1)
      {
        const unsigned int edge = 2 * axis + (octant >> axis & 1);
        const unsigned int rest = axes & ~(1U << axis);
        const double       passage = m_Walk.GetPassage(voxel, edge);
        if (passage > 0.0)
        {
          this->Meet(start, octant, rest, probability * passage, m_Walk.Neighbor(voxel, edge));
        }
        this->Meet(start, octant, rest, probability * (1.0 - passage), voxel);
      }
    }
  }

  void
  Add(std::size_t start, std::size_t end, double probability)
  {
    auto &     row = m_Rows[start];
    const auto found = std::find_if(row.begin(), row.end(), [end](const auto & entry) { return entry.first == end; });
    if (found != row.end())
    {
      found->second += probability;
    }
    else
    {
      row.emplace_back(end, probability);
    }
  }

  GaussRule<Points>                                        m_Rule;
  const ExactWalk &                                        m_Walk;
  std::vector<std::vector<std::pair<std::size_t, double>>> m_Rows;
};
} // namespace test
} // namespace shapeton

#endif
