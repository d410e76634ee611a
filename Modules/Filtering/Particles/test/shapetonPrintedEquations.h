#ifndef shapetonPrintedEquations_h
#define shapetonPrintedEquations_h

#include "shapetonParticleTestTools.h"

/** The shape distribution of an octant with the edge weights w1, w2, w3, according to the appendix of the dissertation.
 * The printed equations lose digits to cancellation: up to 8e-16 of the cube of the largest weight. */
namespace shapeton
{
namespace test
{
/** The weights of the edges to the neighbors at -x, +x, -y, +y, -z, +z. */
using EdgeWeights = std::array<double, 6>;

/** Volume of the part of an octant with an angle of at most `phi`, as printed. */
inline double
Equation85(double w1, double w2, double w3, double phi)
{
  const double p2 = pi * pi, p3 = p2 * pi, p4 = p3 * pi, p5 = p4 * pi, p6 = p5 * pi;
  const double w11 = w1 * w1, w22 = w2 * w2, w33 = w3 * w3, w111 = w11 * w1, w222 = w22 * w2, w333 = w33 * w3;
  const double a = -(1.0 / 12.0) *
                   (384 * w333 + 1152 * w22 * w3 - 144 * w22 * p2 * w3 + 144 * w2 * p2 * w33 + 48 * w222 * p2 -
                    48 * w333 * p2 - 1152 * w2 * w33 - 384 * w222) /
                   p6;
  const double b = -(1.0 / 9.0) *
                   (576 * w2 * pi * w33 - 192 * w1 * p2 * w2 * w3 + 144 * w22 * p3 * w3 - 576 * w1 * pi * w33 -
                    48 * w1 * p3 * w2 * w3 - 72 * w222 * p3 + 24 * w1 * p3 * w33 + 96 * w1 * p2 * w22 -
                    1152 * w22 * pi * w3 - 576 * w1 * pi * w22 + 24 * w1 * p3 * w22 + 576 * w222 * pi -
                    72 * w2 * p3 * w33 + 96 * w1 * p2 * w33 + 1152 * w1 * pi * w2 * w3) /
                   p6;
  const double c =
    -(1.0 / 6.0) *
    (96 * w1 * p3 * w2 * w3 - 96 * w1 * p3 * w22 + 24 * w1 * p4 * w2 * w3 + 96 * w11 * p3 * w2 -
     576 * w1 * p2 * w2 * w3 + 36 * w222 * p4 - 288 * w11 * p2 * w2 - 36 * w22 * p4 * w3 - 24 * w1 * p4 * w22 -
     288 * w222 * p2 - 96 * w11 * p3 * w3 + 288 * w22 * p2 * w3 + 576 * w1 * p2 * w22 + 288 * w11 * p2 * w3) /
    p6;
  const double d = -(1.0 / 3.0) *
                   (144 * w11 * p3 * w2 + 48 * w222 * p3 + 24 * w111 * p4 - 48 * w111 * p3 - w111 * p6 -
                    48 * w11 * p4 * w2 - 6 * w222 * p5 + 6 * w1 * p5 * w22 + 24 * w1 * p4 * w22 - 144 * w1 * p3 * w22) /
                   p6;
  return (((a * phi + b) * phi + c) * phi + d) * phi;
}

/** Volume of an octant, as printed. */
inline double
Equation86(double w1, double w2, double w3)
{
  const double p2 = pi * pi, p3 = p2 * pi;
  const double w11 = w1 * w1, w22 = w2 * w2, w33 = w3 * w3, w111 = w11 * w1, w222 = w22 * w2, w333 = w33 * w3;
  return (1.0 / 12.0) *
         (2 * w111 * p3 - 16 * w1 * pi * w22 + 48 * w11 * pi * w2 - 16 * w1 * pi * w33 - 48 * w111 * pi -
          16 * w1 * pi * w2 * w3 + 48 * w11 * pi * w3 - 24 * w2 * w33 - 4 * w1 * p2 * w22 + 3 * w22 * w3 * p2 +
          96 * w111 + 96 * w1 * w22 + 3 * w333 * p2 - 144 * w11 * w2 - 24 * w333 + 3 * w222 * p2 + 3 * w2 * w33 * p2 -
          144 * w3 * w11 - 24 * w22 * w3 + 96 * w1 * w33 - 4 * w3 * w1 * p2 * w2 - 24 * w222 + 96 * w1 * w2 * w3 -
          4 * w33 * w1 * p2) /
         p2;
}

/** Area of the sector from the first axis to `theta`, as printed. */
inline double
Equation87(double w1, double w2, double theta)
{
  return 2.0 / (3.0 * pi * pi) * (w2 - w1) * (w2 - w1) * std::pow(theta, 3) + w1 * (w2 - w1) * theta * theta / pi +
         0.5 * w1 * w1 * theta;
}

/** Volume per unit of phi between two angles from the first axis: integral of R^3 / 3 sin(theta). */
inline double
SectorVolume(double w1, double across, double from, double to)
{
  return Gauss()(
    from, to, [&](double theta) { return std::pow(w1 + (across - w1) * theta / halfPi, 3) / 3.0 * std::sin(theta); });
}
} // namespace test
} // namespace shapeton

#endif
