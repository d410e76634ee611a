#ifndef shapetonFoldShape_h
#define shapetonFoldShape_h

#include "shapetonFoldCrest.h"

namespace shapeton
{
/** A fold with its measurements. */
struct MeasuredFold
{
  /** Measures a fold, except for its label and reliabilities. */
  HaustralFold fold;
  FoldPixels   pixels;
  FoldCrest    crest;
};

/** `floor`: see TraceCrest(); the published scheme uses the axis of the ellipse as the crest. */
MeasuredFold
MeasureFold(const FlatColonGrid & grid, const FoldPicture & picture, FoldPixels pixels, HaustralFoldScheme scheme);
} // namespace shapeton

#endif
