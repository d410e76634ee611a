#include "shapetonSessionWalk.h"

#include "shapetonMappedImage.h"

#include <algorithm>
#include <chrono>

namespace shapeton
{
namespace
{
/** The blocks with a voxel of the mask. */
std::vector<unsigned char>
MaskOfBlocks(const StartMask * mask, const std::array<std::size_t, 3> & blocks)
{
  std::vector<unsigned char>  coarse(blocks[0] * blocks[1] * blocks[2], 0);
  const auto                  size = mask->GetBufferedRegion().GetSize();
  const unsigned char * const begin = mask->GetBufferPointer();
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        coarse[(z / 2 * blocks[1] + y / 2) * blocks[0] + x / 2] |= begin[(z * size[1] + y) * size[0] + x];
      }
    }
  }
  return coarse;
}
} // namespace

CoarseWalk::CoarseWalk(const VolumeView & volume) : m_Volume(volume), m_Intensities(Halved(volume)) {}

BlockValues
CoarseWalk::Start(const ParticleDiffusionOptions & options, const StartMask * mask) const
{
  constexpr std::chrono::milliseconds duration{ 50 };
  BlockValues                         density = m_Intensities;
  std::vector<std::uint32_t>          visits(density.values.size());
  const auto maskOfBlocks = mask ? MaskOfBlocks(mask, density.size) : std::vector<unsigned char>();
  auto       coarse = options;
  coarse.device = Device::Cpu;
  coarse.smoothing = 0.0;
  coarse.intensityWindow = WindowOf(options, m_Volume);
  ParticleDiffusion walk(
    m_Intensities.View(m_Volume.spacing), coarse, mask ? maskOfBlocks.data() : nullptr, visits.data(), [] {
      Interruption::Check();
    });
  const auto end = std::chrono::steady_clock::now() + duration;
  do
  {
    walk.Run(walk.GetMeasures().step + 1);
  } while (std::chrono::steady_clock::now() < end);
  const float greatest = static_cast<float>(walk.GetMeasures().maximumVisits);
  std::transform(visits.begin(), visits.end(), density.values.begin(), [greatest](std::uint32_t count) {
    return static_cast<float>(count) / greatest;
  });
  return density;
}

SessionWalk::SessionWalk(const ImageType * image) : m_Image(image) {}

void
SessionWalk::Place(const ParticleDiffusionOptions & options, const StartMask * mask, const std::function<void()> & poll)
{
  m_Options = options;
  m_Mask = mask;
  m_Parked.reset();
  this->Build(poll);
  m_Measures = m_Diffusion->GetMeasures();
}

void
SessionWalk::Build(const std::function<void()> & poll)
{
  m_Diffusion.reset(); // before the memory of the next one is used
  if (!m_Visits)
  {
    m_Visits = NewImageOn<VisitsType>(m_Image);
  }
  m_Diffusion = std::make_unique<ParticleDiffusion>(VolumeView(m_Image.GetPointer()),
                                                    m_Options,
                                                    m_Mask ? m_Mask->GetBufferPointer() : nullptr,
                                                    m_Visits->GetBufferPointer(),
                                                    poll);
}

void
SessionWalk::Advance(std::uint64_t steps)
{
  m_Diffusion->Run(m_Diffusion->GetMeasures().step + steps);
  m_Measures = m_Diffusion->GetMeasures();
}

void
SessionWalk::Park()
{
  if (m_Diffusion)
  {
    m_Parked = m_Diffusion->GetState();
    m_Diffusion.reset();
    m_Visits = nullptr;
  }
}

void
SessionWalk::Resume(const std::function<void()> & poll)
{
  if (m_Parked)
  {
    this->Build(poll);
    m_Diffusion->SetState(*m_Parked);
    m_Parked.reset();
  }
}
} // namespace shapeton
