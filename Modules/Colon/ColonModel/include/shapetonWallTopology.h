#ifndef shapetonWallTopology_h
#define shapetonWallTopology_h

namespace shapeton
{
/** What happens to the handles of a lumen in the simplified wall, which is flattened. \ingroup ShapetonColonModel */
enum class WallTopology
{
  /** The lumen is repaired to a ball before the wall is extracted; see RepairLumenTopology(). */
  Repaired,
  /** The wall is extracted with its handles and simplified, then each handle is cut along a short loop; see
   * CutHandles(). */
  Denoised,
  /** The wall keeps its handles. */
  Raw
};
} // namespace shapeton

#endif
