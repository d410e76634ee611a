#ifndef shapetonScreenPart_h
#define shapetonScreenPart_h

#include "shapetonPatientView.h"
#include "shapetonPicture.h"
#include "shapetonSurfaceMesh.h"

#include <vector>

namespace shapeton
{
/** Samples per pixel along each side. */
constexpr int samplesAlongPixel = 3;
/** Screen positions are multiples of this fraction of a sample. Shared edges are therefore identical for both faces, so
 * there are no gaps, and no sample is counted twice. */
constexpr int subsamples = 64;

/** A projected vertex. */
struct ScreenVertex
{
  int   x; ///< to the right, in subsamples
  int   y; ///< downwards, in subsamples
  float z; ///< depth away from the viewer, mm
  /** Components to the right, up and towards the viewer; unit length, or 0 if there is no normal. */
  float normal[3];
};

/** A projected mesh. The faces are not owned. */
struct ScreenPart
{
  std::vector<ScreenVertex> vertices;
  const FaceMatrix *        faces{ nullptr };
  std::vector<RGBColor>     vertexColors;
  std::vector<RGBColor>     faceColors;
  RGBColor                  color;
  float                     opacity{ 1.0F };
  /** Whether depth shading applies; false if colors encode values. */
  bool hasDepthShading{ true };
};

/** Converts a position in pixels to the units of ScreenVertex. */
int
ScreenPlace(double pixel);

/** Projects a mesh, without colors. */
ScreenPart
ProjectMesh(const SurfaceMesh & mesh, const PatientView & view);
} // namespace shapeton

#endif
