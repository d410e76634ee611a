#include "shapetonSvgPanel.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace shapeton
{
namespace
{
std::string
Attributes(const SvgStyle & style)
{
  std::string text = " fill=\"" + (style.fill.empty() ? "none" : style.fill) + '"';
  if (!style.stroke.empty())
  {
    text += " stroke=\"" + style.stroke + "\" stroke-width=\"" + SvgNumber(style.width) + '"';
  }
  if (style.opacity < 1.0)
  {
    text += " opacity=\"" + SvgNumber(style.opacity) + '"';
  }
  return text + (style.isDashed ? " stroke-dasharray=\"5 4\"" : "");
}

std::string
Pair(const Pixel & pixel)
{
  return SvgNumber(pixel.x) + ' ' + SvgNumber(pixel.y);
}

double
Distance(const Pixel & p, const Pixel & q)
{
  return std::hypot(p.x - q.x, p.y - q.y);
}

struct FlatCircle
{
  Pixel  center;
  double radius;
};

/** Circle through three points; a huge one if they are collinear. */
FlatCircle
CircleThrough(const Pixel & a, const Pixel & b, const Pixel & c)
{
  const double bx = b.x - a.x;
  const double by = b.y - a.y;
  const double cx = c.x - a.x;
  const double cy = c.y - a.y;
  const double d = 2.0 * (bx * cy - by * cx);
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const Pixel  center{ a.x + (cy * b2 - by * c2) / d, a.y + (bx * c2 - cx * b2) / d };
  return { center, Distance(center, a) };
}
} // namespace

std::string
SvgNumber(double value)
{
  char       text[64];
  const auto end =
    std::to_chars(text, text + sizeof(text), std::round(value * 100.0) / 100.0, std::chars_format::fixed, 2).ptr;
  std::string number(text, end);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.')
  {
    number.pop_back();
  }
  return number == "-0" ? "0" : number;
}

std::string
SvgText(const std::string & text)
{
  std::string safe;
  for (const char c : text)
  {
    switch (c)
    {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default: // control characters are not allowed in XML
        safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return safe;
}

std::string
SvgLabel(double x, double y, const char * anchor, int size, const std::string & text)
{
  return "<text x=\"" + SvgNumber(x) + "\" y=\"" + SvgNumber(y) + "\" font-size=\"" + std::to_string(size) +
         "\" font-family=\"sans-serif\" text-anchor=\"" + anchor + "\">" + SvgText(text) + "</text>\n";
}

std::string
SvgDocument(double width, double height, const std::string & content)
{
  const std::string w = SvgNumber(width);
  const std::string h = SvgNumber(height);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w +
         "\" height=\"" + h + "\" viewBox=\"0 0 " + w + ' ' + h +
         "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + content + "</svg>\n";
}

SvgPanel::SvgPanel(const ModelSpace &    space,
                   const PictureMap &    picture,
                   const PictureWindow & window,
                   int                   size,
                   double                least)
  : m_Space(space), m_Picture(picture), m_Window(window), m_Size(size), m_Least(least)
{}

/** Size limit; larger for repeated copies, which need less detail. */
double
SvgPanel::LeastOf(const Motion & motion) const
{
  return motion.a == 1.0 && motion.b == 0.0 ? m_Least : std::max(1.0, m_Least);
}

Pixel
SvgPanel::ToPixel(const Place & place) const
{
  const Pixel  flat = m_Picture.map(place);
  const double scale = 0.5 * m_Size / m_Window.halfWidth;
  return { 0.5 * m_Size + scale * (flat.x - m_Window.center.x), 0.5 * m_Size + scale * (flat.y - m_Window.center.y) };
}

bool
SvgPanel::IsNear(const Pixel & pixel, double margin) const
{
  return pixel.x > -margin && pixel.y > -margin && pixel.x < m_Size + margin && pixel.y < m_Size + margin;
}

/** "M x y L x y ..." with as many points as the curvature requires; `goesOn` omits the first point. */
std::string
SvgPanel::PathOfSegment(const Place & from, const Place & to, bool goesOn) const
{
  constexpr double most = 64.0;
  const Pixel      start = this->ToPixel(from);
  const Pixel      end = this->ToPixel(to);
  const Pixel      middle = m_Picture.isStraight ? start : this->ToPixel(m_Space.Between(from, to, 0.5));
  const double     bend =
    m_Picture.isStraight ? 0.0 : Distance(middle, { 0.5 * (start.x + end.x), 0.5 * (start.y + end.y) });
  const int pieces =
    static_cast<int>(std::min(most, std::max(1.0, std::ceil(std::sqrt(bend / 0.05))))); // at most 0.05 pixels off
  std::string path = goesOn ? "" : 'M' + Pair(start);
  for (int i = 1; i <= pieces; ++i)
  {
    path += 'L' + Pair(i == pieces ? end : this->ToPixel(m_Space.Between(from, to, i / static_cast<double>(pieces))));
  }
  return path;
}

/** Clips the hidden part of a geodesic; returns false if the geodesic is hidden. */
bool
SvgPanel::Shorten(Place & from, Place & to) const
{
  const bool isFromSeen = m_Picture.isVisible(from);
  if (isFromSeen == m_Picture.isVisible(to))
  {
    return isFromSeen;
  }
  Place &   hidden = isFromSeen ? to : from;
  Place     seen = isFromSeen ? from : to;
  const int halvings = 30;
  for (int i = 0; i < halvings; ++i)
  {
    const Place middle = m_Space.Between(seen, hidden, 0.5);
    (m_Picture.isVisible(middle) ? seen : hidden) = middle;
  }
  hidden = seen;
  return true;
}

void
SvgPanel::AddSegments(const std::vector<EmbeddedGraph::Segment> & segments,
                      const std::vector<Motion> &                 motions,
                      const SvgStyle &                            style)
{
  constexpr std::size_t longest = 1000000; // bytes of a path; some readers refuse attributes of 10 MB
  std::string           path;
  const auto            write = [&] {
    m_Content += path.empty() ? "" : "<path d=\"" + path + '"' + Attributes(style) + "/>\n";
    path.clear();
  };
  for (const Motion & motion : motions)
  {
    for (const auto & segment : segments)
    {
      Place       from = m_Space.Moved(motion, segment[0]);
      Place       to = m_Space.Moved(motion, segment[1]);
      const bool  isThere = this->Shorten(from, to);
      const Pixel start = this->ToPixel(from);
      const Pixel end = this->ToPixel(to);
      const bool  isSeen = isThere && (IsNear(start, 0.2 * m_Size) || IsNear(end, 0.2 * m_Size));
      if (isSeen && Distance(start, end) >= LeastOf(motion))
      {
        path += this->PathOfSegment(from, to, false);
        if (path.size() > longest)
        {
          write();
        }
      }
      else if (isSeen && motion.a == 1.0 && motion.b == 0.0)
      {
        ++m_LeftOut;
      }
    }
  }
  write();
}

double
SvgPanel::PixelsOf(const Place & center, double radius, const Motion & motion) const
{
  const Place place = m_Space.Moved(motion, center);
  return Distance(this->ToPixel(place), this->ToPixel(m_Space.Circle(place, radius, 4)[0]));
}

void
SvgPanel::AddCircle(const Place & center, double radius, const Motion & motion, const SvgStyle & style)
{
  const Place place = m_Space.Moved(motion, center);
  if (!m_Picture.keepsCircles)
  {
    this->AddOutline(place, radius, style);
    return;
  }
  const std::vector<Place> points = m_Space.Circle(place, radius, 3);
  const FlatCircle circle = CircleThrough(this->ToPixel(points[0]), this->ToPixel(points[1]), this->ToPixel(points[2]));
  const double     margin = circle.radius;
  constexpr double most = 1e5; // practically a line
  if (!(circle.radius >= LeastOf(motion) && circle.radius < most) || !IsNear(circle.center, margin))
  {
    return;
  }
  const std::string x = SvgNumber(circle.center.x);
  const std::string y = SvgNumber(circle.center.y);
  const std::string r = SvgNumber(circle.radius);
  if (Distance(this->ToPixel(place), circle.center) < circle.radius)
  {
    m_Content += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"" + r + '"' + Attributes(style) + "/>\n";
    return;
  }
  // The center is hidden, so the inside of the circle is the outside of its image in the plane.
  const std::string size = SvgNumber(m_Size);
  const std::string arc = 'A' + r + ' ' + r + " 0 0 0 ";
  m_Content += "<path fill-rule=\"evenodd\" d=\"M-9 -9H" + size + "9V" + size + "9H-9ZM" +
               Pair({ circle.center.x - circle.radius, circle.center.y }) + arc +
               Pair({ circle.center.x + circle.radius, circle.center.y }) + arc +
               Pair({ circle.center.x - circle.radius, circle.center.y }) + "Z\"" + Attributes(style) + "/>\n";
}

/** Continues from the last visible point of a cap's circle along the rim, as far as it is inside the cap. */
std::string
SvgPanel::PathAlongRim(const Place & center, double radius, const Pixel & end) const
{
  const std::size_t number = m_Picture.rim.size();
  const double      least = std::cos(radius);
  const auto        isInside = [&](std::size_t i) { return Dot(m_Picture.rim[i % number], center) > least; };
  std::size_t       start = 0;
  while (start < number && (isInside(start + number - 1) || !isInside(start)))
  {
    ++start;
  }
  std::vector<Pixel> pixels;
  for (std::size_t i = start; start < number && i < start + number && isInside(i); ++i)
  {
    pixels.push_back(this->ToPixel(m_Picture.rim[i % number]));
  }
  if (!pixels.empty() && Distance(end, pixels.back()) < Distance(end, pixels.front()))
  {
    std::reverse(pixels.begin(), pixels.end());
  }
  std::string path;
  for (const Pixel & pixel : pixels)
  {
    path += 'L' + Pair(pixel);
  }
  return path;
}

/** Visible part of a circle that is not a circle in the picture, as a polygon; closed along the rim where hidden. */
void
SvgPanel::AddOutline(const Place & center, double radius, const SvgStyle & style)
{
  const double size = this->PixelsOf(center, radius, {});
  if (size < m_Least || !IsNear(this->ToPixel(center), 2.0 * size + 2.0))
  {
    return;
  }
  const auto               number = static_cast<std::size_t>(std::clamp(8.0 * std::sqrt(size), 8.0, 160.0));
  const std::vector<Place> points = m_Space.Circle(center, radius, static_cast<int>(number));
  const auto               isSeen = [&](std::size_t i) { return m_Picture.isVisible(points[i % number]); };
  std::size_t              start = 0; // the first point after a hidden one, if any
  while (start < number && (isSeen(start + number - 1) || !isSeen(start)))
  {
    ++start;
  }
  const bool  isWhole = start == number && isSeen(0);
  std::string path;
  Pixel       end;
  for (std::size_t i = start; (isWhole || start < number) && i < start + number && isSeen(i); ++i)
  {
    end = this->ToPixel(points[i % number]);
    path += (path.empty() ? 'M' : 'L') + Pair(end);
  }
  if (!path.empty())
  {
    path += isWhole ? std::string() : this->PathAlongRim(center, radius, end);
    m_Content += "<path d=\"" + path + "Z\"" + Attributes(style) + "/>\n";
  }
}

void
SvgPanel::AddDot(const Place & place, const Motion & motion, double radius, const std::string & color)
{
  const Place moved = m_Space.Moved(motion, place);
  const Pixel pixel = this->ToPixel(moved);
  if (m_Picture.isVisible(moved) && IsNear(pixel, radius) && radius >= LeastOf(motion))
  {
    m_Content += "<circle cx=\"" + SvgNumber(pixel.x) + "\" cy=\"" + SvgNumber(pixel.y) + "\" r=\"" +
                 SvgNumber(radius) + "\" fill=\"" + color + "\"/>\n";
  }
}

void
SvgPanel::AddPolygon(const std::vector<Place> & corners, const Motion & motion, const SvgStyle & style)
{
  const double       least = 2.0 * LeastOf(motion); // closer corners are merged
  std::vector<Place> kept;
  bool               isSeen = false;
  for (const Place & corner : corners)
  {
    const Place place = m_Space.Moved(motion, corner);
    isSeen = isSeen || IsNear(this->ToPixel(place), 0.0);
    if (kept.empty() || Distance(this->ToPixel(kept.back()), this->ToPixel(place)) >= least)
    {
      kept.push_back(place);
    }
  }
  std::string path;
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    path += this->PathOfSegment(kept[i], kept[(i + 1) % kept.size()], i > 0);
  }
  if (isSeen && kept.size() > 2)
  {
    m_Content += "<path d=\"" + path + "Z\"" + Attributes(style) + "/>\n";
  }
}

bool
SvgPanel::AddLabel(const Place & center, const Place & rim, const std::string & text)
{
  constexpr double largest = 20.0;
  constexpr double smallest = 6.0;
  constexpr double widthOfLetter = 0.55; // relative to the font size
  if (!m_Picture.isVisible(center))
  {
    return true;
  }
  const Pixel  pixel = this->ToPixel(center);
  const Pixel  end = this->ToPixel(rim);
  const auto   letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  const double room = 2.2 * std::hypot(end.x - pixel.x, end.y - pixel.y) / widthOfLetter;
  const double size = std::min(largest, room / static_cast<double>(std::max<std::ptrdiff_t>(letters, 1)));
  if (size < smallest)
  {
    return false;
  }
  m_Content += "<text x=\"" + SvgNumber(pixel.x) + "\" y=\"" + SvgNumber(pixel.y + size / 3.0) + "\" font-size=\"" +
               SvgNumber(size) +
               "\" text-anchor=\"middle\" font-family=\"sans-serif\" paint-order=\"stroke\" stroke=\"#ffffff\" "
               "stroke-width=\"3\">" +
               SvgText(text) + "</text>\n";
  return true;
}

void
SvgPanel::AddTitle(const std::vector<std::string> & lines)
{
  constexpr std::size_t lineHeight = 18;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    m_Content += "<text x=\"6\" y=\"" + std::to_string(lineHeight * (i + 1)) +
                 "\" font-size=\"14\" font-family=\"sans-serif\" paint-order=\"stroke\" stroke=\"#ffffff\""
                 " stroke-width=\"4\">" +
                 SvgText(lines[i]) + "</text>\n";
  }
}

void
SvgPanel::AddRim(const Pixel & center, double radius, const SvgStyle & style)
{
  const double scale = 0.5 * m_Size / m_Window.halfWidth;
  m_Content += "<circle cx=\"" + SvgNumber(0.5 * m_Size + scale * (center.x - m_Window.center.x)) + "\" cy=\"" +
               SvgNumber(0.5 * m_Size + scale * (center.y - m_Window.center.y)) + "\" r=\"" +
               SvgNumber(scale * radius) + '"' + Attributes(style) + "/>\n";
}
} // namespace shapeton
