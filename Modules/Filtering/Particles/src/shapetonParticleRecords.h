#ifndef shapetonParticleRecords_h
#define shapetonParticleRecords_h

#include "shapetonVolumeGradientOperator.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace shapeton
{
/** The six weights of each voxel, interleaved; see ParticleKernels::RecordLength. */
class ParticleRecords
{
public:
  /** `mask` may be null; object voxels are defined in ParticleMeasures. `poll` is called occasionally and may throw. */
  ParticleRecords(const EdgeVolume & edges, const unsigned char * mask, const std::function<void()> & poll);

  const std::uint16_t *
  GetData() const
  {
    return m_Data.get();
  }
  const std::uint16_t *
  GetRecord(std::size_t voxel) const;

  /** Initial heat (2.3) times the greatest sum of weights: max S - S, in units of 1 / 65535. */
  std::uint32_t
  GetInitialHeat(std::size_t voxel) const;

  std::uint64_t
  GetNumberOfObjectVoxels() const
  {
    return m_ObjectVoxels;
  }
  /** A checksum of all records. */
  std::uint64_t
  GetChecksum() const
  {
    return m_Checksum;
  }

private:
  struct Free
  {
    void
    operator()(std::uint16_t * data) const;
  };

  std::unique_ptr<std::uint16_t[], Free> m_Data;
  std::uint32_t                          m_GreatestSum{ 0 };
  std::uint64_t                          m_ObjectVoxels{ 0 };
  std::uint64_t                          m_Checksum{ 0 };
};
} // namespace shapeton

#endif
