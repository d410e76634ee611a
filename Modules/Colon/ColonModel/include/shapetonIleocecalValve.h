#ifndef shapetonIleocecalValve_h
#define shapetonIleocecalValve_h

#include "ShapetonColonModelExport.h"

#include "shapetonCurveSet.h"
#include "shapetonJson.h"
#include "shapetonLumenDistance.h"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** \class IleocecalValve
 * \brief The opening of the terminal ileum into the colon, or a candidate for it. Lengths in mm, points in LPS.
 * \ingroup ShapetonColonModel */
struct IleocecalValve
{
  /** Center of its surface. */
  Eigen::Vector3d position{ Eigen::Vector3d::Zero() };
  /** Distance along the centerline from the anal verge. */
  double arcLength{ 0.0 };
  /** Extent of the bulge perpendicular to its axis: maximum width (over both lips), and minimum width of the larger
   * lip. */
  double length{ 0.0 };
  double width{ 0.0 };
  /** Median HU inside, since lips contain fat; NaN if there is no CT. */
  double attenuation{ std::numeric_limits<double>::quiet_NaN() };
  /** Model probability that this is the valve, 0 to 1. */
  double confidence{ 0.0 };
};

/** Result of FindIleocecalValve(). \ingroup ShapetonColonModel */
struct ValveSearch
{
  /** The most likely candidate, if its confidence is at least .5. */
  std::optional<IleocecalValve> valve;
  /** Reason why the valve was not found; empty otherwise. */
  std::string reason;
  /** Candidates of at least 0.1 %, most likely first; the confidence of each one is its own probability. */
  std::vector<IleocecalValve> candidates;
};

/** Finds the ileocecal valve within 160 mm of the end of the centerline of a colon.
 *
 * Candidates are bulges of the wall that remain after smoothing removes the folds: regions on the 0.5 level of the
 * lumen, smoothed by a Gaussian of 3 mm, where both principal curvatures are above .01/mm. Regions within 18 mm of each
 * other are the lips of one candidate. Log-odds are the sum of terms for size, position along the line, similarity to a
 * ball (a polyp on a stalk), two lips of similar size and tissue. At most one candidate is the valve. The confidence is
 * the probability of the best candidate plus those of the candidates within 25 mm of it, which are on the same fold.
 *
 * \param labels nonzero voxels are lumen.
 * \param ct HU on the same grid, cleansed or not; if null, only the shape is used.
 * \param centerline one curve from rectum to cecum with the point array arcLength (mm); throws InputError if the array
 * is missing. The result does not depend on the number of threads. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ValveSearch
FindIleocecalValve(const LumenMask * labels, const itk::Image<float, 3> * ct, const CurveSet & centerline);

/** Decides the valve in two scans of one colon together. Candidates within 20 mm of each other are the same place,
 * and the place takes a geometric mean of their odds in which the greater one weighs .8. The odds are not multiplied,
 * because both scans show the same shape, and one of them may show it poorly, for example with flattened lips. \param
 * first, second candidates of the scans, see ValveSearch::candidates. \param firstInSecond the places of the first ones
 * in the second scan. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::array<ValveSearch, 2>
                          FindValveInBoth(std::vector<IleocecalValve>          first,
                                          std::vector<IleocecalValve>          second,
                                          const std::vector<Eigen::Vector3d> & firstInSecond);

/** \name The valve in files
 * A centerline has the field arrays ileocecalValve and ileocecalValveCandidates with one row per place: x, y, z (LPS,
 * mm), arcLength, length, width (mm), confidence. */
///@{
/** Stores a search in a centerline; replaces a stored one. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT void
SetIleocecalValve(const ValveSearch & search, CurveSet & centerline);
/** The valve stored in a centerline, if any. Throws InputError if the array has the wrong size.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::optional<IleocecalValve>
                          IleocecalValveOf(const CurveSet & centerline);
/** The candidates stored in a centerline; errors as IleocecalValveOf(). \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::vector<IleocecalValve>
                          ValveCandidatesOf(const CurveSet & centerline);
/** A search as JSON: found, and position, arcLength, length, width, attenuation (null: no CT) and confidence, or
 * reason; candidates. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT Json
ValveToJson(const ValveSearch & search);
/** The inverse of ValveToJson(). Throws InputError for another document. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ValveSearch
ValveFromJson(const Json & json);
///@}
} // namespace shapeton

#endif
