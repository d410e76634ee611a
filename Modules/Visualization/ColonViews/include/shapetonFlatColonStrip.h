#ifndef shapetonFlatColonStrip_h
#define shapetonFlatColonStrip_h

#include "ColonViewsExport.h"

#include "shapetonDevice.h"
#include "shapetonFlatColonAxis.h"
#include "shapetonPictureAnnotation.h"

namespace shapeton
{
/** \defgroup FlatColonStrip Pictures of a whole flat colon, a pixel for each of its grid
 * What an eye on the axis of the tube sees that goes along the colon and looks at the wall beside it all around (filet
 * view): each pixel is lit in the frame of the smooth tube (FrameAt()), from the left, which is along u, and from
 * above. So folds are bands across with a bright and a dark side, whatever the bends of the colon. Pixels without a
 * face are grey. The axis must be that of the grid. Equal input gives equal bytes for any number of threads.
 * \ingroup ColonViews */
///@{

/** How a relief looks. */
struct FlatReliefOptions
{
  /** Folds are paler and pockets darker than the wall at its mean height; 0 for one colour, 1 is strong. */
  double heightContrast{ 0.4 };
};

/** The surface, lit, in the colours of mucosa. */
ColonViews_EXPORT Picture::Pointer
PaintFlatRelief(const FlatColonGrid & grid, const FlatColonAxis & axis, const FlatReliefOptions & options = {});

/** Blue where the wall bulges outwards, white, and orange to red where it bulges into the lumen. `limit`: 1/mm at the
 * ends. */
ColonViews_EXPORT ColorScale
CurvatureScale(double limit = 0.2);

/** The curvature of the grid (FlatColonGridOptions::curvatureLength averages it) in these colours; shading of this
 * strength, 0 to 1, tells the relief. */
ColonViews_EXPORT Picture::Pointer
                  PaintFlatCurvature(const FlatColonGrid & grid,
                                     const FlatColonAxis & axis,
                                     const ColorScale &    scale = CurvatureScale(),
                                     double                shading = 0.35);

/** How the CT is seen. Hounsfield units and mm. */
struct FlatVolumeOptions
{
  /** Opacity rises from none to full between these: the boundary of gas and wall. */
  double gas{ -750.0 };
  double tissue{ -250.0 };
  /** A ray starts so far inside of the surface, or at the tissue that is nearer. */
  double depthOfLumen{ 3.0 };
  /** It ends so far outside. */
  double depthOfWall{ 4.0 };
  /** Extinction of tissue, 1/mm: how deep one sees. */
  double extinction{ 2.5 };
};

/** Direct volume rendering (dissertation 5.5.1): a ray for each pixel, along the normal of the wall from the lumen
 * outwards, through the trilinear CT; colour by intensity (fat, soft tissue, contrast medium), light by its gradient.
 * The volume's origin, spacing and direction are respected. With a CT whose fluid was cleansed the wall below it is
 * seen, with another one the fluid's surface.
 *
 * Throws InputError where more than 5 % of the wall lie outside of the CT, ParameterError for options out of range. */
ColonViews_EXPORT Picture::Pointer
                  PaintFlatVolume(const FlatColonGrid &        grid,
                                  const FlatColonAxis &        axis,
                                  const itk::Image<float, 3> * ct,
                                  const FlatVolumeOptions &    options = {},
                                  const DeviceUse &            use = {});

/** Where to paint it: `use`, with which the picture is the same bytes. Throws DeviceError where the GPU is asked for
 * and cannot be used. */
ColonViews_EXPORT DeviceUse
ChooseFlatVolumeDevice(const itk::Image<float, 3> * ct, Device wanted);

/** The means of `factor` x `factor` pixels, in linear light: a strip painted on a grid with pixels so much smaller,
 * without jagged edges. */
ColonViews_EXPORT Picture::Pointer
                  ReduceStrip(const Picture * strip, unsigned int factor, unsigned int width, unsigned int height);
///@}
} // namespace shapeton

#endif
