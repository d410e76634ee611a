#ifndef shapetonParticleRules_h
#define shapetonParticleRules_h

#include "ShapetonParticlesExport.h"

#include "shapetonParticleDirection.h"

namespace shapeton
{
/** Rule for steps across walls.
 * \ingroup ShapetonParticles */
enum class PathRule
{
  /** As published (3.2.1): only the end point of the step is used, so a long step may skip walls. */
  Endpoint,
  /** The step is traced through the voxels: each face transmits the shapeton with a probability equal to its edge
   * weight and reflects it otherwise. The position within the voxel is redrawn before each step, so that the walk is a
   * Markov chain on the voxels. With DirectionSampling::Uniform its transition matrix is symmetric, and for steps
   * shorter than a voxel the expected density obeys the operator of cumulative heat diffusion: see
   * EquivalentHeatTimeSteps(). */
  Traversal
};

/** Initial placement of shapetons.
 * \ingroup ShapetonParticles */
enum class ParticlePlacement
{
  /** Uniformly in the volume, or in the mask (3.2). */
  Uniform,
  /** In proportion to the initial heat (2.3), within the mask, if set; the density then samples the heat distribution.
   */
  InitialHeat
};

/** Values of the shapeton diffusion options for a particular purpose.
 * \ingroup ShapetonParticles */
enum class ShapetonPreset
{
  /** Separates objects: the walk that samples cumulative heat diffusion (traversal, uniform directions, started by
   * initial heat) with steps of two voxels. Window, p, smoothing and duration are chosen by ChooseHeatParameters(). */
  Objects,
  /** As printed in chapter 3: sectorArea, endpoint, started anywhere, 65,000 shapetons, distance 0.01, 2,500 steps,
   * p = 7, the whole range. */
  Published,
  /** Distinguishes thin from compact parts: the walk of Objects with 100 steps of one voxel, which spreads by 7 voxels
   * along each axis, so that visits show the surface area per volume of the neighborhood. Window, p, smoothing are
   * chosen. */
  Surface
};

/** The names of the tool's options: "solidAngle", "endpoint", "initialHeat" and so on. \ingroup ShapetonParticles */
///@{
ShapetonParticles_EXPORT const char *
NameOf(DirectionSampling sampling);
ShapetonParticles_EXPORT const char *
NameOf(PathRule rule);
ShapetonParticles_EXPORT const char *
NameOf(ParticlePlacement placement);
///@}
} // namespace shapeton

#endif
