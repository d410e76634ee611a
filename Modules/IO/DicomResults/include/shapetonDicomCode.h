#ifndef shapetonDicomCode_h
#define shapetonDicomCode_h

#include <string>

namespace shapeton
{
/** A coded term: value, scheme (SCT for SNOMED CT, DCM, LN, UCUM, or a private one that begins with 99), meaning.
 * \ingroup ShapetonDicomResults */
struct DicomCode
{
  std::string value;
  std::string scheme;
  std::string meaning;

  bool
  operator==(const DicomCode & other) const
  {
    return value == other.value && scheme == other.scheme;
  }
};
} // namespace shapeton

#endif
