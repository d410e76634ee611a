#ifndef shapetonAlignedColons_h
#define shapetonAlignedColons_h

#include "shapetonFlatColonStrip.h"
#include "shapetonRegistrationPictures.h"

#include <functional>

namespace shapeton
{
/** A map file as a function on the flat map that it is written on. The surface and the grid must outlive it. */
class MapOfSurface
{
public:
  /** \param circumference of the other flat map, mm. */
  MapOfSurface(const SurfaceMesh & surface, const FlatColonGrid & grid, double circumference);

  /** What the map says at a pixel of the grid. */
  struct Place
  {
    /** mm of the other flat map, v in [0, circumference); not a number where there is no wall. */
    Eigen::Vector2d uv;
    double          confidence{ 0.0 };
    bool            isExcluded{ true };
  };
  Place
  AtPixel(int column, int row) const;
  /** Of the pixel that the place lies in. */
  Place
  At(const Eigen::Vector2d & uv) const;

private:
  const FlatColonGrid & m_Grid;
  const SurfaceArray &  m_Uv;
  const SurfaceArray &  m_Confidence;
  const SurfaceArray &  m_Excluded;
  double                m_Circumference;
};

/** Paints a wall, a pixel for each of the grid. */
using StripPainter = std::function<Picture::Pointer(const FlatColonGrid &, const FlatColonAxis &)>;

/** \class AlignedColons
 * \brief Both flat walls in the supine frame. The parts must outlive it. */
class AlignedColons
{
public:
  AlignedColons(const RegistrationParts & parts, int pixelsAround);

  /** Of the supine wall, of the strips. */
  const FlatColonGrid &
  Grid() const
  {
    return m_Grid;
  }
  /** mm along the supine centreline of each column. */
  const std::vector<double> &
  Distances() const
  {
    return m_Distances;
  }
  /** The supine wall. */
  Picture::Pointer
  PaintSupine(const StripPainter & paint) const;
  /** The prone wall where the map puts it; grey where there is none. */
  Picture::Pointer
  PaintProne(const StripPainter & paint) const;
  /** Stripes over what is excluded. */
  void
  Hatch(Picture * strip) const;
  /** A place of the prone flat map in the supine one. */
  Eigen::Vector2d
  InSupineFrame(const Eigen::Vector2d & proneUv) const;

private:
  Picture::Pointer
  Reduced(const Picture * fine) const;

  RegistrationParts     m_Parts;
  const FlatColonGrid & m_Grid;
  const FlatColonGrid & m_Fine; ///< of the supine wall, painted on
  const FlatColonAxis & m_FineAxis;
  const FlatColonGrid & m_Prone; ///< of the prone wall, as fine
  const FlatColonAxis & m_ProneAxis;
  std::vector<double>   m_Distances;
};
} // namespace shapeton

#endif
