#ifndef shapetonFlatColonStrip_h
#define shapetonFlatColonStrip_h

#include "ShapetonColonViewsExport.h"

#include "shapetonDevice.h"
#include "shapetonFlatColonAxis.h"
#include "shapetonPictureAnnotation.h"

namespace shapeton
{
/** \defgroup FlatColonStrip Pictures of a whole flat colon with one pixel per grid sample A filet view: the wall as
 * seen by an eye that moves along the axis of the tube and looks sideways in all directions. Each pixel is lit in the
 * frame of the smooth tube (FrameAt()), from the left (along u) and above. Folds are thus transverse bands with a
 * bright and a dark side, independent of the bends of the colon. Pixels without a face are gray. The axis must belong
 * to the grid. Identical input yields identical bytes for any number of threads.
 * \ingroup ShapetonColonViews */
///@{

/** The grid of a picture: curvatures and normals averaged over lengths at which folds are distinct. `pixelSize`: mm of
 * the map. */
ShapetonColonViews_EXPORT FlatColonGridOptions
PictureGridOptions(double pixelSize);

/** Appearance of a relief. */
struct FlatReliefOptions
{
  /** Strength with which folds are drawn paler and pockets darker than the mean wall; 0 for one color, 1 is strong. */
  double heightContrast{ 0.4 };
};

/** The lit surface in mucosa colors. */
ShapetonColonViews_EXPORT Picture::Pointer
PaintFlatRelief(const FlatColonGrid & grid, const FlatColonAxis & axis, const FlatReliefOptions & options = {});

/** Blue where the wall bulges outwards, white, and orange to red where it bulges into the lumen. `limit`: curvature at
 * the ends, 1/mm. */
ShapetonColonViews_EXPORT ColorScale
CurvatureScale(double limit = 0.2);

/** The curvature of the grid (averaged over FlatColonGridOptions::curvatureLength) in these colors, shaded with this
 * strength, 0 to 1. */
ShapetonColonViews_EXPORT Picture::Pointer
                          PaintFlatCurvature(const FlatColonGrid & grid,
                                             const FlatColonAxis & axis,
                                             const ColorScale &    scale = CurvatureScale(),
                                             double                shading = 0.35);

/** Rendering parameters of the CT. Hounsfield units and mm. */
struct FlatVolumeOptions
{
  /** Opacity rises from 0 to 1 between these values: the boundary of gas and wall. */
  double gas{ -750.0 };
  double tissue{ -250.0 };
  /** Distance from the surface into the lumen where a ray starts; it starts closer to the surface if tissue is in the
   * way. */
  double depthOfLumen{ 3.0 };
  /** Distance beyond the surface where the ray ends. */
  double depthOfWall{ 4.0 };
  /** Extinction of tissue, 1/mm; controls the visible depth. */
  double extinction{ 2.5 };
};

/** Direct volume rendering (dissertation 5.5.1). Casts one ray per pixel from the lumen outwards along the wall normal,
 * through the trilinearly interpolated CT. Colored by intensity (fat, soft tissue, contrast medium), lit by its
 * gradient. The volume's origin, spacing and direction are respected. A cleansed CT shows the wall below the fluid, any
 * other CT the surface of the fluid.
 *
 * Throws InputError if more than 5 % of the wall is outside the CT, ParameterError for options out of range. */
ShapetonColonViews_EXPORT Picture::Pointer
                          PaintFlatVolume(const FlatColonGrid &        grid,
                                          const FlatColonAxis &        axis,
                                          const itk::Image<float, 3> * ct,
                                          const FlatVolumeOptions &    options = {},
                                          const DeviceUse &            use = {});

/** The device for rendering as requested by `use`; all devices produce the same bytes. Throws DeviceError if the GPU is
 * requested but not usable. */
ShapetonColonViews_EXPORT DeviceUse
ChooseFlatVolumeDevice(const itk::Image<float, 3> * ct, Device wanted);

/** Averages `factor` x `factor` pixels in linear light, to antialias a strip painted on a correspondingly finer
 * grid. */
ShapetonColonViews_EXPORT Picture::Pointer
ReduceStrip(const Picture * strip, unsigned int factor, unsigned int width, unsigned int height);
///@}
} // namespace shapeton

#endif
