#ifndef shapetonSliceView_h
#define shapetonSliceView_h

#include "ShapetonPictureKitExport.h"

#include "itkImage.h"
#include "shapetonPicture.h"
#include "shapetonSurfaceMesh.h"

#include <functional>
#include <optional>
#include <string>

namespace shapeton
{
/** Intensity window: lower is black, upper is white. The default means the 0.5 % and 99.5 % quantiles of the image.
 * \ingroup ShapetonPictureKit */
struct IntensityWindow
{
  double lower{ 0.0 };
  double upper{ 0.0 };
};

/** Anatomical planes of slices. \ingroup ShapetonPictureKit */
enum class SlicePlane
{
  Axial,
  Coronal,
  Sagittal
};

/** "axial", ... \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::string
                          NameOf(SlicePlane plane);

/** Volume axes of the picture of a slice, and whether they are flipped.
 * \ingroup ShapetonPictureKit */
struct SliceAxes
{
  unsigned int across{ 0 };
  unsigned int down{ 1 };
  unsigned int through{ 2 };
  bool         isAcrossReversed{ false };
  bool         isDownReversed{ false };
};

/** Radiological convention, as closely as the volume's own axes allow: axial with the patient's right at the left and
 * anterior on top; coronal with right at the left and the head on top; sagittal with anterior at the left and the head
 * on top. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT SliceAxes
AxesOf(const itk::ImageBase<3> * volume, SlicePlane plane);

/** \class SliceView
 * \brief Mapping between the voxels of a slice, or of a part of it, and its picture.
 *
 * A slice follows two of the volume's own axes; the picture has one scale in mm, independent of the spacing.
 *
 * \ingroup ShapetonPictureKit
 */
class ShapetonPictureKit_EXPORT SliceView
{
public:
  /** The voxels of `focus` fill the picture; `slice` is an index along the axis perpendicular to it. Throws
   * std::invalid_argument for a focus that is empty or outside the volume, a slice outside it, or a nonpositive scale.
   * The volume must outlive the view. */
  SliceView(const itk::ImageBase<3> *   volume,
            const itk::ImageRegion<3> & focus,
            SlicePlane                  plane,
            itk::IndexValueType         slice,
            double                      millimetersPerPixel);

  unsigned int
  GetWidth() const
  {
    return m_Width;
  }
  unsigned int
  GetHeight() const
  {
    return m_Height;
  }
  double
  GetMillimetersPerPixel() const
  {
    return m_MillimetersPerPixel;
  }
  const SliceAxes &
  GetAxes() const
  {
    return m_Axes;
  }
  itk::IndexValueType
  GetSlice() const
  {
    return m_Slice;
  }
  const itk::ImageRegion<3> &
  GetFocus() const
  {
    return m_Focus;
  }
  const itk::ImageBase<3> *
  GetVolume() const
  {
    return m_Volume;
  }

  /** Direction of a picture axis, in LPS. */
  itk::Vector<double, 3>
  GetRight() const;
  itk::Vector<double, 3>
  GetUp() const;

  /** Volume position of the center of a pixel, inside the focus. */
  itk::ContinuousIndex<double, 3>
  IndexOfPixel(int x, int y) const;

  /** Picture position, in pixels, of a volume position; positions off the slice are projected along the perpendicular
   * axis. */
  itk::Point<double, 2>
  PixelOf(const itk::ContinuousIndex<double, 3> & index) const;

private:
  const itk::ImageBase<3> * m_Volume;
  itk::ImageRegion<3>       m_Focus;
  SliceAxes                 m_Axes;
  itk::IndexValueType       m_Slice;
  double                    m_MillimetersPerPixel;
  unsigned int              m_Width;
  unsigned int              m_Height;
};

/** A slice in gray, linearly interpolated. \pre The image has the geometry of the view's volume.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT Picture::Pointer
PaintSlice(const SliceView & view, const itk::Image<float, 3> * gray, const IntensityWindow & window);

/** Blends colors over the pixels of voxels; an empty color leaves the picture unchanged. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
ColorSlice(Picture *                                                             picture,
           const SliceView &                                                     view,
           const std::function<std::optional<RGBColor>(const itk::Index<3> &)> & colorOf,
           double                                                                opacity);

/** Draws the border of a set of voxels, halfway between the centers of a voxel inside and one outside (marching
 * squares). Voxels outside the view's focus count as outside. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawMaskOutline(Picture *                                          picture,
                const SliceView &                                  view,
                const std::function<bool(const itk::Index<3> &)> & isInside,
                const RGBColor &                                   color,
                double                                             thickness);

/** Draws the intersection of a slice with a surface. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawSurfaceCut(Picture *           picture,
               const SliceView &   view,
               const SurfaceMesh & surface,
               const RGBColor &    color,
               double              thickness);

/** Draws the orientation letters at the borders of a slice. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawSliceLetters(Picture * picture, const SliceView & view);
} // namespace shapeton

#endif
