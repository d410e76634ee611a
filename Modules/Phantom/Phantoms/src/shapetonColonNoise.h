#ifndef shapetonColonNoise_h
#define shapetonColonNoise_h

#include "shapetonPhantomRandom.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** Purposes of random numbers, each with a separate stream, so that changes to one do not affect the others. */
enum class ColonStream : std::uint32_t
{
  SegmentLengths = 1,
  Template,
  Radius,
  Taeniae,
  Folds,
  Roughness,
  Polyps,
  Displacement,
  Distension,
  Torsion,
  FoldSlide,
  FoldFlattening,
  Collapse,
  Septa,
  Valve,
  Ileum,
  CecumMove,
  Stool,
  Bubbles,
  Foam,
  Drawn,
  Diverticula,
  Reflux,
  Spasm,
  TiltedLevel,
  Contact,
  SmallLevels
};

/** Uniform and normal numbers from Philox, keyed by seed, purpose and, if relevant, the position (from 1). */
class ColonRandom
{
public:
  ColonRandom(unsigned seed, ColonStream stream, unsigned position = 0);

  /** Next number in [0, 1). */
  double
  Uniform();
  double
  Uniform(double low, double high);
  double
  Uniform(const DrawnRange & range)
  {
    return this->Uniform(range.low, range.high);
  }
  /** Normally distributed random number with mean 0 and standard deviation 1. */
  double
  Normal();
  /** The number with this index, independent of previous draws. */
  void
  Seek(std::uint32_t index);

private:
  std::uint64_t m_Key;
  std::uint32_t m_Position;
  std::uint32_t m_Index{ 0 };
  std::uint32_t m_Draw{ 0 };
};

/** A smooth random function of a length, with values in about [-1, 1]: a cubic B-spline with uniformly distributed
 * coefficients. */
class SmoothNoise
{
public:
  SmoothNoise(ColonRandom & random, double length, double knotDistance);

  double
  operator()(double x) const;

private:
  double              m_KnotDistance;
  std::vector<double> m_Coefficients;
};

/** Smooth step: 0 below a, 1 above b. */
double
SmoothStep(double a, double b, double x);
} // namespace shapeton

#endif
