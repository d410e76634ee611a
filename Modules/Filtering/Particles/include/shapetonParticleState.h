#ifndef shapetonParticleState_h
#define shapetonParticleState_h

#include "ShapetonParticlesExport.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** State of a run of ParticleDiffusion at the end of a step.
 * \ingroup ShapetonParticles */
struct ParticleState
{
  /** Identity of the run: name and value of each setting, and a hash of the volume's weights. */
  std::vector<std::pair<std::string, std::string>> identity;
  std::uint64_t                                    step{ 0 };
  double                                           change{ 0.0 }; ///< change in that step; see ParticleMeasures
  /** One bit for each of the last 50 steps, the newest in the lowest bit: 1 if the step satisfied the steady rule. Then
   * the number of tested steps. */
  std::uint64_t                     steadyHistory{ 0 };
  std::uint64_t                     testedSteps{ 0 };
  std::array<std::vector<float>, 3> places;
  std::vector<std::uint32_t>        visits;
};

/** Writes a state: lines of text, an empty line, the arrays in little-endian binary, and a checksum.
 * \ingroup ShapetonParticles */
ShapetonParticles_EXPORT void
WriteParticleState(const ParticleState & state, std::ostream & stream);

/** Reads a file written by WriteParticleState(). Throws std::runtime_error for other content, an unknown version, or a
 * truncated or damaged file.
 * \ingroup ShapetonParticles */
ShapetonParticles_EXPORT ParticleState
ReadParticleState(std::istream & stream);
} // namespace shapeton

#endif
