#ifndef shapetonShapetonState_h
#define shapetonShapetonState_h

#include "ShapeDiffusionExport.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** A run of ShapetonDiffusion at the end of a step.
 * \ingroup ShapeDiffusion */
struct ShapetonState
{
  /** What the run is of: name and value of each setting, and a hash of the volume's weights. */
  std::vector<std::pair<std::string, std::string>> identity;
  std::uint64_t                                    step{ 0 };
  double                                           change{ 0.0 }; ///< of that step; see ShapetonMeasures
  /** The last 50 steps, newest in the lowest bit, that satisfied the steady rule, and how many were tested. */
  std::uint64_t                     steadyHistory{ 0 };
  std::uint64_t                     testedSteps{ 0 };
  std::array<std::vector<float>, 3> places;
  std::vector<std::uint32_t>        visits;
};

/** Writes a state: lines of text, an empty line, the arrays in little-endian binary, a checksum of all that.
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT void
WriteShapetonState(const ShapetonState & state, std::ostream & stream);

/** Reads what WriteShapetonState() wrote. Throws std::runtime_error for anything else: other content, an unknown
 * version, a truncated or damaged file.
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT ShapetonState
ReadShapetonState(std::istream & stream);
} // namespace shapeton

#endif
