#ifndef FoldErrors_h
#define FoldErrors_h

#include "shapetonHaustralFolds.h"

#include <string>

/** Errors of the folds detected on a flat map relative to the true folds. The true crest of a fold is sampled where it
 * is at least 1 mm above the wall; each sample is assigned to the nearest point of the flat surface. A sample is
 * visible if that point is within 3 mm and not on a bridge. A fold with less than half of its samples visible is hidden
 * and ignored. A true fold is found if at least half of its visible samples are within 2 mm of a single label. Each
 * label is assigned to the true fold (at least 2 mm high) of which it covers the most samples; other covered folds are
 * merged with that fold and count as missed. A label is correct if at least half of its pixels are within 4 mm, in 3D,
 * of the crest of a true fold at least 1.5 mm high. End point errors are 3D distances between the ends of the true
 * crest, at the wall, and the ends of the assigned fold, in the better order. */
struct FoldErrors
{
  /** True folds at least 3.5 mm high. */
  int present{ 0 };
  int found{ 0 };
  /** Found folds if a label may be assigned to several folds. */
  int covered{ 0 };
  /** True folds 2 to 3.5 mm high. */
  int lowPresent{ 0 };
  int lowFound{ 0 };
  int hidden{ 0 };
  /** Labels, and correct labels. */
  int labels{ 0 };
  int right{ 0 };
  /** Labels that cover half of more than one true fold. */
  int merged{ 0 };
  /** End point errors of the folds found (mm), two per fold. */
  std::vector<double> ends;
  /** Found length / true crest length, and found height - true height (mm), of the folds found. */
  std::vector<double> lengthRatios;
  std::vector<double> heightErrors;
  /** Visible wall points of the phantom's grid, one per 25 mm^2 of wall without folds, that are on a true fold and
   * labeled, and that are on a true fold or labeled. Their ratio estimates the segmented-area ratio of Zhu et al., IEEE
   * TBME 60 (2013) 321-331: the area of the intersection over the area of the union. */
  int areaOfBoth{ 0 };
  int areaOfEither{ 0 };
  /** Readable descriptions of missed folds and wrong labels. */
  std::vector<std::string> faults;

  /** Adds the counts of another exam. */
  void
  Add(const FoldErrors & other);
};

/** `truth` is the result of ColonAnatomy::Folds(), and `wall` of ColonAnatomy::Correspondence(), in the coordinates of
 * the surface. */
FoldErrors
MeasureFoldErrors(const shapeton::FlatColonGrid & grid,
                  const shapeton::HaustralFolds & found,
                  const shapeton::CurveSet &      truth,
                  const shapeton::CurveSet &      wall);

#endif
