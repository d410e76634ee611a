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

/** Projection from a geometry to the picture plane. */
struct PictureMap
{
  std::function<Pixel(const Place &)> map;
  /** False for hidden points. */
  std::function<bool(const Place &)> isVisible;
  /** Whether circles stay circles. */
  bool keepsCircles{ true };
  /** Whether geodesics are straight. */
  bool isStraight{ false };
  /** Points of the silhouette between visible and hidden parts, counterclockwise; empty if everything is visible. */
  std::vector<Place> rim;
};

/** A rectangle of the picture plane. */
struct PictureWindow
{
  Pixel  center;
  double halfWidth{ 1.0 };
};

/** Stroke and fill of a line or an area; an empty color disables it. */
struct SvgStyle
{
  std::string stroke;
  std::string fill;
  double      width{ 1.0 };
  double      opacity{ 1.0 };
  bool        isDashed{ false };
};

/** Formats a number with at most two decimals, a decimal point and no trailing zeros. */
ShapetonGraphViews_EXPORT std::string
                          SvgNumber(double value);

/** Escapes text for XML. */
ShapetonGraphViews_EXPORT std::string
                          SvgText(const std::string & text);

/** A text element of a font size in pixels at a position; `anchor` is start, middle or end. */
std::string
SvgLabel(double x, double y, const char * anchor, int size, const std::string & text);

/** An SVG file of this size in pixels with a white background. */
std::string
SvgDocument(double width, double height, const std::string & content);

/** Content of one panel, in pixels. Items outside the panel or too small are skipped. */
class ShapetonGraphViews_EXPORT SvgPanel
{
public:
  /** `least`: size in pixels below which a nonrepeated item is skipped. */
  SvgPanel(const ModelSpace & space, const PictureMap & picture, const PictureWindow & window, int size, double least);

  /** Draws geodesics, moved by each of the motions, as one path. */
  void
  AddSegments(const std::vector<EmbeddedGraph::Segment> & segments,
              const std::vector<Motion> &                 motions,
              const SvgStyle &                            style);

  void
  AddCircle(const Place & center, double radius, const Motion & motion, const SvgStyle & style);

  /** Draws a round mark with a size in pixels. */
  void
  AddDot(const Place & place, const Motion & motion, double radius, const std::string & color);

  /** Fills an area bounded by geodesics. */
  void
  AddPolygon(const std::vector<Place> & corners, const Motion & motion, const SvgStyle & style);

  /** Draws a label sized to the circle with this center and rim point; returns false if it would be unreadably
   * small. */
  bool
  AddLabel(const Place & center, const Place & rim, const std::string & text);

  void
  AddTitle(const std::vector<std::string> & lines);

  /** Draws a circle or rectangle in the picture plane, such as the rim of the disk. */
  void
  AddRim(const Pixel & center, double radius, const SvgStyle & style);

  /** Approximate radius in pixels of a circle of the geometry at this place; for dot sizes. */
  double
  PixelsOf(const Place & center, double radius, const Motion & motion) const;

  /** Number of segments skipped because they were too small. */
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
  PathAlongRim(const Place & center, double radius, const Pixel & end) const;
  void
  AddOutline(const Place & center, double radius, const SvgStyle & style);

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
