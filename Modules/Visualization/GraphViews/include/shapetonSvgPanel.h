#ifndef shapetonSvgPanel_h
#define shapetonSvgPanel_h

#include "shapetonEmbeddedGraph.h"

#include <functional>
#include <string>

namespace shapeton
{
/** A point of a picture: x to the right, y downwards. */
struct Pixel
{
  double x{ 0.0 };
  double y{ 0.0 };
};

/** From points of a geometry to the plane of a picture. */
struct PictureMap
{
  std::function<Pixel(const Place &)> map;
  /** False for what lies behind. */
  std::function<bool(const Place &)> isVisible;
  /** Circles stay circles. */
  bool keepsCircles{ true };
  /** Geodesics become straight. */
  bool isStraight{ false };
  /** Points of the rim between what is seen and what lies behind, counter-clockwise; empty where all is seen. */
  std::vector<Place> rim;
};

/** A rectangle of the plane of a picture. */
struct PictureWindow
{
  Pixel  centre;
  double halfWidth{ 1.0 };
};

/** How a line or an area is drawn; empty colours leave it out. */
struct SvgStyle
{
  std::string stroke;
  std::string fill;
  double      width{ 1.0 };
  double      opacity{ 1.0 };
  bool        isDashed{ false };
};

/** A number with at most two decimals, with a full stop, without trailing zeros. */
GraphViews_EXPORT std::string
                  SvgNumber(double value);

/** Text as it may stand in XML. */
GraphViews_EXPORT std::string
                  SvgText(const std::string & text);

/** The content of one panel of a picture, in pixels; what is outside of the panel or too small is left out. */
class GraphViews_EXPORT SvgPanel
{
public:
  /** `least`: pixels below which a thing that is shown once is left out. */
  SvgPanel(const ModelSpace & space, const PictureMap & picture, const PictureWindow & window, int size, double least);

  /** Geodesics, moved by each of the motions, as one path. */
  void
  AddSegments(const std::vector<EmbeddedGraph::Segment> & segments,
              const std::vector<Motion> &                 motions,
              const SvgStyle &                            style);

  void
  AddCircle(const Place & centre, double radius, const Motion & motion, const SvgStyle & style);

  /** A round mark of a size in pixels. */
  void
  AddDot(const Place & place, const Motion & motion, double radius, const std::string & color);

  /** An area between geodesics. */
  void
  AddPolygon(const std::vector<Place> & corners, const Motion & motion, const SvgStyle & style);

  /** A name of a size that suits the circle from its centre to its rim; false where that would be too small to read. */
  bool
  AddLabel(const Place & centre, const Place & rim, const std::string & text);

  void
  AddTitle(const std::vector<std::string> & lines);

  /** A circle or rectangle of the picture itself, such as the rim of the disk: centre and radius in its plane. */
  void
  AddRim(const Pixel & centre, double radius, const SvgStyle & style);

  /** The radius in pixels of a circle of the geometry about there; for sizes of dots. */
  double
  PixelsOf(const Place & centre, double radius, const Motion & motion) const;

  /** How many of the segments that the panel should show were too small. */
  std::size_t
  LeftOut() const
  {
    return m_LeftOut;
  }

  const std::string &
  Content() const
  {
    return m_Content;
  }

private:
  double
  LeastOf(const Motion & motion) const;
  Pixel
  ToPixel(const Place & place) const;
  bool
  IsNear(const Pixel & pixel, double margin) const;
  std::string
  PathOfSegment(const Place & from, const Place & to, bool goesOn) const;
  bool
  Shorten(Place & from, Place & to) const;
  std::string
  PathAlongRim(const Place & centre, double radius, const Pixel & end) const;
  void
  AddOutline(const Place & centre, double radius, const SvgStyle & style);

  const ModelSpace & m_Space;
  PictureMap         m_Picture;
  PictureWindow      m_Window;
  double             m_Size;
  double             m_Least;
  std::size_t        m_LeftOut{ 0 };
  std::string        m_Content;
};
} // namespace shapeton

#endif
