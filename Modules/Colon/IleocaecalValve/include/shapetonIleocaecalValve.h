#ifndef shapetonIleocaecalValve_h
#define shapetonIleocaecalValve_h

#include "IleocaecalValveExport.h"

#include "shapetonCurveSet.h"
#include "shapetonLumenDistance.h"

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <string>

namespace shapeton
{
/** \class IleocaecalValve
 * \brief Where the terminal ileum opens into a colon, or a place where it may. Lengths in mm, points in LPS.
 * \ingroup IleocaecalValve */
struct IleocaecalValve
{
  /** The middle of its surface. */
  Eigen::Vector3d position{ Eigen::Vector3d::Zero() };
  /** Along the centreline, from the anal verge. */
  double arcLength{ 0.0 };
  /** Of the part that bulges, across the way into the lumen: the greatest width, of two lips from end to end; the least
   * width of the greater one. */
  double length{ 0.0 };
  double width{ 0.0 };
  /** Median HU inside: lips hold fat. Not a number without a CT. */
  double attenuation{ std::numeric_limits<double>::quiet_NaN() };
  /** The probability, by the model, that this is the valve: 0 to 1. */
  double confidence{ 0.0 };
};

/** What FindIleocaecalValve() found. \ingroup IleocaecalValve */
struct ValveSearch
{
  /** The place that is most likely the valve, where its confidence is at least .5. */
  std::optional<IleocaecalValve> valve;
  /** Why it was not found; empty otherwise. */
  std::string reason;
};

/** Finds the ileocaecal valve within 160 mm of the end of a colon's centreline.
 *
 * Its candidates are bulges of the wall that stay when folds are smoothed away: the half level of the lumen smoothed by
 * a Gaussian of 3 mm, where both principal curvatures are above .01/mm; within 18 mm of each other they are the lips of
 * one. Log-odds add up from size, place along the line, likeness to a ball (a polyp on a stalk) and what it is made of.
 * One of the candidates, or none, is the valve; the confidence is the probability of the best and of those within 25 mm
 * of it, which lie on the same fold.
 *
 * \param labels the lumen, not 0.
 * \param ct HU on the same grid, cleansed or not; null: by shape alone.
 * \param centreline one curve from rectum to caecum with the point array arcLength (mm); InputError without it.
 * The same bytes for any number of threads. \ingroup IleocaecalValve */
IleocaecalValve_EXPORT ValveSearch
FindIleocaecalValve(const LumenMask * labels, const itk::Image<float, 3> * ct, const CurveSet & centreline);

/** \name The valve in the file of a centreline
 * As the field array ileocaecalValve: x, y, z (LPS, mm), arcLength, length, width (mm), confidence. */
///@{
/** Puts the valve into the curve, or takes it out. \ingroup IleocaecalValve */
IleocaecalValve_EXPORT void
SetIleocaecalValve(const std::optional<IleocaecalValve> & valve, CurveSet & centreline);
/** Nothing where the line knows of none. Throws InputError for an array of another size. \ingroup IleocaecalValve */
IleocaecalValve_EXPORT std::optional<IleocaecalValve>
                       IleocaecalValveOf(const CurveSet & centreline);
///@}
} // namespace shapeton

#endif
