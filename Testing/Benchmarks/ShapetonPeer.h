#ifndef ShapetonPeer_h
#define ShapetonPeer_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/** Straightforward implementation of the published shapeton diffusion: the printed formulas (8.5), (8.6) and (8.7), a
 * binary search with an absolute tolerance (8.3), weights computed from intensities on demand, one shapeton at a time.
 * Uses the random numbers of the library. */
class ShapetonPeer
{
public:
  struct Parameters
  {
    float         p{ 7.0F };
    float         stepInVoxels{ 1.0F };
    float         tolerance{ 0.01F };
    std::uint64_t seed{ 1 };
  };

  /** `intensities` in [0, 1], x fastest, must outlive the object. `places` along the axes, in voxels. */
  ShapetonPeer(const std::vector<float> &                intensities,
               const std::array<std::size_t, 3> &        size,
               const Parameters &                        parameters,
               const std::array<std::vector<float>, 3> & places);

  /** Runs a number of steps; each thread moves a separate part of the shapetons. */
  void
  Run(unsigned int steps, unsigned int threads);

  const std::vector<float> &
  GetPlaces(unsigned int axis) const
  {
    return m_Places[axis];
  }
  const std::vector<std::uint32_t> &
  GetVisits() const
  {
    return m_Visits;
  }

private:
  struct Direction
  {
    float x, y, z;
  };

  std::array<float, 6>
  WeightsAt(const std::array<std::size_t, 3> & index) const;
  Direction
  DrawDirection(const std::array<float, 6> & w, float first, float second) const;
  /** Returns the final voxel. */
  std::size_t
  MoveOne(std::size_t shapeton, std::uint64_t step);
  void
  RunPart(std::size_t begin, std::size_t end, unsigned int steps, bool shared);

  const std::vector<float> &        m_Intensities;
  std::array<std::size_t, 3>        m_Size;
  Parameters                        m_Parameters;
  std::array<std::vector<float>, 3> m_Places;
  std::vector<std::uint32_t>        m_Visits;
  std::uint64_t                     m_Step{ 0 };
};

#endif
