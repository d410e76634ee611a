#ifndef shapetonColonFigures_h
#define shapetonColonFigures_h

#include "shapetonHtmlReport.h"
#include "shapetonPicture.h"

#include "itkImageBase.h"

#include <Eigen/Core>

#include <string>

namespace shapeton
{
/** \defgroup ColonFigures Figures on pages
 * One way to print each quantity, so that all pages agree. Empty text for a value that is not finite.
 * \ingroup ShapetonColonTools */
///@{

/** A distance along the colon: "62.3 cm". \param mm rounded to whole mm. */
std::string
Centimeters(double mm);
/** The same without its unit. */
std::string
NumberOfCentimeters(double mm);
/** A size: "11 mm". */
std::string
WholeMillimeters(double mm);
/** An area in cm^2 with one decimal: "1.7". */
std::string
SquareCentimeters(double squareMm);
/** "97 %". A part is never rounded to all or nothing: "> 99 %", "< 1 %". */
std::string
WholePercent(double share);
/** A probability with two digits: "0.93"; never rounded to 0 or 1: "< 0.01", "> 0.99". */
std::string
ProbabilityInWords(double probability);
/** A volume: "947 ml", "0.4 ml". */
std::string
Milliliters(double ml);
/** The slice at a place (LPS, mm), counted from 1 along the third axis of the image. */
long
SliceNumber(const itk::ImageBase<3> * grid, const Eigen::Vector3d & place);

/** "Slices are counted from 1 at the feet." */
std::string
SliceOrderInWords(const itk::ImageBase<3> * grid);
/** End of a link that opens the viewer at a place (LPS, mm): "#lps=-175,-125,100". */
std::string
AnchorOfPlace(const Eigen::Vector3d & place);
/** A number without decimals. */
std::string
WholeNumber(double value);
/** Texts in a list. */
std::string
Joined(const std::vector<std::string> & texts, const char * separator);
/** The names and values, excluding those with an empty value. */
std::vector<std::pair<std::string, std::string>>
KnownFacts(std::vector<std::pair<std::string, std::string>> facts);
/** Draws pictures in parallel, writes them as files and embeds them with their captions. Throws OutputError. */
void
AddPictures(HtmlReport & html, const std::vector<PictureFile> & pictures);
///@}
} // namespace shapeton

#endif
