#ifndef ColonTrial_h
#define ColonTrial_h

#include "LandmarkTrial.h"
#include "SurfaceDistances.h"

/** Errors of a colon model. Fractions are relative to the true structures; 1 if there are none. */
struct ColonErrors
{
  double dice{ 0.0 };
  /** Distances between the found lumen and the true one. */
  SurfaceDistances lumen;
  /** Labeled voxels more than 2 mm outside of the true lumen, beyond its wall. */
  double leakMl{ 0.0 };
  /** Distance from vertices of the raw wall, excluding bridges, to the true wall (mm). */
  double surfaceMedian{ 0.0 };
  double surface95{ 0.0 };
  /** Distance for vertices within 3 mm of a fluid level (mm). */
  double level95{ 0.0 };
  /** Distance from the true wall to the raw one (mm), to detect missed parts. */
  double missed95{ 0.0 };
  /** Folds at least 2.5 mm thick in fluid, and polyps of at least 6 mm outside of collapsed sections, that keep 90 % of
   * their volume in the cleansed CT. */
  int keptFolds{ 0 };
  int folds{ 0 };
  int keptPolyps{ 0 };
  int polyps{ 0 };

  /** Length / true length - 1. */
  double lengthError{ 0.0 };
  /** Distance from the line, excluding gaps, to the true line (mm). */
  double meanLineDistance{ 0.0 };
  /** Fraction of the true line, excluding collapsed sections, that is no farther from the found line than the lumen's
   * radius. */
  double covered{ 0.0 };
  /** Number of jumps of more than 40 mm along the true line (gaps excluded), plus the number of reversals. */
  int shortCuts{ 0 };
  /** Whether the pieces are in the true order. */
  bool isOrderRight{ true };

  int    genusRaw{ 0 };
  int    genusRepaired{ 0 };
  double changedMl{ 0.0 };
  /** Whether all three surfaces are manifold with one component and two boundary loops. */
  bool   areTubes{ false };
  int    faces{ 0 };
  double smallestAngle{ 0.0 };
  bool   isGenusKept{ false };

  double      seconds{ 0.0 };
  std::string failure;
};

/** Generates the phantom, builds the model from its CT only, and measures it. `faces` is the requested number of
 * faces. */
ColonErrors
TryColon(const LandmarkCase & one, int faces);

#endif
