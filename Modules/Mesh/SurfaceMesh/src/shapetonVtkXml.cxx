#include "shapetonVtkXml.h"
#include "shapetonPrintable.h"
#include "shapetonBinaryValues.h"
#include "shapetonSurfaceFormats.h"

#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <charconv>

namespace shapeton
{
namespace
{
constexpr std::size_t  BestCompression = 10000; // lzma
constexpr int          DeepestElement = 50;     // levels; chosen, bounds the recursion for malformed files
constexpr const char * Blanks = " \t\r\n";

std::string
Unescaped(std::string text)
{
  static const std::pair<const char *, const char *> entities[] = {
    { "&lt;", "<" }, { "&gt;", ">" }, { "&quot;", "\"" }, { "&apos;", "'" }, { "&amp;", "&" }
  };
  for (const auto & [code, character] : entities)
  {
    const std::string from = code;
    for (std::size_t i = text.find(from); i != std::string::npos; i = text.find(from, i + 1))
    {
      text.replace(i, from.size(), character);
    }
  }
  return text;
}

vtkSmartPointer<vtkDataCompressor>
CompressorOf(const std::string & name)
{
  if (name == "vtkZLibDataCompressor")
  {
    return vtkSmartPointer<vtkZLibDataCompressor>::New();
  }
  if (name == "vtkLZ4DataCompressor")
  {
    return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  }
  if (name == "vtkLZMADataCompressor")
  {
    return vtkSmartPointer<vtkLZMADataCompressor>::New();
  }
  return nullptr;
}

/** Suppresses VTK messages on stderr. */
class SilentVTK
{
public:
  SilentVTK() : m_Before(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
  ~SilentVTK() { vtkObject::SetGlobalWarningDisplay(m_Before); }
  SilentVTK(const SilentVTK &) = delete;
  SilentVTK &
  operator=(const SilentVTK &) = delete;

private:
  int m_Before;
};
} // namespace

std::string
VtkXmlElement::Get(const std::string & attribute) const
{
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? "" : found->second;
}

const VtkXmlElement *
VtkXmlElement::Find(const std::string & child) const
{
  const auto found = std::find_if(children.begin(), children.end(), [&](const auto & c) { return c.name == child; });
  return found == children.end() ? nullptr : &*found;
}

VtkXml::VtkXml(const std::string & bytes, const std::string & path) : m_Bytes(bytes), m_Path(path)
{
  std::size_t place = 0;
  if (!this->SkipToTag(place))
  {
    this->Refuse("not a VTP file");
  }
  m_Root = this->ParseElement(place, 0);
  m_SizeOfHeader = m_Root.Get("header_type") == "UInt64" ? 8 : 4;
  m_IsBigEndian = m_Root.Get("byte_order") == "BigEndian";
  m_Compressor = m_Root.Get("compressor");
  if (!m_Compressor.empty() && !CompressorOf(m_Compressor))
  {
    this->Refuse("its compression " + m_Compressor.substr(0, LongestExcerpt) + " is unknown");
  }
}

VtkXml::~VtkXml() = default;

void
VtkXml::Refuse(const std::string & fault) const
{
  RefuseSurface(m_Path, fault, "copy or write the file again");
}

// Skip declarations and comments up to the next tag.
bool
VtkXml::SkipToTag(std::size_t & place) const
{
  for (;;)
  {
    place = m_Bytes.find('<', place);
    if (place == std::string::npos || place + 1 == m_Bytes.size())
    {
      return false;
    }
    if (m_Bytes[place + 1] != '?' && m_Bytes[place + 1] != '!')
    {
      return true;
    }
    const bool isComment = m_Bytes.compare(place, 4, "<!--") == 0;
    place = isComment ? m_Bytes.find("-->", place) : m_Bytes.find('>', place);
  }
}

void
VtkXml::ParseAttributes(VtkXmlElement & element, std::size_t & place) const
{
  for (;;)
  {
    place = m_Bytes.find_first_not_of(Blanks, place);
    if (place == std::string::npos)
    {
      this->Refuse("truncated: it ends within a tag");
    }
    if (m_Bytes[place] == '>' || m_Bytes[place] == '/')
    {
      return;
    }
    const std::size_t equals = m_Bytes.find('=', place);
    const std::size_t open = equals == std::string::npos ? equals : m_Bytes.find_first_not_of(Blanks, equals + 1);
    const bool        isQuoted = open != std::string::npos && (m_Bytes[open] == '"' || m_Bytes[open] == '\'');
    const std::size_t close = isQuoted ? m_Bytes.find(m_Bytes[open], open + 1) : std::string::npos;
    if (close == std::string::npos)
    {
      this->Refuse("invalid XML in a tag of <" + element.name.substr(0, LongestExcerpt) + ">");
    }
    const std::size_t nameEnd = std::min(m_Bytes.find_first_of(Blanks, place), equals);
    element.attributes[m_Bytes.substr(place, nameEnd - place)] = Unescaped(m_Bytes.substr(open + 1, close - open - 1));
    place = close + 1;
  }
}

VtkXmlElement
VtkXml::ParseElement(std::size_t & place, int depth)
{
  VtkXmlElement     element;
  const std::size_t nameEnd = m_Bytes.find_first_of(" \t\r\n/>", place + 1);
  if (nameEnd == std::string::npos || depth > DeepestElement)
  {
    this->Refuse("not a VTP file, or truncated");
  }
  element.name = m_Bytes.substr(place + 1, nameEnd - place - 1);
  place = nameEnd;
  this->ParseAttributes(element, place);
  if (m_Bytes[place] == '/')
  {
    element.text = place = std::min(m_Bytes.find('>', place), m_Bytes.size());
    return element;
  }
  element.text = ++place;
  if (element.name == "AppendedData") // the rest of the file, which may be binary
  {
    m_IsRaw = element.Get("encoding") == "raw";
    m_Appended = std::min(m_Bytes.find('_', place), m_Bytes.size() - 1) + 1;
    place = m_Bytes.size();
    return element;
  }
  while (this->SkipToTag(place))
  {
    if (m_Bytes[place + 1] == '/')
    {
      if (m_Bytes.compare(place + 2, element.name.size(), element.name) != 0)
      {
        this->Refuse("invalid XML: <" + element.name.substr(0, LongestExcerpt) + "> is not closed");
      }
      ++place;
      return element;
    }
    element.children.push_back(this->ParseElement(place, depth + 1));
    if (place >= m_Bytes.size() && m_Appended != std::string::npos)
    {
      return element;
    }
  }
  this->Refuse("truncated: <" + element.name.substr(0, LongestExcerpt) + "> is not closed");
}

std::size_t
VtkXml::Number(const VtkXmlElement & element, const std::string & attribute) const
{
  const std::string text = element.Get(attribute);
  std::size_t       number = 0;
  const auto        result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() || number > BestCompression * m_Bytes.size())
  {
    this->Refuse(attribute + "=\"" + text.substr(0, LongestExcerpt) + "\" of <" + element.name +
                 "> is not a valid number for this file");
  }
  return number;
}

bool
VtkXml::AreIntegers(const VtkXmlElement & array)
{
  constexpr std::string_view real = "Float";
  return array.Get("type").compare(0, real.size(), real) != 0;
}

std::uint64_t
VtkXml::IntegerOf(const std::string & header, std::size_t index) const
{
  return m_SizeOfHeader == 8 ? ValueAt<std::uint64_t>(header, 8 * index, m_IsBigEndian)
                             : ValueAt<std::uint32_t>(header, 4 * index, m_IsBigEndian);
}

// Returns the given number of bytes at `place` and advances it.
std::string
VtkXml::Take(std::size_t & place, std::size_t size, bool isRaw) const
{
  std::string bytes;
  if (!isRaw)
  {
    const std::size_t length = (size + 2) / 3 * 4;
    if (place <= m_Bytes.size() && length <= m_Bytes.size() - place)
    {
      bytes = DecodeBase64(m_Bytes, place, length);
      bytes.resize(std::min(bytes.size(), size));
      place += length;
    }
  }
  else if (place <= m_Bytes.size() && size <= m_Bytes.size() - place)
  {
    bytes = m_Bytes.substr(place, size);
    place += size;
  }
  if (bytes.size() != size)
  {
    this->Refuse("truncated: an array ends before its last value");
  }
  return bytes;
}

// Header: number of blocks, block size, size of the last block (0 if full), compressed size of each block.
std::string
VtkXml::Decompressed(std::size_t place, bool isRaw) const
{
  std::size_t         again = place;
  const std::uint64_t blocks = this->IntegerOf(this->Take(again, m_SizeOfHeader, isRaw), 0);
  if (blocks > m_Bytes.size())
  {
    this->Refuse("an array declares more blocks than the file can contain");
  }
  if (blocks == 0)
  {
    return {};
  }
  const std::string header = this->Take(place, (3 + static_cast<std::size_t>(blocks)) * m_SizeOfHeader, isRaw);
  std::size_t       compressed = 0;
  for (std::size_t b = 0; b < blocks; ++b)
  {
    compressed += std::min<std::uint64_t>(this->IntegerOf(header, 3 + b), m_Bytes.size() + 1);
  }
  const std::string   data = this->Take(place, std::min(compressed, m_Bytes.size()), isRaw);
  const std::uint64_t last = this->IntegerOf(header, 2);
  const auto          compressor = CompressorOf(m_Compressor);
  const SilentVTK     silent;
  std::string         bytes;
  std::size_t         begin = 0;
  for (std::size_t b = 0; b < blocks; ++b)
  {
    const std::uint64_t from = this->IntegerOf(header, 3 + b);
    const std::uint64_t to = b + 1 == blocks && last ? last : this->IntegerOf(header, 1);
    if (from > data.size() - begin || to > BestCompression * from)
    {
      this->Refuse("the sizes of a compressed array are wrong");
    }
    std::string block(static_cast<std::size_t>(to), '\0');
    if (compressor->Uncompress(reinterpret_cast<const unsigned char *>(data.data()) + begin,
                               static_cast<std::size_t>(from),
                               reinterpret_cast<unsigned char *>(block.data()),
                               block.size()) != block.size())
    {
      this->Refuse("a compressed array is damaged");
    }
    bytes += block;
    begin += static_cast<std::size_t>(from);
  }
  return bytes;
}

std::string
VtkXml::BytesOf(const VtkXmlElement & array) const
{
  const bool  isAppended = array.Get("format") == "appended";
  std::size_t place = std::min(m_Bytes.find_first_not_of(Blanks, array.text), m_Bytes.size());
  if (isAppended)
  {
    if (m_Appended == std::string::npos)
    {
      this->Refuse("its appended data are missing");
    }
    place = m_Appended + this->Number(array, "offset");
  }
  const bool isRaw = isAppended && m_IsRaw;
  if (!m_Compressor.empty())
  {
    return this->Decompressed(place, isRaw);
  }
  std::size_t         again = place;
  const std::uint64_t size = this->IntegerOf(this->Take(again, m_SizeOfHeader, isRaw), 0);
  if (size > m_Bytes.size())
  {
    this->Refuse("an array declares more bytes than the file contains");
  }
  return this->Take(place, m_SizeOfHeader + static_cast<std::size_t>(size), isRaw).substr(m_SizeOfHeader);
}

static std::vector<double>
ValuesOfText(const std::string & text, std::size_t begin, const VtkXml & xml)
{
  std::vector<double> values;
  const std::size_t   end = std::min(text.find('<', begin), text.size());
  for (std::size_t i = text.find_first_not_of(Blanks, begin); i < end; i = text.find_first_not_of(Blanks, i))
  {
    double     value = 0.0;
    const auto result = std::from_chars(text.data() + i, text.data() + end, value);
    if (result.ec == std::errc::invalid_argument)
    {
      xml.Refuse("\"" + text.substr(i, std::min<std::size_t>(text.find_first_of(" \t\r\n<", i) - i, LongestExcerpt)) +
                 "\" is not a number");
    }
    values.push_back(value);
    i = static_cast<std::size_t>(result.ptr - text.data());
  }
  return values;
}

std::vector<double>
VtkXml::Values(const VtkXmlElement & array) const
{
  if (array.Get("format") == "ascii")
  {
    return ValuesOfText(m_Bytes, array.text, *this);
  }
  static const std::map<std::string, BinaryType> types{
    { "Int8", BinaryTypeOf<std::int8_t>() },   { "UInt8", BinaryTypeOf<std::uint8_t>() },
    { "Int16", BinaryTypeOf<std::int16_t>() }, { "UInt16", BinaryTypeOf<std::uint16_t>() },
    { "Int32", BinaryTypeOf<std::int32_t>() }, { "UInt32", BinaryTypeOf<std::uint32_t>() },
    { "Int64", BinaryTypeOf<std::int64_t>() }, { "UInt64", BinaryTypeOf<std::uint64_t>() },
    { "Float32", BinaryTypeOf<float>() },      { "Float64", BinaryTypeOf<double>() }
  };
  const auto type = types.find(array.Get("type"));
  if (type == types.end())
  {
    this->Refuse("an array has the unknown type \"" + array.Get("type").substr(0, LongestExcerpt) + "\"");
  }
  const std::string   bytes = this->BytesOf(array);
  std::vector<double> values(bytes.size() / type->second.size);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = type->second.valueAt(bytes, i * type->second.size, m_IsBigEndian);
  }
  return values;
}

std::vector<std::string>
VtkXml::Strings(const VtkXmlElement & array) const
{
  std::string bytes;
  if (array.Get("format") == "ascii")
  {
    constexpr double values = 256.0; // of a byte
    for (const double value : ValuesOfText(m_Bytes, array.text, *this))
    {
      bytes += value >= 0.0 && value < values ? static_cast<char>(static_cast<unsigned char>(value)) : '?';
    }
  }
  else
  {
    bytes = this->BytesOf(array);
  }
  std::vector<std::string> strings;
  for (std::size_t begin = 0; begin < bytes.size();)
  {
    const std::size_t end = std::min(bytes.find('\0', begin), bytes.size());
    strings.push_back(bytes.substr(begin, end - begin));
    begin = end + 1;
  }
  return strings;
}
} // namespace shapeton
