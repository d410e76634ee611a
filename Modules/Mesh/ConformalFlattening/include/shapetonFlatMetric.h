#ifndef shapetonFlatMetric_h
#define shapetonFlatMetric_h

namespace shapeton
{
/** Edge lengths that the flat map preserves conformally. \ingroup ShapetonConformalFlattening */
enum class FlatMetric
{
  /** Straight edge lengths. */
  Euclidean,
  /** Heat diffusion distances from all eigenpairs. */
  HeatDiffusion,
  /** Heat diffusion distances from the first eigenpairs, as published. */
  TruncatedHeatDiffusion
};
} // namespace shapeton

#endif
