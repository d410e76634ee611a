#ifndef shapetonCurvatureMethod_h
#define shapetonCurvatureMethod_h

namespace shapeton
{
/** Definition of the Ricci curvature of an edge, see MeasureCurvature(). \ingroup ShapetonGraphCurvature */
enum class CurvatureMethod
{
  Ollivier,       ///< optimal transport between lazy random walks
  LinLuYau,       ///< limit of Ollivier's curvature / (1 - idleness) for idleness 1
  Forman,         ///< combinatorial, edges only
  AugmentedForman ///< combinatorial, with triangles as faces
};
} // namespace shapeton

#endif
