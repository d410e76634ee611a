#ifndef shapetonPatientView_h
#define shapetonPatientView_h

#include "ShapetonPictureKitExport.h"

#include "itkImageBase.h"

#include <string>

namespace shapeton
{
/** Options of a parallel projection of a patient.
 * \ingroup ShapetonPictureKit */
struct PatientViewOptions
{
  /** Degrees around the patient's long axis: 0 from the front (anterior; the patient's left is on the right of the
   * picture), 90 from the patient's left, 180 from the back, -90 from the right. */
  double azimuth{ 0.0 };
  /** Degrees, -90 to 90: positive from above (the head). */
  double elevation{ 0.0 };
  /** Pixels. */
  unsigned int width{ 800 };
  unsigned int height{ 600 };
  /** 1 shows the whole focus from any side; larger values enlarge its center. */
  double zoom{ 1.0 };
};

/** The sides of a patient. \ingroup ShapetonPictureKit */
enum class PatientSide
{
  Anterior,
  Left,
  Posterior,
  Right,
  Superior,
  Inferior
};

/** Sets azimuth and elevation for a view from this side. From below, the patient's front is on top, as in axial slices;
 * from above, the back is. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
LookFrom(PatientSide side, PatientViewOptions & options);

/** "anterior", "left", ... \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::string
                          NameOf(PatientSide side);

/** \class PatientView
 * \brief A parallel projection of patient space (LPS, mm) onto the pixels of a picture.
 *
 * The center of the focus is at the center of the picture; the scale is isotropic.
 *
 * \ingroup ShapetonPictureKit
 */
class ShapetonPictureKit_EXPORT PatientView
{
public:
  using PointType = itk::ImageBase<3>::PointType;
  using VectorType = itk::Vector<double, 3>;

  /** Throws std::invalid_argument for an elevation beyond 90 degrees, a nonpositive zoom, or an empty picture. */
  PatientView(const itk::ImageBase<3> * volume, const itk::ImageRegion<3> & focus, const PatientViewOptions & options);

  /** Shows these distances (mm) on each side of the center, along GetRight() and GetUp(). Throws the same
   * exceptions. */
  PatientView(const PointType & center, double halfWidth, double halfHeight, const PatientViewOptions & options);

  /** Picture position, in pixels (x to the right, y downwards), of a physical point. */
  itk::Point<double, 2>
  Project(const PointType & point) const;

  /** Point of the picture plane (through the center of the focus) at pixel (x, y). */
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
  /** View direction, from the viewer into the picture. */
  const VectorType &
  GetForward() const
  {
    return m_Forward;
  }
  double
  GetMillimetersPerPixel() const
  {
    return m_MillimetersPerPixel;
  }
  /** Center of the picture, in pixels, and the point shown there. */
  double
  GetMiddleX() const
  {
    return m_MiddleX;
  }
  double
  GetMiddleY() const
  {
    return m_MiddleY;
  }
  const PointType &
  GetCenter() const
  {
    return m_Center;
  }

private:
  void
  TurnTo(const PatientViewOptions & options);

  void
  FitTo(double halfWidth, double halfHeight, const PatientViewOptions & options);

  PointType  m_Center;
  VectorType m_Right;
  VectorType m_Up;
  VectorType m_Forward;
  double     m_MillimetersPerPixel{ 1.0 };
  double     m_MiddleX{ 0.0 };
  double     m_MiddleY{ 0.0 };
};

} // namespace shapeton

#endif
