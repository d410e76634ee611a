#ifndef shapetonAlignedColons_h
#define shapetonAlignedColons_h

#include "shapetonFlatColonStrip.h"
#include "shapetonRegistrationPictures.h"

#include <functional>

namespace shapeton
{
/** A map file as a function on its flat map. The surface and the grid must outlive it. */
class MapOfSurface
{
public:
  /** \param circumference circumference of the other flat map, mm. */
  MapOfSurface(const SurfaceMesh & surface, const FlatColonGrid & grid, double circumference);

  /** Value of the map at a pixel of the grid. */
  struct Place
  {
    /** mm of the other flat map, v in [0, circumference); NaN where there is no wall. */
    Eigen::Vector2d uv;
    double          confidence{ 0.0 };
    bool            isExcluded{ true };
  };
  Place
  AtPixel(int column, int row) const;
  /** Value at the pixel that contains a position. */
  Place
  At(const Eigen::Vector2d & uv) const;

private:
  const FlatColonGrid & m_Grid;
  const SurfaceArray &  m_Uv;
  const SurfaceArray &  m_Confidence;
  const SurfaceArray &  m_Excluded;
  double                m_Circumference;
};

/** Paints a wall with one pixel per grid sample. */
using StripPainter = std::function<Picture::Pointer(const FlatColonGrid &, const FlatColonAxis &)>;

/** \class AlignedColons
 * \brief Both flat walls in the supine frame. The parts must outlive it. */
class AlignedColons
{
public:
  AlignedColons(const RegistrationParts & parts, int pixelsAround);

  /** Grid of the strips, on the supine wall. */
  const FlatColonGrid &
  Grid() const
  {
    return m_Grid;
  }
  /** Distance of each column along the supine centerline, mm. */
  const std::vector<double> &
  Distances() const
  {
    return m_Distances;
  }
  /** The supine wall. */
  Picture::Pointer
  PaintSupine(const StripPainter & paint) const;
  /** The prone wall as mapped into the supine frame; gray elsewhere. */
  Picture::Pointer
  PaintProne(const StripPainter & paint) const;
  /** Hatches the excluded sections. */
  void
  Hatch(Picture * strip) const;
  /** Maps a position of the prone flat map to the supine one. */
  Eigen::Vector2d
  InSupineFrame(const Eigen::Vector2d & proneUv) const;

private:
  Picture::Pointer
  Reduced(const Picture * fine) const;

  RegistrationParts     m_Parts;
  const FlatColonGrid & m_Grid;
  const FlatColonGrid & m_Fine; ///< grid of the supine wall, which is painted
  const FlatColonAxis & m_FineAxis;
  const FlatColonGrid & m_Prone; ///< grid of the prone wall, of the same resolution
  const FlatColonAxis & m_ProneAxis;
  std::vector<double>   m_Distances;
};
} // namespace shapeton

#endif
