#ifndef shapetonVolumeRendering_h
#define shapetonVolumeRendering_h

#include "ShapetonHeatViewsExport.h"

#include "itkImage.h"
#include "shapetonDevice.h"
#include "shapetonPatientView.h"
#include "shapetonPicture.h"
#include "shapetonShapeTransferFunction.h"

#include <memory>
#include <optional>

namespace shapeton
{
/** View of a volume rendering.
 * \ingroup ShapetonHeatViews */
struct VolumeRenderingOptions : PatientViewOptions
{
  /** Part of the volume that fills the picture; by default all of it. The rest is visible where space permits. */
  std::optional<itk::ImageRegion<3>> focus;
  /** Orientation letters at the borders and a scale bar. */
  bool annotations{ true };
};

/** Projection for these options, with the focus at the center of the picture. \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT PatientView
ViewOfVolume(const itk::ImageBase<3> * volume, const VolumeRenderingOptions & options);

/** \class VolumeRenderer
 * \brief Pictures of a heat volume with a shape-based transfer function (dissertation 2.5, Figures 2.6, 2.9 to 2.11).
 *
 * Direct volume rendering by ray casting, on the CPU or, with identical bytes, on a GPU; needs neither a display nor a
 * graphics driver. Each voxel is classified by its heat, and color and opacity are interpolated. Heat is not
 * interpolated, because between an object and the background it would pass through the heat values of all other objects
 * and surround the object with their colors. Opacity refers to a path of one smallest spacing. Transparent objects are
 * drawn mainly at their surface, so objects inside them are visible. The light is above the viewer's left shoulder.
 * Origin, spacing and direction cosines are respected. Identical input yields identical bytes for any number of
 * threads; ITK's global default number is used.
 *
 * \ingroup ShapetonHeatViews */
class ShapetonHeatViews_EXPORT VolumeRenderer
{
public:
  /** Throws std::invalid_argument for an empty volume, DeviceError if the device cannot be used. */
  VolumeRenderer(const itk::Image<float, 3> *  heat,
                 const ShapeTransferFunction & transferFunction,
                 Device                        device = Device::Automatic);
  ~VolumeRenderer();
  VolumeRenderer(const VolumeRenderer &) = delete;
  VolumeRenderer &
  operator=(const VolumeRenderer &) = delete;

  /** Throws std::invalid_argument for wrong options (see PatientView). */
  Picture::Pointer
  Render(const VolumeRenderingOptions & options = {}) const;

  /** Device that computes the pictures. */
  const DeviceUse &
  GetDeviceUse() const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_Impl;
};

/** One picture by a VolumeRenderer on the CPU.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT Picture::Pointer
                         RenderVolume(const itk::Image<float, 3> *   heat,
                                      const ShapeTransferFunction &  transferFunction,
                                      const VolumeRenderingOptions & options = {});

/** Smallest region that contains all voxels with a line of the transfer function; empty if there are none.
 * \ingroup ShapetonHeatViews */
ShapetonHeatViews_EXPORT std::optional<itk::ImageRegion<3>>
VisibleRegion(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);
} // namespace shapeton

#endif
