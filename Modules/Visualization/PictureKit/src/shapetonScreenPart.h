#ifndef shapetonScreenPart_h
#define shapetonScreenPart_h

#include "shapetonPatientView.h"
#include "shapetonPicture.h"
#include "shapetonSurfaceMesh.h"

#include <vector>

namespace shapeton
{
/** Samples for each pixel along a side. */
constexpr int samplesAlongPixel = 3;
/** Places on the screen are whole numbers of this part of a sample: what two faces share is the same for both, so that
 * no gap opens between them and no sample counts twice. */
constexpr int subsamples = 64;

/** A vertex as the picture sees it. */
struct ScreenVertex
{
  int   x; ///< to the right, in parts of a sample
  int   y; ///< downwards
  float z; ///< mm away from the viewer
  /** To the right, up, towards the viewer; of length 1, or 0 where there is none. */
  float normal[3];
};

/** A mesh as the picture sees it. The faces are not owned. */
struct ScreenPart
{
  std::vector<ScreenVertex> vertices;
  const FaceMatrix *        faces{ nullptr };
  std::vector<RGBColor>     vertexColors;
  std::vector<RGBColor>     faceColors;
  RGBColor                  color;
  float                     opacity{ 1.0F };
  /** Whether what lies behind its surroundings is darkened: not where the colour is a value to be read. */
  bool hasDepthShading{ true };
};

/** A place in pixels as a ScreenVertex has it. */
int
ScreenPlace(double pixel);

/** The sum of the normals of the faces around each vertex, by area, to length 1. */
VertexMatrix
VertexNormals(const VertexMatrix & V, const FaceMatrix & F);

/** Without colours. */
ScreenPart
ProjectMesh(const SurfaceMesh & mesh, const PatientView & view);
} // namespace shapeton

#endif
