#ifndef ColonTrial_h
#define ColonTrial_h

#include "shapetonColonModel.h"
#include "shapetonColonPhantomImageSource.h"

#include <array>

/** A synthetic patient in one position, as one scanner sees it. */
struct ColonCase
{
  shapeton::ColonPhantomParameters parameters;
  std::array<unsigned int, 3>      size{ { 256, 256, 240 } };
  double                           spacing{ 1.4 };
};

/** How far the model of a colon is from the truth. Shares are of what there is; 1 where there is nothing. */
struct ColonErrors
{
  double dice{ 0.0 };
  /** Labelled voxels more than 2 mm outside the true lumen, beyond its wall. */
  double leakMl{ 0.0 };
  /** From vertices of the raw wall, bridges left out, to the true wall, mm. */
  double surfaceMedian{ 0.0 };
  double surface95{ 0.0 };
  /** Of the vertices within 3 mm of a level. */
  double level95{ 0.0 };
  /** From the true wall to the raw one, mm: what was missed. */
  double missed95{ 0.0 };
  /** Folds at least 2.5 mm thick that lie in fluid, and polyps of at least 6 mm where the colon is not collapsed, that
   * keep 90 % of their volume in the cleansed CT. */
  int keptFolds{ 0 };
  int folds{ 0 };
  int keptPolyps{ 0 };
  int polyps{ 0 };

  /** Length over true length, less 1. */
  double lengthError{ 0.0 };
  /** From the line, gaps left out, to the true one, mm. */
  double meanLineDistance{ 0.0 };
  /** Of the true line where it is not collapsed, within the lumen's radius of the line. */
  double covered{ 0.0 };
  /** Places where the line jumps by more than 40 mm along the true one, gaps left out, or goes back. */
  int shortCuts{ 0 };
  /** The pieces follow each other as they do in the truth. */
  bool isOrderRight{ true };

  int    genusRaw{ 0 };
  int    genusRepaired{ 0 };
  double changedMl{ 0.0 };
  /** All three surfaces: one component, two loops, manifold. */
  bool   areTubes{ false };
  int    faces{ 0 };
  double smallestAngle{ 0.0 };
  bool   isGenusKept{ false };

  double      seconds{ 0.0 };
  std::string failure;
};

/** Makes the phantom, builds the model from its CT alone, and measures. `faces` are asked for. */
ColonErrors
TryColon(const ColonCase & one, int faces);

#endif
