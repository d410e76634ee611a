#ifndef shapetonPi_h
#define shapetonPi_h

namespace shapeton
{
/** The ratio of a circle's circumference to its diameter, in the precision of TReal. \ingroup ShapetonCommon */
template <typename TReal>
constexpr TReal PiOf = TReal(3.14159265358979323846264338327950288L);

/** PiOf in double precision. \ingroup ShapetonCommon */
constexpr double Pi = PiOf<double>;
/** A full turn in radians. \ingroup ShapetonCommon */
constexpr double TwoPi = 2.0 * Pi;
/** One radian in degrees. \ingroup ShapetonCommon */
constexpr double DegreesPerRadian = 57.295779513082320877;
} // namespace shapeton

#endif
