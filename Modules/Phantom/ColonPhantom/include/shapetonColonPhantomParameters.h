#ifndef shapetonColonPhantomParameters_h
#define shapetonColonPhantomParameters_h

#include "ColonPhantomExport.h"

#include <string>

namespace shapeton
{
/** \class ColonPhantomParameters
 * \brief What a synthetic patient for CT colonography is like, and how the patient lies.
 *
 * The seed fixes the patient: the shape of the colon at rest, folds, taeniae and polyps. Everything else may differ
 * between two examinations of one patient. The defaults are the preset standard.
 * \ingroup ColonPhantom
 */
struct ColonPhantomParameters
{
  /** supine, prone, leftDecubitus (lying on the left side) or rightDecubitus. */
  std::string position{ "supine" };
  unsigned    seed{ 1 };
  /** The name of the preset that the other values come from. */
  std::string preset{ "standard" };
  /** Number of polyps, 0 to 50. */
  int polyps{ 8 };
  /** Share of the lumen's volume that is filled with fluid, 0 to 1. */
  double fluid{ 0.2 };
  /** Number of collapsed stretches, 0 to 5. */
  int collapsed{ 0 };
  /** Number of places where two stretches touch through the thinnest septum, 0 to 8. */
  int fakeHandles{ 2 };
  /** Amplitude of the unevenness of the wall in mm, 0 to 1. */
  double roughness{ 0.2 };
  /** Share of folds that distension has flattened in this position, 0 to 1. */
  double flattenedFolds{ 0.1 };
  /** The farthest that a fold slides along the wall between two positions in mm, 0 to 10. */
  double foldSlide{ 3.0 };
  /** Factor on the lumen's radius, 0.6 to 1.3. */
  double distension{ 1.0 };
  /** The farthest that the tube turns about its centreline in a position in degrees, 0 to 90. */
  double torsion{ 15.0 };
  /** Standard deviation of the scanner's noise in HU, 0 to 300. */
  double noise{ 25.0 };
};

/** The parameters of the preset standard or hard. Throws ParameterError for another name. \ingroup ColonPhantom */
ColonPhantom_EXPORT ColonPhantomParameters
ColonPhantomPreset(const std::string & name);

/** Throws ParameterError that names the first parameter out of its range. \ingroup ColonPhantom */
ColonPhantom_EXPORT void
RequireValid(const ColonPhantomParameters & parameters);
} // namespace shapeton

#endif
