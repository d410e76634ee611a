#ifndef shapetonHaustralFoldScheme_h
#define shapetonHaustralFoldScheme_h

namespace shapeton
{
/** Method that classifies pixels of the flat map as folds. \ingroup ShapetonFlatColon */
enum class HaustralFoldScheme
{
  /** Minimum graph cut with weights estimated from the surface. */
  GraphCut,
  /** Fixed interval for a curvature that is not divided by area (dissertation 4.2.1 and 4.3.1). It is valid only for
   * one mesh density; the curvature is negative where the wall bulges into the lumen. */
  Published
};
} // namespace shapeton

#endif
