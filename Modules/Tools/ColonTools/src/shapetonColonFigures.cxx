#include "shapetonColonFigures.h"

#include <charconv>
#include <cmath>

namespace shapeton
{
namespace
{
/** With a fixed number of decimals; "" if not finite. */
std::string
Fixed(double value, int decimals)
{
  char text[64]; // more than a rounded volume or length needs
  if (!std::isfinite(value))
  {
    return "";
  }
  const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed, decimals);
  return end.ec == std::errc() ? std::string(text, end.ptr) : "";
}

std::string
WithUnit(const std::string & number, const char * unit)
{
  return number.empty() ? "" : number + unit;
}
} // namespace

std::string
NumberOfCentimeters(double mm)
{
  constexpr double millimetersPerCm = 10.0;
  return Fixed(std::round(mm) / millimetersPerCm, 1);
}

std::string
Centimeters(double mm)
{
  return WithUnit(NumberOfCentimeters(mm), " cm");
}

std::string
SquareCentimeters(double squareMm)
{
  constexpr double squareMmPerCm = 100.0;
  return Fixed(squareMm / squareMmPerCm, 1);
}

std::string
WholeNumber(double value)
{
  return Fixed(std::round(value) + 0.0, 0); // no negative zero
}

std::string
WholeMillimeters(double mm)
{
  return WithUnit(WholeNumber(mm), " mm");
}

std::string
WholePercent(double share)
{
  constexpr double hundred = 100.0;
  const double     whole = std::round(hundred * share);
  return whole == hundred && share < 1.0 ? "> 99 %"
         : whole == 0.0 && share > 0.0   ? "< 1 %"
                                         : WithUnit(WholeNumber(hundred * share), " %");
}

std::string
ProbabilityInWords(double probability)
{
  constexpr double step = 0.01;
  return probability < step ? "< 0.01" : probability > 1.0 - step ? "> 0.99" : Fixed(probability, 2);
}

long
SliceNumber(const itk::ImageBase<3> * grid, const Eigen::Vector3d & place)
{
  const auto index = grid->TransformPhysicalPointToContinuousIndex<double>(itk::Point<double, 3>(place.data()));
  return std::lround(index[2]) + 1;
}

std::string
SliceOrderInWords(const itk::ImageBase<3> * grid)
{
  constexpr double leastCosine = 0.7; // the third axis of an axial series
  const double     upwards = grid->GetDirection()(2, 2);
  return std::abs(upwards) < leastCosine ? "Slices are counted from 1 along the third axis of the image."
         : upwards > 0.0                 ? "Slices are counted from 1 at the feet."
                                         : "Slices are counted from 1 at the head.";
}

std::string
AnchorOfPlace(const Eigen::Vector3d & place)
{
  return "#lps=" + WholeNumber(place.x()) + ',' + WholeNumber(place.y()) + ',' + WholeNumber(place.z());
}

std::string
Milliliters(double ml)
{
  constexpr double small = 10.0; // ml
  return WithUnit(Fixed(ml, std::abs(ml) < small ? 1 : 0), " ml");
}

std::string
Joined(const std::vector<std::string> & texts, const char * separator)
{
  std::string list;
  for (const std::string & text : texts)
  {
    list += (list.empty() ? "" : separator) + text;
  }
  return list;
}

std::vector<std::pair<std::string, std::string>>
KnownFacts(std::vector<std::pair<std::string, std::string>> facts)
{
  facts.erase(std::remove_if(facts.begin(), facts.end(), [](const auto & fact) { return fact.second.empty(); }),
              facts.end());
  return facts;
}

void
AddPictures(HtmlReport & html, const std::vector<PictureFile> & pictures)
{
  WritePngs(pictures);
  for (const PictureFile & picture : pictures)
  {
    html.AddPicture(picture.path, picture.caption);
  }
}
} // namespace shapeton
