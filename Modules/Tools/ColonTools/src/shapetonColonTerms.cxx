#include "shapetonColonTerms.h"

#include <array>
#include <map>

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

const DicomCode &
CodeOfCategory(const std::string & category)
{
  static const std::map<std::string, DicomCode> codes{
    { "C0", { "112240", "DCM", "C0 - Inadequate Study/Awaiting Prior Comparisons" } },
    { "C1", { "112241", "DCM", "C1 - Normal Colon or Benign Lesion" } },
    { "C2", { "112242", "DCM", "C2 - Intermediate Polyp or Indeterminate Finding" } },
    { "C2a", { "CRADS-C2A", "99SHAPETON", "C2a - Intermediate Polyp or Indeterminate Finding" } },
    { "C2b", { "CRADS-C2B", "99SHAPETON", "C2b - Likely Benign Diverticular Finding" } },
    { "C3", { "112243", "DCM", "C3 - Polyp, Possibly Advanced Adenoma" } },
    { "C4", { "112244", "DCM", "C4 - Colonic Mass, Likely Malignant" } },
    { "E0", { "CRADS-E0", "99SHAPETON", "E0 - Limited Examination" } },
    { "E1", { "CRADS-E1", "99SHAPETON", "E1 - Normal Examination or Anatomic Variant" } },
    { "E2", { "CRADS-E2", "99SHAPETON", "E2 - Clinically Unimportant Finding" } },
    { "E1/E2", { "CRADS-E1E2", "99SHAPETON", "E1/E2 - Normal or Clinically Unimportant Finding" } },
    { "E3", { "CRADS-E3", "99SHAPETON", "E3 - Likely Unimportant, Incompletely Characterized" } },
    { "E4", { "CRADS-E4", "99SHAPETON", "E4 - Potentially Important Finding" } }
  };
  return codes.at(category);
}
} // namespace colonterms
} // namespace shapeton
