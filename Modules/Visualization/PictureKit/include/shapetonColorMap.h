#ifndef shapetonColorMap_h
#define shapetonColorMap_h

#include "shapetonPicture.h"

#include <optional>
#include <string>

namespace shapeton
{
/** Color of a position on the heat axis: `position` 0 (lowest heat) is blue, then cyan, green, yellow, orange, and 1
 * (highest heat) is red, as in the dissertation's figures. Values outside [0, 1] are clamped.
 *
 * Equal position steps are equal steps in CIELAB (each of 32 steps has a delta E of 9.6, about 3 % of the way from blue
 * to red), so no step looks like an edge and similar heat values look similar. The lightness L* rises from 42 to 84 at
 * position 0.69 and falls to 51 at red. It contrasts with a dark background everywhere, but only the hue is monotonic
 * in heat. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT RGBColor
HeatColor(double position);

/** Color of a class, counted from 1. Classes are unordered; the colors are distinguishable, also for color-blind
 * readers.
 *
 * Any two of the first 8 colors are at least 39 apart in CIELAB (CIE 1976), and any two of all 12 at least 27, for
 * normal, deutan and protan vision. No color is gray. All are at least 48 from white and 57 from black, for deutan and
 * protan vision 13 from white, so draw a border around them on white, and 39 from black. Colors repeat after 12.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT RGBColor
ClassColor(unsigned int label);

/** The color of a case-insensitive name ("red", "steelblue", ... see ColorNames()) or of "#rrggbb"; empty for any other
 * text. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::optional<RGBColor>
                          ColorOf(const std::string & text);

/** Names accepted by ColorOf(), separated by ", ".
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::string
                          ColorNames();

/** The color as "#rrggbb".
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::string
                          HexOf(const RGBColor & color);
} // namespace shapeton

#endif
