#ifndef shapetonDicomItem_h
#define shapetonDicomItem_h

#include "shapetonDicomCode.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <string>
#include <vector>

namespace shapeton
{
/** \class DicomItem
 * \brief A data set or a sequence item, written attribute by attribute; throws OutputError. */
class DicomItem
{
public:
  explicit DicomItem(DcmItem & item) : m_Item(&item) {}

  /** An empty string creates an attribute without a value. */
  DicomItem &
  Text(const DcmTagKey & tag, const std::string & value);
  DicomItem &
  Decimals(const DcmTagKey & tag, const std::vector<double> & values);
  /** 16 or 32 bits, depending on the attribute. */
  DicomItem &
  Integers(const DcmTagKey & tag, const std::vector<Uint32> & values);
  /** For 16-bit attributes whose signedness depends on other attributes. */
  DicomItem &
  Word(const DcmTagKey & tag, Uint16 value);
  DicomItem &
  Floats(const DcmTagKey & tag, const std::vector<float> & values);
  DicomItem &
  Double(const DcmTagKey & tag, double value);
  /** Padded to an even number. */
  DicomItem &
  Bytes(const DcmTagKey & tag, std::vector<Uint8> values);
  DicomItem &
  Tag(const DcmTagKey & tag, const DcmTagKey & value);
  /** Appends an item with this code to a sequence. */
  DicomItem &
  Code(const DcmTagKey & sequence, const DicomCode & code);
  /** Adds an empty sequence. */
  DicomItem &
  NoItems(const DcmTagKey & sequence);
  /** Appends an item to a sequence, which is created if it does not exist. */
  DicomItem
  Add(const DcmTagKey & sequence);

private:
  DicomItem &
  Check(const OFCondition & condition, const DcmTagKey & tag);

  DcmItem * m_Item;
};
} // namespace shapeton

#endif
