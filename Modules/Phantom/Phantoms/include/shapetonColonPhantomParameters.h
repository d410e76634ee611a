#ifndef shapetonColonPhantomParameters_h
#define shapetonColonPhantomParameters_h

#include "ShapetonPhantomsExport.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** Marks a parameter to be drawn from the seed. \ingroup ShapetonPhantoms */
constexpr double drawnBySeed = -1.0;

/** Value of `lungDensity` that selects the mean density of `lungs`. \ingroup ShapetonPhantoms */
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
 * may differ between two examinations of a patient. Default values: preset standard.
 *
 * Where two ranges are listed, the first is valid input and drawnBySeed draws from the second.
 * \ingroup ShapetonPhantoms */
struct ColonPhantomParameters
{
  /** supine, prone, leftDecubitus (lying on the left side) or rightDecubitus. */
  std::string position{ "supine" };
  unsigned    seed{ 1 };
  /** Name of the preset that defines the other values. */
  std::string preset{ "standard" };
  /** Number of polyps, 0 to 50. */
  int polyps{ 8 };
  /** Fluid fraction of the lumen volume, 0 to 1. */
  double fluid{ 0.2 };
  /** Number of collapsed stretches, 0 to 5. */
  int collapsed{ 0 };
  /** Number of contacts between two stretches through the thinnest septum, 0 to 8. */
  int fakeHandles{ 2 };
  /** Amplitude of wall irregularities in mm, 0 to 1. */
  double roughness{ 0.2 };
  /** Fraction of folds flattened by distension in this position, 0 to 1. */
  double flattenedFolds{ 0.1 };
  /** Maximum shift of a fold along the wall between two positions in mm, 0 to 10. */
  double foldSlide{ 3.0 };
  /** Scale factor of the lumen radius, 0.6 to 1.3. */
  double distension{ 1.0 };
  /** Maximum rotation of the tube about its centerline in a position in degrees, 0 to 90. */
  double torsion{ 15.0 };
  /** Standard deviation of the scanner noise in HU, 0 to 300; 15 to 60. */
  double noise{ 25.0 };
  /** Reconstruction kernel: standard, soft, sharp or drawn (each a third). Determines blur and noise correlation. */
  std::string kernel{ "standard" };
  /** Slice thickness in mm, independent of the slice spacing, 0 (equal to the in-plane blur) to 5; 0.6 to 2.5. */
  double sliceThickness{ 0.0 };
  /** Lengths of the segments along the colon in mm, from rectum to cecum (valve to pole): 0 (from the template) or 40
   * to 1200; rectum 150 to 180, sigmoid 350 to 1200, descending 220 to 330, transverse 550 to 1150, ascending 180 to
   * 330, cecum 60 to 95. Segments are shortened if space is limited. */
  SegmentValues lengths{};
  /** Mean diameters of the segments in mm: 0 (from the template) or 15 to 90; rectum 36 to 54, sigmoid 24 to 36,
   * descending 26 to 44, transverse 32 to 54, ascending 42 to 68, cecum 50 to 78. */
  SegmentValues caliber{};
  /** Maximum displacement of the cecum from its rest position in mm, 0 to 100; 30 to 80 in three of ten patients,
   * otherwise 0 to 10. */
  double cecumMobility{ 0.0 };
  /** Fraction of the small bowel with contrast medium, 0 to 1; .5 to 1. */
  double smallBowelTagged{ 0.8 };
  /** HU of the fluid in the stomach, 0 to 900; 100 to 650. */
  double stomachIntensity{ 150.0 };
  /** Number of pieces of stool of 4 to 20 mm beyond the rectum, 0 to 60; 0 to 14. Three of ten pieces adhere to the
   * wall; the others are at the lowest point in each position. Large ones may contain gas. */
  int stool{ 0 };
  /** Fraction of the stool that is tagged (200 to 650 HU, otherwise 20 to 70), 0 to 1; .3 to .9. */
  double stoolTagged{ drawnBySeed };
  /** Number of bubbles of 2 to 7 mm at the wall below fluid levels, 0 to 100; 0 to 20. */
  int bubbles{ 0 };
  /** Number of patches of foam on fluid levels, 0 to 20; 1 to 4 in three of ten patients, otherwise 0. */
  int foam{ 0 };
  /** Number of diverticula, mostly in the sigmoid and descending colon, 0 to 60; none in six of ten patients, otherwise
   * 3 to 25. Their locations depend only on the patient; they are closed in positions without enough space. */
  int diverticula{ 0 };
  /** The rectal catheter: none, central (in the middle of the lumen, with a closed end), rigid (straight beyond the
   * anal canal), soft (rests on the wall) or drawn: rigid or soft, and none in four of ten patients. Without a
   * catheter, the anal canal is closed and the following parameters are ignored. */
  std::string catheter{ "central" };
  /** Inner diameter in mm, 2 to 8; 4 to 6. */
  double catheterBore{ 6.0 };
  /** Wall thickness in mm, 0.8 to 3; 2 to 2.6. */
  double catheterWall{ 1.0 };
  /** HU of the wall, 50 to 1000; 120 to 280. */
  double catheterIntensity{ 280.0 };
  /** Distance from the anal verge to the tip in mm, 45 to 150, reduced if a rigid catheter would hit the wall; 55 to
   * 80, soft 75 to 125. */
  double catheterDepth{ 75.0 };
  /** Number of side holes near the tip, 0 to 4, excluding holes covered by a balloon; in four of ten patients 0, with
   * an open end. */
  int catheterHoles{ 0 };
  /** Balloon around the catheter inside the anal canal: none, gas, fluid (water), deflated (a sleeve) or drawn. */
  std::string balloon{ "none" };
  /** Diameter of a balloon with gas or fluid in mm, 12 to 45, reduced if the rectum is narrower or the tip is too
   * close; 22 to 38. */
  double balloonDiameter{ drawnBySeed };
  /** The ileocecal valve: bump (a smooth half ellipsoid) or lips (two lips around a slit, with the terminal ileum
   * behind it). The following six parameters are for lips. */
  std::string valve{ "bump" };
  /** Length of the lips along the slit in mm, 12 to 40; 15 to 30. */
  double valveLength{ drawnBySeed };
  /** Height of the lips above the wall in mm, 5 to 18; 8 to 15. */
  double valveHeight{ drawnBySeed };
  /** Fat fraction of the lips below their mucosa, 0 to 1; 0 to .2 in three of ten patients, otherwise .7 to .95. */
  double valveFat{ drawnBySeed };
  /** Bore of the terminal ileum in mm, 5 to 16; 8 to 12. */
  double ileumBore{ drawnBySeed };
  /** Length of the terminal ileum in mm, 40 to 150; 60 to 120, reduced if space is limited. */
  double ileumLength{ drawnBySeed };
  /** Content of the terminal ileum: collapsed, gas, fluid (tagged) or drawn; drawn may differ between positions. */
  std::string ileumContent{ "drawn" };
  /** The chest: plain (lung bases of -850 HU without detail, no shoulders), or a whole chest with lungs in
   * inspiration (mean -865 HU), quietBreathing (-765 HU) or emphysema (-940 HU, with holes). */
  std::string lungs{ "plain" };
  /** Mean HU of the parenchyma of a whole chest (including holes, excluding vessels, airways and fissures), -980 to
   * -500, or lungDensityOfState. */
  double lungDensity{ lungDensityOfState };
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

/** Replaces all values drawnBySeed by values drawn from the seed and, where documented, the position. Given values do
 * not affect drawn ones. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT ColonPhantomParameters
Drawn(const ColonPhantomParameters & parameters);

/** Throws ParameterError with the name of the first parameter out of range. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT void
RequireValid(const ColonPhantomParameters & parameters);
} // namespace shapeton

#endif
