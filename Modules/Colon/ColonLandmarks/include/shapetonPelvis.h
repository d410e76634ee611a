#ifndef shapetonPelvis_h
#define shapetonPelvis_h

#include "ShapetonColonLandmarksExport.h"

#include "itkImage.h"

#include <Eigen/Core>

#include <optional>

namespace shapeton
{
/** \class Pelvis
 * \brief Bony landmarks around the pelvic brim; LPS, mm.
 * \ingroup ShapetonColonLandmarks */
struct Pelvis
{
  /** Highest points of the iliac crests. */
  Eigen::Vector3d leftCrest{ Eigen::Vector3d::Zero() };
  Eigen::Vector3d rightCrest{ Eigen::Vector3d::Zero() };
  /** Front edge of the top of the sacrum, where the pelvic brim meets the spine. */
  Eigen::Vector3d promontory{ Eigen::Vector3d::Zero() };
};

/** Finds the pelvis in a CT in Hounsfield units. Empty if it is not in view.
 *
 * The CT is averaged over cubic cells of 3 mm (or 1.25 times the largest spacing) aligned with the axes of the patient,
 * so that neither the directions nor the spacing of the image matter. Cells of at least 150 HU are bone or contrast
 * agent. The hip bones are the largest connected parts more than 40 mm to the left and right of the midline. The
 * promontory is the most prominent point, forward and down, of the front edge of the largest connected part within 24
 * mm of the midline, 10 to 80 mm below the crests.
 *
 * To exclude contrast agent and cropped scans, each hip bone must measure at least 100 ml and 70 mm from top to bottom,
 * have less than 5 % of its surface in contact with gas (bone never touches gas), extend at least 20 mm behind the
 * promontory, and end at least 10 mm below the top of the image. The crests must differ in height by at most 40 mm and
 * be 120 to 360 mm apart; the spine must extend from above the crests to at least 40 mm below them.
 *
 * Accuracy: 6 mm (two cells), except up to 15 mm for the height of the promontory. Bowel with contrast agent that
 * touches a hip bone may hide the pelvis; give a cleansed CT.
 * \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT std::optional<Pelvis>
                              FindPelvis(const itk::Image<float, 3> * ct);

/** The pelvis with left and right swapped, for a line whose x is negated. \ingroup ShapetonColonLandmarks */
ShapetonColonLandmarks_EXPORT Pelvis
Mirrored(const Pelvis & pelvis);
} // namespace shapeton

#endif
