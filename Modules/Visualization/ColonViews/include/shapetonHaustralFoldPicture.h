#ifndef shapetonHaustralFoldPicture_h
#define shapetonHaustralFoldPicture_h

#include "ColonViewsExport.h"

#include "shapetonFlatColonPage.h"
#include "shapetonHaustralFolds.h"

namespace shapeton
{
/** What a picture of folds is made of. Nothing is owned. \ingroup ColonViews */
struct HaustralFoldPictureContent
{
  /** That of the folds. */
  const FlatColon *     flat{ nullptr };
  const HaustralFolds * folds{ nullptr };
  /** Curves on the wall; may be null. */
  const CurveSet * taeniae{ nullptr };
  /** More to tell, such as segments. */
  std::vector<FlatAnnotation> annotations;
};

/** A page of the flat colon in rows (DrawFlatColonPage()): the relief, folds outlined in colours that differ
 * from their neighbours', green dots at their ends, larger where they are more reliable, taeniae as yellow lines.
 * `pixelSize`: mm of the map at the mean circumference. Throws InputError and ParameterError as FlatColonGrid does.
 * \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawHaustralFolds(const HaustralFoldPictureContent & content,
                                    double                             pixelSize,
                                    const std::string &                title,
                                    int                                greatestColumns = 1500);
} // namespace shapeton

#endif
