#ifndef FoldErrors_h
#define FoldErrors_h

#include "shapetonHaustralFolds.h"

#include <string>

/** How the folds found on a flat map differ from the true ones.
 *
 * The true crest of a fold is sampled where it stands at least 1 mm above the wall; each sample goes to the nearest
 * point of the flat surface. It is seen when that is within 3 mm and not on a bridge; a fold of which less than half is
 * seen is hidden and counts for nothing. A true fold is found when at least half of its seen samples lie within 2 mm of
 * one and the same label. Each label is given to the one true fold (of 2 mm and more) of which it covers most samples:
 * what else it covers has been merged with it, and is not found. A label is right when at least half of its pixels lie
 * within 4 mm, in space, of the crest of a true fold that is at least 1.5 mm high. Errors of ends are distances in
 * space from the ends of the true crest, where it has come down to the wall, to those of the fold it was given, in the
 * better of both orders. */
struct FoldErrors
{
  /** Of the true folds with a height of 3.5 mm and more. */
  int present{ 0 };
  int found{ 0 };
  /** The same without the rule that a label goes to one fold alone. */
  int covered{ 0 };
  /** Of those of 2 to 3.5 mm. */
  int lowPresent{ 0 };
  int lowFound{ 0 };
  int hidden{ 0 };
  /** Labels, and those that are right. */
  int labels{ 0 };
  int right{ 0 };
  /** Labels that cover half of more than one true fold. */
  int merged{ 0 };
  /** Of the folds found, mm: two for each. */
  std::vector<double> ends;
  /** Length found over length of the true crest, and height found less true height, mm, of the folds found. */
  std::vector<double> lengthRatios;
  std::vector<double> heightErrors;
  /** For people: folds not found and labels that are wrong. */
  std::vector<std::string> faults;

  /** Adds the counts of another exam. */
  void
  Add(const FoldErrors & other);
};

/** `truth` as ColonAnatomy::Folds() gives it, in the space of the surface. */
FoldErrors
MeasureFoldErrors(const shapeton::FlatColonGrid & grid,
                  const shapeton::HaustralFolds & found,
                  const shapeton::CurveSet &      truth);

#endif
