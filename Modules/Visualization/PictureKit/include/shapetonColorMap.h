#ifndef shapetonColorMap_h
#define shapetonColorMap_h

#include "shapetonPicture.h"

#include <optional>
#include <string>

namespace shapeton
{
/** The colour of a place on the heat axis: `position` 0 (least heat) is blue, then cyan, green, yellow, orange, and 1
 * (most heat) is red, as in the dissertation's figures. Values outside [0, 1] are clamped.
 *
 * Equal steps of the position are equal steps in CIELAB (about 3 % of the way from blue to red, delta E 9.6, for each
 * of 32 steps), so that no step looks like an edge and similar heats look similar. The lightness L* rises from 42 to 84
 * at position 0.69 and falls to 51 at red: it is always well above a dark background, but it does not order the heats
 * by itself; the hue does. \ingroup PictureKit */
PictureKit_EXPORT RGBColor
HeatColor(double position);

/** The colour of a class, counted from 1: classes have no order here but are to be told apart, also by the
 * colour-blind.
 *
 * Any two of the first 8 are at least 39 apart in CIELAB (CIE 1976), of the 12 at least 27, as seen with normal, deutan
 * and protan sight. They are no greys and stand off black. After 12 they begin again.
 * \ingroup PictureKit */
PictureKit_EXPORT RGBColor
ClassColor(unsigned int label);

/** The colour of a name ("red", "steelblue", ... see ColorNames()) in any case, or of "#rrggbb"; empty for any other
 * text. \ingroup PictureKit */
PictureKit_EXPORT std::optional<RGBColor>
                  ColorOf(const std::string & text);

/** The names that ColorOf() knows, separated by ", ".
 * \ingroup PictureKit */
PictureKit_EXPORT std::string
                  ColorNames();

/** "#rrggbb".
 * \ingroup PictureKit */
PictureKit_EXPORT std::string
                  HexOf(const RGBColor & color);
} // namespace shapeton

#endif
