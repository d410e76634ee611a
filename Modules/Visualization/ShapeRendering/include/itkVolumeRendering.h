#ifndef itkVolumeRendering_h
#define itkVolumeRendering_h

#include "ShapeRenderingExport.h"

#include "itkImage.h"
#include "itkPicture.h"
#include "itkShapeTransferFunction.h"

#include <optional>

namespace itk
{
/** How a volume is looked at.
 * \ingroup ShapeRendering */
struct VolumeRenderingOptions
{
  /** Degrees about the patient's long axis: 0 from the front (anterior; the patient's left is on the right of the
   * picture), 90 from the patient's left, 180 from the back, -90 from the right. */
  double azimuth{ 0.0 };
  /** Degrees, -90 to 90: positive from above (the head). */
  double elevation{ 0.0 };
  /** Pixels. */
  unsigned int width{ 800 };
  unsigned int height{ 600 };
  /** The part of the volume that fills the picture; by default all of it. The rest is seen where there is room. */
  std::optional<ImageRegion<3>> focus;
  /** 1 shows the whole focus from any side; larger values enlarge its centre. */
  double zoom{ 1.0 };
  /** Orientation letters at the borders and a scale bar. */
  bool annotations{ true };
};

/** \class PatientView
 * \brief A parallel projection of patient space (LPS, mm) onto the pixels of a picture.
 *
 * The centre of the focus lies in the centre of the picture; all lengths have one scale.
 *
 * \ingroup ShapeRendering
 */
class ShapeRendering_EXPORT PatientView
{
public:
  using PointType = ImageBase<3>::PointType;
  using VectorType = Vector<double, 3>;

  /** Throws std::invalid_argument for an elevation beyond 90 degrees, a zoom that is not positive, or no pixels. */
  PatientView(const ImageBase<3> * volume, const VolumeRenderingOptions & options);

  /** The place in the picture, in pixels (x to the right, y downwards), of a physical point. */
  Point<double, 2>
  Project(const PointType & point) const;

  /** The point of the picture plane (through the centre of the focus) that is seen in pixel (x, y). */
  PointType
  PointOfPixel(double x, double y) const;

  const VectorType &
  GetRight() const
  {
    return m_Right;
  }
  const VectorType &
  GetUp() const
  {
    return m_Up;
  }
  /** From the viewer into the picture. */
  const VectorType &
  GetForward() const
  {
    return m_Forward;
  }
  double
  GetMillimetresPerPixel() const
  {
    return m_MillimetresPerPixel;
  }

private:
  PointType  m_Center;
  VectorType m_Right;
  VectorType m_Up;
  VectorType m_Forward;
  double     m_MillimetresPerPixel{ 1.0 };
  double     m_MiddleX{ 0.0 };
  double     m_MiddleY{ 0.0 };
};

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
 * \ingroup ShapeRendering */
ShapeRendering_EXPORT Picture::Pointer
                      RenderVolume(const Image<float, 3> *        heat,
                                   const ShapeTransferFunction &  transferFunction,
                                   const VolumeRenderingOptions & options = {});

/** The smallest region that holds all voxels with a line of the transfer function; empty where there is none.
 * \ingroup ShapeRendering */
ShapeRendering_EXPORT std::optional<ImageRegion<3>>
                      VisibleRegion(const Image<float, 3> * heat, const ShapeTransferFunction & transferFunction);
} // namespace itk

#endif
