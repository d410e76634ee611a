#ifndef shapetonColonPhantomParameters_h
#define shapetonColonPhantomParameters_h

#include "ShapetonPhantomsExport.h"
#include "shapetonColonPatientOptions.h"
#include "shapetonColonStructureOptions.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** Marks a parameter to be drawn from the seed. \ingroup ShapetonPhantoms */
constexpr double drawnBySeed = -1.0;

/** Value of `lungDensity` that selects the mean density of `lungs`; equal to drawnBySeed. \ingroup ShapetonPhantoms */
constexpr double lungDensityOfState = -1.0;

/** Names of the optional organs. Skin, fat, muscles and bones are always included.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT const std::vector<std::string> &
                              PhantomOrgans();

/** A value for each segment of the colon, rectum to cecum. \ingroup ShapetonPhantoms */
using SegmentValues = std::array<double, 6>;

/** \class ColonPhantomParameters
 * \brief Parameters of a synthetic patient for CT colonography and the patient's position.
 *
 * The seed determines the patient: the shape of the colon at rest, folds, taeniae coli and polyps. All other parameters
 * may differ between two examinations of a patient. Default values: preset standard. Numbers of ColonStructureOptions
 * may be drawnBySeed.
 * \ingroup ShapetonPhantoms */
struct ColonPhantomParameters
  : ColonPatientOptions
  , ColonStructureOptions
{
  /** Lengths of the segments along the colon in mm, from rectum to cecum (valve to pole): 0 (from the template),
   * drawnBySeed, or 40 to 1200. Segments are shortened if space is limited. */
  SegmentValues lengths{};
  /** Mean diameters of the segments in mm: 0 (from the template), drawnBySeed, or 15 to 90. */
  SegmentValues caliber{};
  /** The organs to include, from PhantomOrgans(). Omitted organs are replaced by fat, lungs by soft tissue; the shapes
   * of other organs are unchanged. */
  std::vector<std::string> contents{ PhantomOrgans() };
};

/** Whether an organ is included in the contents. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT bool
Contains(const ColonPhantomParameters & parameters, const std::string & organ);

/** Whether the patient has a whole chest rather than a plain one. \ingroup ShapetonPhantoms */
inline bool
HasWholeChest(const ColonPhantomParameters & parameters)
{
  return parameters.lungs != "plain";
}

/** Whether a preset reproduces the voxels of published tables: standard and hard. Later improvements apply only to
 * realistic. \ingroup ShapetonPhantoms */
inline bool
KeepsPublishedVoxels(const ColonPhantomParameters & parameters)
{
  return parameters.preset != "realistic";
}

/** The parameters of the preset standard, hard or realistic. Throws ParameterError for an unknown name.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT ColonPhantomParameters
ColonPhantomPreset(const std::string & name);

/** Replaces all values drawnBySeed by values drawn from the seed and, for the content of the ileum, the position. Given
 * values do not affect drawn ones. The values are drawn from
 * - lengths: rectum 150 to 180, sigmoid 350 to 1200, descending 220 to 330, transverse 550 to 1150, ascending 180 to
 * 330, cecum 60 to 95 mm;
 * - caliber: rectum 36 to 54, sigmoid 24 to 36, descending 26 to 44, transverse 32 to 54, ascending 42 to 68, cecum 50
 * to 78 mm;
 * - cecumMobility: 30 to 80 mm in three of ten patients, otherwise 0 to 10;
 * - sigmoidRise: 30 to 90 mm in six of ten sigmoids of at least 650 mm, otherwise 0; sigmoidStraightness: 0.7 to 1 in
 * six of ten sigmoids of at most 550 mm, otherwise 0;
 * - spasm: 50 to 150 mm in one of four patients, filledStretch: 30 to 120 mm in four of ten, levelSlope: 0.15 to 0.35
 * in three of ten, smallLevels: 1 to 3 in four of ten, sigmoidContact: 40 to 80 mm in four of ten; otherwise 0;
 * - smallBowelTagged: 0.5 to 1; stomachIntensity: 100 to 650 HU;
 * - stool: 0 to 14, three of ten pieces adhere to the wall, the others are at the lowest point in each position, and
 * large ones may contain gas; stoolTagged: 0.3 to 0.9 (200 to 650 HU, otherwise 20 to 70); bubbles: 0 to 20; foam: 1 to
 * 4 in three of ten patients, otherwise 0;
 * - diverticula: none in six of ten patients, otherwise 3 to 25; their locations depend only on the patient;
 * - noise: 15 to 60 HU; kernel: a third each; sliceThickness: 0.6 to 2.5 mm;
 * - catheter: rigid or soft, none in four of ten patients; catheterBore: 4 to 6, catheterWall: 2 to 2.6, catheterDepth:
 * 55 to 80, soft 75 to 125 mm; catheterIntensity: 120 to 280 HU; catheterHoles: 2 to 4, in four of ten patients 0, with
 * an open end; balloonDiameter: 22 to 38 mm;
 * - valveLength: 15 to 30, valveHeight: 8 to 15, ileumBore: 8 to 12, ileumLength: 60 to 120 mm; valveFat: 0 to 0.2 in
 * three of ten patients, otherwise 0.7 to 0.95;
 * - ileumReflux: gas in three of ten patients, with ileumBore 10 to 25 and ileumLength 50 to 1500 mm, uniform on a
 * logarithmic scale. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT ColonPhantomParameters
Drawn(const ColonPhantomParameters & parameters);

/** Throws ParameterError with the name of the first parameter out of range. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT void
RequireValid(const ColonPhantomParameters & parameters);
} // namespace shapeton

#endif
