#include "shapetonDicomItem.h"

#include "shapetonDicomText.h"
#include "shapetonExceptions.h"

namespace shapeton
{
DicomItem &
DicomItem::Check(const OFCondition & condition, const DcmTagKey & tag)
{
  if (condition.bad())
  {
    throw OutputError(std::string("cannot create the DICOM attribute ") + DcmTag(tag).getTagName() + ": " +
                      condition.text() + "; report this as a bug");
  }
  return *this;
}

DicomItem &
DicomItem::Text(const DcmTagKey & tag, const std::string & value)
{
  return this->Check(value.empty() ? m_Item->insertEmptyElement(tag) : m_Item->putAndInsertString(tag, value.c_str()),
                     tag);
}

DicomItem &
DicomItem::Decimals(const DcmTagKey & tag, const std::vector<double> & values)
{
  std::vector<std::string> texts;
  for (const double value : values)
  {
    texts.push_back(DicomDecimal(value));
  }
  return this->Text(tag, JoinDicomValues(texts));
}

DicomItem &
DicomItem::Integers(const DcmTagKey & tag, const std::vector<Uint32> & values)
{
  std::vector<std::string> texts;
  for (const Uint32 value : values)
  {
    texts.push_back(std::to_string(value));
  }
  return this->Text(tag, JoinDicomValues(texts));
}

DicomItem &
DicomItem::Word(const DcmTagKey & tag, Uint16 value)
{
  return this->Check(m_Item->putAndInsertUint16(tag, value), tag);
}

DicomItem &
DicomItem::Floats(const DcmTagKey & tag, const std::vector<float> & values)
{
  return this->Check(m_Item->putAndInsertFloat32Array(tag, values.data(), values.size()), tag);
}

DicomItem &
DicomItem::Double(const DcmTagKey & tag, double value)
{
  return this->Check(m_Item->putAndInsertFloat64(tag, value), tag);
}

DicomItem &
DicomItem::Bytes(const DcmTagKey & tag, std::vector<Uint8> values)
{
  values.resize(values.size() + values.size() % 2);
  return this->Check(m_Item->putAndInsertUint8Array(tag, values.data(), values.size()), tag);
}

DicomItem &
DicomItem::Tag(const DcmTagKey & tag, const DcmTagKey & value)
{
  return this->Check(m_Item->putAndInsertTagKey(tag, value), tag);
}

DicomItem &
DicomItem::Code(const DcmTagKey & sequence, const DicomCode & code)
{
  this->Add(sequence)
    .Text(DCM_CodeValue, code.value)
    .Text(DCM_CodingSchemeDesignator, code.scheme)
    .Text(DCM_CodeMeaning, code.meaning);
  return *this;
}

DicomItem &
DicomItem::NoItems(const DcmTagKey & sequence)
{
  return this->Check(m_Item->insertEmptyElement(sequence), sequence);
}

DicomItem
DicomItem::Add(const DcmTagKey & sequence)
{
  constexpr signed long append = -2;
  DcmItem *             item = nullptr;
  this->Check(m_Item->findOrCreateSequenceItem(sequence, item, append), sequence);
  return DicomItem(*item);
}
} // namespace shapeton
