#ifndef shapetonVtkXml_h
#define shapetonVtkXml_h

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace shapeton
{
/** An element of a VTK XML file; its text content starts at `text`. */
struct VtkXmlElement
{
  std::string                        name;
  std::map<std::string, std::string> attributes;
  std::size_t                        text{ 0 };
  std::vector<VtkXmlElement>         children;

  /** Empty if the attribute does not exist. */
  std::string
  Get(const std::string & attribute) const;
  /** nullptr if not found. */
  const VtkXmlElement *
  Find(const std::string & child) const;
};

/** \class VtkXml
 * \brief Elements of a VTK XML file and values of its arrays: text, base64 and appended, raw and compressed.
 *
 * https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html. Validates all values, unlike VTK's own
 * reader (9.1), which leaves values undefined where base64 data break off, ignores surplus values, and rejects array
 * names with "&", which VTK's writer does not escape. Throws InputError.
 */
class VtkXml
{
public:
  VtkXml(const std::string & bytes, const std::string & path);
  ~VtkXml();

  const VtkXmlElement &
  Root() const
  {
    return m_Root;
  }

  /** The values of a DataArray. */
  std::vector<double>
  Values(const VtkXmlElement & array) const;
  /** Strings of an Array of type String. */
  std::vector<std::string>
  Strings(const VtkXmlElement & array) const;
  /** A nonnegative integer that is plausible for the file length. */
  std::size_t
  Number(const VtkXmlElement & element, const std::string & attribute) const;
  /** Whether the value type is neither Float32 nor Float64. */
  static bool
  AreIntegers(const VtkXmlElement & array);

  [[noreturn]] void
  Refuse(const std::string & fault) const;

private:
  VtkXmlElement
  ParseElement(std::size_t & place, int depth);
  void
  ParseAttributes(VtkXmlElement & element, std::size_t & place) const;
  bool
  SkipToTag(std::size_t & place) const;
  std::string
  BytesOf(const VtkXmlElement & array) const;
  std::string
  Take(std::size_t & place, std::size_t size, bool isRaw) const;
  std::string
  Decompressed(std::size_t place, bool isRaw) const;
  std::uint64_t
  IntegerOf(const std::string & header, std::size_t index) const;

  const std::string & m_Bytes;
  std::string         m_Path;
  VtkXmlElement       m_Root;
  std::string         m_Compressor;
  std::size_t         m_SizeOfHeader{ 4 };
  bool                m_IsBigEndian{ false };
  bool                m_IsRaw{ false };
  std::size_t         m_Appended{ std::string::npos }; ///< first byte of the appended data
};
} // namespace shapeton

#endif
