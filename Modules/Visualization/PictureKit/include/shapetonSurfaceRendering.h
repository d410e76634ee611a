#ifndef shapetonSurfaceRendering_h
#define shapetonSurfaceRendering_h

#include "ShapetonPictureKitExport.h"

#include "shapetonCurveSet.h"
#include "shapetonPatientView.h"
#include "shapetonPicture.h"
#include "shapetonPictureAnnotation.h"
#include "shapetonSurfaceMesh.h"

#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Color of tissue. \ingroup ShapetonPictureKit */
inline const RGBColor TissueColor = MakeColor(226, 178, 164);

/** A surface in a scene. The mesh is not owned.
 * \ingroup ShapetonPictureKit */
struct SurfaceActor
{
  const SurfaceMesh * surface{ nullptr };
  /** Used if neither vertices nor faces have colors. */
  RGBColor color{ TissueColor };
  /** Empty, or one color per vertex, interpolated over the faces. */
  std::vector<RGBColor> vertexColors;
  /** Empty, or one color per face; these override vertex colors. */
  std::vector<RGBColor> faceColors;
  /** In (0, 1]; 1 is opaque. Lower values resemble a double-contrast X-ray: faces seen edge-on are denser than faces
   * seen from the front, so contours stay clear and the interior is visible. */
  double opacity{ 1.0 };
};

/** Curves in a scene, drawn as tubes; a curve with one vertex is a ball. Not owned.
 * \ingroup ShapetonPictureKit */
struct CurveActor
{
  const CurveSet * curves{ nullptr };
  /** mm. */
  double   radius{ 1.5 };
  RGBColor color{ MakeColor(255, 255, 255) };
  /** Empty, or one color per vertex of the set. */
  std::vector<RGBColor> vertexColors{};
};

/** A ball with a label.
 * \ingroup ShapetonPictureKit */
struct MarkerActor
{
  /** LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** mm. */
  double      radius{ 4.0 };
  RGBColor    color{ MakeColor(255, 255, 255) };
  std::string label;
};

/** Content of a picture.
 * \ingroup ShapetonPictureKit */
struct SurfaceScene
{
  std::vector<SurfaceActor> surfaces;
  std::vector<CurveActor>   curves;
  std::vector<MarkerActor>  markers;
};

/** View and annotations of a scene.
 * \ingroup ShapetonPictureKit */
struct SurfaceRenderingOptions : PatientViewOptions
{
  /** Title above the picture; no space is reserved for an empty title. */
  std::string title;
  /** Color bar at the right of the picture. */
  std::optional<ColorScale> colorBar;
  /** Legend in the upper left corner. */
  std::vector<LegendEntry> legend;
  /** Orientation letters at the borders and a scale bar. */
  bool annotations{ true };
  /** Darkens opaque surfaces that are behind their surroundings, to separate overlapping loops; 0 for none (if colors
   * encode values), 1 is strong. */
  double depthShading{ 0.6 };
};

/** Renders surfaces, curves and markers in a parallel projection that shows all of them at zoom 1.
 *
 * Drawn with a depth buffer on the CPU: 3 x 3 samples per pixel, interpolated normals, light from above the viewer's
 * left shoulder, two-sided faces. Opaque objects hide each other sample by sample. Transparent ones
 * (SurfaceActor::opacity) are blended over the objects behind them in any order, and do not occlude. Identical input
 * yields identical bytes for any number of threads; ITK's global default number is used. Memory: about 30 bytes per
 * vertex and face, and 5 per pixel.
 *
 * Throws std::invalid_argument for an empty scene, a null pointer, a wrong number of colors, an index out of range, an
 * opacity or radius out of range, and wrong options (see PatientView).
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT Picture::Pointer
                          RenderSurfaces(const SurfaceScene & scene, const SurfaceRenderingOptions & options = {});

/** The view of RenderSurfaces(), in pixels of its picture. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT PatientView
ViewOfScene(const SurfaceScene & scene, const SurfaceRenderingOptions & options);
} // namespace shapeton

#endif
