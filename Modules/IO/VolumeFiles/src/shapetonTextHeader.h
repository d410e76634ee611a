#ifndef shapetonTextHeader_h
#define shapetonTextHeader_h

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** The text header of a NRRD or MetaImage file. */
struct TextHeader
{
  std::vector<std::string> lines;
  /** Bytes up to the end of the last line. */
  std::uint64_t bytes{ 0 };
  bool          isComplete{ false };

  /** The first value of a key in lower case; empty if the header lacks it. */
  std::string
  ValueOf(const std::string & key, char separator) const;

  /** The lines between the first one of this key and an empty one. */
  std::vector<std::string>
  LinesAfter(const std::string & key, char separator) const;
};

TextHeader
ReadNrrdHeader(const std::string & path);

/** Ends with ElementDataFile, or with the list of files after it. */
TextHeader
ReadMetaHeader(const std::string & path);
} // namespace shapeton

#endif
