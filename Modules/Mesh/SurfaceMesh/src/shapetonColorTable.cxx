#include "shapetonColorTable.h"

#include "shapetonFileBytes.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr int greatestLabel = 32767; // limit of Slicer's reader

/** RGB color from hue (in turns), saturation and value. */
std::array<double, 3>
FromHsv(double hue, double saturation, double value)
{
  std::array<double, 3> color;
  for (int channel = 0; channel < 3; ++channel)
  {
    const double place = std::fmod(5.0 - 2.0 * channel + 6.0 * hue, 6.0);
    const double ramp = std::min({ place, 4.0 - place, 1.0 });
    color[channel] = value * (1.0 - saturation * std::max(ramp, 0.0));
  }
  return color;
}

void
Check(const LabelColor & label)
{
  if (label.value < 1 || label.value > greatestLabel)
  {
    throw std::invalid_argument("the label " + std::to_string(label.value) + " is not in 1 to 32767");
  }
  if (label.name.empty())
  {
    throw std::invalid_argument("the label " + std::to_string(label.value) + " has no name");
  }
  for (const double channel : label.color)
  {
    if (!(channel >= 0.0 && channel <= 1.0))
    {
      throw std::invalid_argument("a color of the label " + label.name + " is not in 0 to 1");
    }
  }
}

std::string
LineOf(const LabelColor & label)
{
  std::string line = std::to_string(label.value) + ' ';
  for (const char c : label.name)
  {
    line += static_cast<unsigned char>(c) <= ' ' ? '_' : c;
  }
  for (const double channel : label.color)
  {
    line += ' ' + std::to_string(std::lround(255.0 * channel));
  }
  return line + " 255\n";
}
} // namespace

std::array<double, 3>
ColorOfLabel(int label)
{
  constexpr double goldenAngle = 0.3819660112501051; // turns
  const double     turns = label * goldenAngle;
  constexpr double full = 0.85, pale = 0.55, dark = 0.75, bright = 0.95; // saturations and values
  return FromHsv(turns - std::floor(turns), label % 2 == 0 ? full : pale, label % 3 == 0 ? dark : bright);
}

void
WriteColorTable(const std::vector<LabelColor> & labels, const std::string & path)
{
  RequireParameter(std::filesystem::path(path).extension() == ".ctbl",
                   "\"" + path + "\" is not the name of a color table; use the extension .ctbl");
  std::string   text = "# Color table file\n# " + std::to_string(labels.size() + 1) + " values\n0 background 0 0 0 0\n";
  std::set<int> values;
  for (const LabelColor & label : labels)
  {
    Check(label);
    if (!values.insert(label.value).second)
    {
      throw std::invalid_argument("the label " + std::to_string(label.value) + " occurs twice");
    }
    text += LineOf(label);
  }
  WriteFileBytes(path, text);
}
} // namespace shapeton
