#ifndef shapetonSurfaceRendering_h
#define shapetonSurfaceRendering_h

#include "PictureKitExport.h"

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
/** A surface in a scene. The mesh is not owned.
 * \ingroup PictureKit */
struct SurfaceActor
{
  const SurfaceMesh * surface{ nullptr };
  /** Where neither vertices nor faces have colours. */
  RGBColor color{ MakeColor(226, 178, 164) };
  /** One for each vertex, blended over the faces; or none. */
  std::vector<RGBColor> vertexColors;
  /** One for each face; or none. They win over those of the vertices. */
  std::vector<RGBColor> faceColors;
  /** In (0, 1]; 1 hides what is behind. Less looks like a double-contrast X-ray: a face seen edge-on is denser than one
   * seen from the front, so that contours stay clear and what lies inside is seen. */
  double opacity{ 1.0 };
};

/** Curves in a scene, drawn as tubes; a curve of one vertex is a ball. Not owned.
 * \ingroup PictureKit */
struct CurveActor
{
  const CurveSet * curves{ nullptr };
  /** mm. */
  double   radius{ 1.5 };
  RGBColor color{ MakeColor(255, 255, 255) };
  /** One for each vertex of the set; or none. */
  std::vector<RGBColor> vertexColors;
};

/** A ball with a name beside it.
 * \ingroup PictureKit */
struct MarkerActor
{
  /** LPS, mm. */
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
  /** mm. */
  double      radius{ 4.0 };
  RGBColor    color{ MakeColor(255, 255, 255) };
  std::string label;
};

/** What a picture shows.
 * \ingroup PictureKit */
struct SurfaceScene
{
  std::vector<SurfaceActor> surfaces;
  std::vector<CurveActor>   curves;
  std::vector<MarkerActor>  markers;
};

/** How a scene is shown.
 * \ingroup PictureKit */
struct SurfaceRenderingOptions : PatientViewOptions
{
  /** Above the picture; none takes no room. */
  std::string title;
  /** At the right of the picture. */
  std::optional<ColorScale> colorBar;
  /** In the upper left corner. */
  std::vector<LegendEntry> legend;
  /** Orientation letters at the borders and a scale bar. */
  bool annotations{ true };
  /** Darkens solid surfaces where they lie behind their surroundings, so that loops stand apart; 0 for none (where
   * colours are values to be read), 1 is strong. */
  double depthShading{ 0.6 };
};

/** A picture of surfaces, curves and markers in a parallel projection that shows all of them at zoom 1.
 *
 * Drawn with a depth buffer on the CPU: 3 x 3 samples for each pixel, normals blended over the faces, light from over
 * the viewer's left shoulder, both sides of a face alike. Opaque things hide each other sample by sample; see-through
 * ones (SurfaceActor::opacity) lie over what is behind them whatever their order, and hide nothing. Equal input gives
 * equal bytes for any number of threads; ITK's global default number is used. Memory: about 30 bytes for each vertex
 * and face, and 5 for each pixel.
 *
 * Throws std::invalid_argument for a scene without anything, a null pointer, colours that do not match in number, an
 * index out of range, an opacity or radius out of range, and for wrong options (see PatientView).
 * \ingroup PictureKit */
PictureKit_EXPORT Picture::Pointer
                  RenderSurfaces(const SurfaceScene & scene, const SurfaceRenderingOptions & options = {});

/** The view of RenderSurfaces(), in pixels of its picture. \ingroup PictureKit */
PictureKit_EXPORT PatientView
ViewOfScene(const SurfaceScene & scene, const SurfaceRenderingOptions & options);
} // namespace shapeton

#endif
