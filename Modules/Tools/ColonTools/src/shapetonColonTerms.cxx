#include "shapetonColonTerms.h"

#include <array>

namespace shapeton
{
namespace colonterms
{
const DicomCode &
CodeOfSegment(int segment)
{
  static const std::array<DicomCode, 6> codes{ { { "34402009", "SCT", "Rectum" },
                                                 { "60184004", "SCT", "Sigmoid colon" },
                                                 { "32622004", "SCT", "Descending colon" },
                                                 { "485005", "SCT", "Transverse colon" },
                                                 { "9040008", "SCT", "Ascending colon" },
                                                 { "32713005", "SCT", "Cecum" } } };
  return segment >= 1 && segment <= 6 ? codes[static_cast<std::size_t>(segment - 1)] : colon;
}
} // namespace colonterms
} // namespace shapeton
