#ifndef shapetonDicomCharacterSets_h
#define shapetonDicomCharacterSets_h

#include <string>
#include <vector>

class DcmItem;

namespace shapeton
{
/** The values of Specific Character Set that hold for an item: its own, else those of the items around it. "ISO_IR 100"
 * and "ISO 2022 IR 100" are "100", other terms ("GB18030") stay; empty for ASCII alone. */
std::vector<std::string>
CharacterSetsOf(DcmItem & item);

/** Converts a text from these sets to UTF-8; returns false and leaves it where its bytes are not valid in them. */
bool
DecodeDicomText(const std::vector<std::string> & sets, std::string & text);
} // namespace shapeton

#endif
