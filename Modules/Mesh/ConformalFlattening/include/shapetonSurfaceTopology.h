#ifndef shapetonSurfaceTopology_h
#define shapetonSurfaceTopology_h

namespace shapeton
{
/** What happens to the handles of a surface before it is flattened. \ingroup ShapetonConformalFlattening */
enum class SurfaceTopology
{
  /** Nothing: they are on the map (dissertation 5.2). */
  Raw,
  /** They are cut along short loops (5.3.2); see CutHandles(). */
  Denoised,
  /** They are found as folds of a first map and replaced by patches (5.4.3); see RemoveHandles(). */
  Published
};
} // namespace shapeton

#endif
