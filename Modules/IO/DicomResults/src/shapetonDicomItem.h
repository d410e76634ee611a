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
 * \brief A data set or an item of a sequence, written attribute by attribute; throws OutputError. */
class DicomItem
{
public:
  explicit DicomItem(DcmItem & item) : m_Item(&item) {}

  /** An empty text is an attribute without a value. */
  DicomItem &
  Text(const DcmTagKey & tag, const std::string & value);
  DicomItem &
  Decimals(const DcmTagKey & tag, const std::vector<double> & values);
  /** Of 16 or 32 bits, as the attribute has them. */
  DicomItem &
  Integers(const DcmTagKey & tag, const std::vector<Uint32> & values);
  DicomItem &
  Floats(const DcmTagKey & tag, const std::vector<float> & values);
  DicomItem &
  Double(const DcmTagKey & tag, double value);
  /** Made even in number. */
  DicomItem &
  Bytes(const DcmTagKey & tag, std::vector<Uint8> values);
  DicomItem &
  Tag(const DcmTagKey & tag, const DcmTagKey & value);
  /** A sequence with this code as one more item. */
  DicomItem &
  Code(const DcmTagKey & sequence, const DicomCode & code);
  /** A sequence without items. */
  DicomItem &
  NoItems(const DcmTagKey & sequence);
  /** One more item of a sequence, which is made where there is none. */
  DicomItem
  Add(const DcmTagKey & sequence);

private:
  DicomItem &
  Check(const OFCondition & condition, const DcmTagKey & tag);

  DcmItem * m_Item;
};
} // namespace shapeton

#endif
