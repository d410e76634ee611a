#ifndef shapetonVolumeRendering_h
#define shapetonVolumeRendering_h

#include "HeatViewsExport.h"

#include "itkImage.h"
#include "shapetonPatientView.h"
#include "shapetonPicture.h"
#include "shapetonShapeTransferFunction.h"

#include <optional>

namespace shapeton
{
/** How a volume is looked at.
 * \ingroup HeatViews */
struct VolumeRenderingOptions : PatientViewOptions
{
  /** The part of the volume that fills the picture; by default all of it. The rest is seen where there is room. */
  std::optional<itk::ImageRegion<3>> focus;
  /** Orientation letters at the borders and a scale bar. */
  bool annotations{ true };
};

/** The projection of a rendering with these options: the focus in the middle of the picture. \ingroup HeatViews */
HeatViews_EXPORT PatientView
ViewOfVolume(const itk::ImageBase<3> * volume, const VolumeRenderingOptions & options);

/** A picture of a heat volume with a shape-based transfer function (dissertation 2.5, Figures 2.6, 2.9 to 2.11).
 *
 * Direct volume rendering by ray casting on the CPU; needs neither a display nor a graphics driver. Each voxel is
 * classified by its own heat and colour and opacity are interpolated: heat is not, because between an object and the
 * background it would pass through the heats of all other objects and paint their colours around this one. Opacity is
 * for a path of one smallest spacing; of what is transparent little more than the surface is drawn, so that objects
 * inside others can be seen. Light comes from over the viewer's left shoulder. Origin, spacing and direction cosines
 * are respected. Equal input gives equal bytes for any number of threads; ITK's global default number is used.
 *
 * Throws std::invalid_argument for an empty volume and for wrong options (see PatientView).
 * \ingroup HeatViews */
HeatViews_EXPORT Picture::Pointer
                 RenderVolume(const itk::Image<float, 3> *   heat,
                              const ShapeTransferFunction &  transferFunction,
                              const VolumeRenderingOptions & options = {});

/** The smallest region that holds all voxels with a line of the transfer function; empty where there is none.
 * \ingroup HeatViews */
HeatViews_EXPORT std::optional<itk::ImageRegion<3>>
                 VisibleRegion(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
