#ifndef shapetonCubicBSpline_h
#define shapetonCubicBSpline_h

namespace shapeton
{
/** Weights of four consecutive coefficients of a uniform cubic B-spline at 0 <= t <= 1 of the middle interval, for the
 * value and the first two derivatives. */
struct CubicWeights
{
  explicit CubicWeights(double t)
  {
    const double     s = 1.0 - t;
    constexpr double slope = 1.5; // 9 / 6, from the derivative of value[1]
    value[0] = s * s * s / 6.0;
    value[1] = (4.0 + t * t * (3.0 * t - 6.0)) / 6.0;
    value[2] = (4.0 + s * s * (3.0 * s - 6.0)) / 6.0;
    value[3] = t * t * t / 6.0;
    first[0] = -0.5 * s * s;
    first[1] = t * (slope * t - 2.0);
    first[2] = -s * (slope * s - 2.0);
    first[3] = 0.5 * t * t;
    second[0] = s;
    second[1] = 3.0 * t - 2.0;
    second[2] = 3.0 * s - 2.0;
    second[3] = t;
  }
  double value[4];
  double first[4];
  double second[4];
};
} // namespace shapeton

#endif
