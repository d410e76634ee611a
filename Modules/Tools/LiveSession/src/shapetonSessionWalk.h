#ifndef shapetonSessionWalk_h
#define shapetonSessionWalk_h

#include "shapetonCoarseHeat.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonStartRegion.h"

#include <functional>
#include <memory>
#include <optional>

namespace shapeton
{
/** \class SessionWalk
 * \brief The walk of a session: the same steps as a run of ParticleDiffusionImageFilter with the same options. */
class SessionWalk
{
public:
  using ImageType = itk::Image<float, 3>;
  using VisitsType = itk::Image<std::uint32_t, 3>;

  /** The image must outlive the walk. */
  explicit SessionWalk(const ImageType * image);

  /** Places the shapetons at step 0. The options require an intensityWindow, unless the volume is constant. `poll` may
   * throw; the walk is then not placed. */
  void
  Place(const ParticleDiffusionOptions & options, const StartMask * mask, const std::function<void()> & poll);

  bool
  IsPlaced() const
  {
    return m_Diffusion != nullptr || m_Parked.has_value();
  }

  /** Takes this number of steps. Throws InputError. */
  void
  Advance(std::uint64_t steps);

  /** Park() releases the memory of the weights and the visits, Resume() restores them. */
  void
  Park();
  void
  Resume(const std::function<void()> & poll);
  const ParticleMeasures &
  GetMeasures() const
  {
    return m_Measures;
  }

  /** Visits of each voxel; not available while the walk is parked. */
  const VisitsType *
  GetVisits() const
  {
    return m_Visits;
  }

private:
  void
  Build(const std::function<void()> & poll);

  ImageType::ConstPointer            m_Image;
  ParticleDiffusionOptions           m_Options;
  StartMask::ConstPointer            m_Mask;
  VisitsType::Pointer                m_Visits;
  std::unique_ptr<ParticleDiffusion> m_Diffusion;
  std::optional<ParticleState>       m_Parked;
  ParticleMeasures                   m_Measures;
};

/** \class CoarseWalk
 * \brief A first picture of a walk on blocks of 2^3 voxels, in less than a fifth of the time needed to place shapetons
 * in the volume. */
class CoarseWalk
{
public:
  explicit CoarseWalk(const VolumeView & volume);

  /** The density of the walk after a few hundredths of a second. */
  BlockValues
  Start(const ParticleDiffusionOptions & options, const StartMask * mask) const;

private:
  VolumeView  m_Volume;
  BlockValues m_Intensities;
};
} // namespace shapeton

#endif
