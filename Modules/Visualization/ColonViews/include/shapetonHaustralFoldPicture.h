#ifndef shapetonHaustralFoldPicture_h
#define shapetonHaustralFoldPicture_h

#include "ShapetonColonViewsExport.h"

#include "shapetonFlatColonPage.h"
#include "shapetonHaustralFolds.h"

namespace shapeton
{
/** Inputs of a picture of folds. Not owned. \ingroup ShapetonColonViews */
struct HaustralFoldPictureContent
{
  /** Flat colon on which the folds were found. */
  const FlatColon *     flat{ nullptr };
  const HaustralFolds * folds{ nullptr };
  /** Curves on the wall; may be null. */
  const CurveSet * taeniae{ nullptr };
  /** Additional annotations, such as segments. */
  std::vector<FlatAnnotation> annotations;
};

/** A page of the flat colon in rows (DrawFlatColonPage()) with the relief. Folds are outlined, neighbors in different
 * colors, with green dots at their ends (larger if more reliable); taeniae are yellow lines. `pixelSize`: mm on the map
 * at the mean circumference. Throws the exceptions of FlatColonGrid.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawHaustralFolds(const HaustralFoldPictureContent & content,
                                            double                             pixelSize,
                                            const std::string &                title,
                                            int                                greatestColumns = 1500);
} // namespace shapeton

#endif
