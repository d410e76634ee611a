#include "shapetonGrowthPlot.h"

#include "shapetonFileBytes.h"
#include "shapetonSvgPanel.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
// Pixels.
constexpr double PanelWidth = 380.0;
constexpr double PanelHeight = 260.0;
constexpr double Left = 52.0;
constexpr double Right = 16.0;
constexpr double Top = 30.0;
constexpr double Bottom = 44.0;
constexpr double LabelGap = 6.0;
constexpr double LetterDrop = 4.0;
constexpr double DotRadius = 3.0;
constexpr int    fontSize = 12;

std::string
Line(const Pixel & from, const Pixel & to)
{
  return "<path d=\"M" + SvgNumber(from.x) + ' ' + SvgNumber(from.y) + 'L' + SvgNumber(to.x) + ' ' + SvgNumber(to.y) +
         "\" fill=\"none\" stroke=\"#dddddd\"/>\n";
}

/** 1, 2, 5, 10, ... up to `most`. */
std::vector<double>
DecadeTicks(double most)
{
  std::vector<double> ticks;
  for (double decade = 1.0; decade <= most; decade *= 10.0)
  {
    for (const double factor : { 1.0, 2.0, 5.0 })
    {
      if (factor * decade <= most)
      {
        ticks.push_back(factor * decade);
      }
    }
  }
  return ticks;
}

/** Step of about five ticks: 1, 2 or 5 times a power of ten. */
double
StepOf(double most)
{
  constexpr double ticks = 5.0, base = 10.0;
  const double     decade = std::pow(base, std::floor(std::log10(most / ticks)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (most / (factor * decade) <= ticks)
    {
      return factor * decade;
    }
  }
  return base * decade;
}

class GrowthPanel
{
public:
  GrowthPanel(const GrowthCurve & curve, double offset) : m_Curve(curve), m_Offset(offset)
  {
    constexpr double room = 1.05; // above the largest value
    m_MostRadius = std::max(2.0, curve.radii.empty() ? 0.0 : curve.radii.back());
    m_Most = 0.0;
    for (const double value : curve.quantities)
    {
      m_Most = std::max(m_Most, std::isfinite(value) ? room * value : 0.0);
    }
    m_Most = m_Most > 0.0 ? m_Most : 1.0;
  }

  std::string
  Markup() const
  {
    std::string text = SvgLabel(m_Offset + Left, Top - 2.0 * LabelGap, "start", fontSize, m_Curve.title);
    for (const double radius : DecadeTicks(m_MostRadius))
    {
      const Pixel foot = this->At(radius, 0.0);
      text += Line(foot, this->At(radius, m_Most)) +
              SvgLabel(foot.x, foot.y + 3.0 * LabelGap, "middle", fontSize, SvgNumber(radius));
    }
    const double step = StepOf(m_Most);
    for (int i = 0; i * step <= m_Most; ++i)
    {
      const Pixel start = this->At(1.0, i * step);
      text += Line(start, this->At(m_MostRadius, i * step)) +
              SvgLabel(start.x - LabelGap, start.y + LetterDrop, "end", fontSize, SvgNumber(i * step));
    }
    text += SvgLabel(m_Offset + 0.5 * (Left + PanelWidth - Right),
                     PanelHeight - LabelGap,
                     "middle",
                     fontSize,
                     "radius of the ball (edges)");
    std::string path;
    std::string dots;
    for (std::size_t i = 0; i < m_Curve.radii.size(); ++i)
    {
      if (std::isfinite(m_Curve.quantities[i]))
      {
        const Pixel p = this->At(m_Curve.radii[i], m_Curve.quantities[i]);
        path += (path.empty() ? 'M' : 'L') + SvgNumber(p.x) + ' ' + SvgNumber(p.y);
        dots += "<circle cx=\"" + SvgNumber(p.x) + "\" cy=\"" + SvgNumber(p.y) + "\" r=\"" + SvgNumber(DotRadius) +
                "\" fill=\"#0072b2\"/>\n";
      }
    }
    return text + (path.empty() ? "" : "<path d=\"" + path + "\" fill=\"none\" stroke=\"#0072b2\"/>\n") + dots;
  }

private:
  Pixel
  At(double radius, double quantity) const
  {
    const double x = std::log(radius) / std::log(m_MostRadius);
    return { m_Offset + Left + x * (PanelWidth - Left - Right),
             PanelHeight - Bottom - quantity / m_Most * (PanelHeight - Top - Bottom) };
  }

  const GrowthCurve & m_Curve;
  double              m_Offset;
  double              m_MostRadius;
  double              m_Most;
};
} // namespace

void
WriteGrowthSvg(const std::vector<GrowthCurve> & curves, const std::string & path)
{
  std::string text;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    text += GrowthPanel(curves[i], PanelWidth * static_cast<double>(i)).Markup();
  }
  WriteFileBytes(path, SvgDocument(PanelWidth * static_cast<double>(curves.size()), PanelHeight, text));
}
} // namespace shapeton
