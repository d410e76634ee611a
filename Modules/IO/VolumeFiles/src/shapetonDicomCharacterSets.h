#ifndef shapetonDicomCharacterSets_h
#define shapetonDicomCharacterSets_h

#include <string>
#include <vector>

class DcmItem;

namespace shapeton
{
/** The Specific Character Set values of an item or its closest parent. "ISO_IR 100" and "ISO 2022 IR
 * 100" become "100", other terms ("GB18030") are unchanged; empty for ASCII only. */
std::vector<std::string>
CharacterSetsOf(DcmItem & item);

/** Converts text from these character sets to UTF-8; returns false and leaves it unchanged if its bytes are invalid in
 * them. */
bool
DecodeDicomText(const std::vector<std::string> & sets, std::string & text);
} // namespace shapeton

#endif
