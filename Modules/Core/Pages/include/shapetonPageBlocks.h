#ifndef shapetonPageBlocks_h
#define shapetonPageBlocks_h

#include "ShapetonPagesExport.h"
#include "shapetonOutputPath.h"
#include "shapetonJson.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** JSON without markup characters, safe inside a script element.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT std::string
                     ScriptText(const Json & value);

/** \class PageBlocks
 * \brief Arrays as scripts that a file:// page can load: block(name, {header}, "base64 of gzip").
 *
 * A file:// page may load scripts from its folder, but may not fetch files. Values are stored as differences from the
 * value `delta` positions before, modulo 2^n, which compresses better. A long block is split into parts, "name.1" and
 * so on; its header states their number. A single page embeds the scripts.
 *
 * \ingroup ShapetonPages */
class ShapetonPages_EXPORT PageBlocks
{
public:
  PageBlocks(std::string folder, bool isSingle, OutputPath outputPath);

  template <typename TValue>
  void
  Put(const std::string &         name,
      const std::vector<TValue> & values,
      std::size_t                 delta = 0,
      Json                        header = Json::object());
  /** Quantizes rows of `columns` reals, stored one after the other, to 16- or 32-bit integers between the minimum and
   * the maximum of their column; non-finite values become the minimum. */
  template <typename TValue = std::uint16_t>
  void
  PutReals(const std::string & name, const std::vector<double> & values, std::size_t columns);
  /** Overload for a row-major Eigen matrix. */
  template <typename TValue = std::uint16_t, typename TMatrix>
  void
  PutReals(const std::string & name, const TMatrix & rows)
  {
    static_assert(TMatrix::IsRowMajor);
    this->PutReals<TValue>(
      name, std::vector<double>(rows.data(), rows.data() + rows.size()), static_cast<std::size_t>(rows.cols()));
  }
  void
  PutJson(const std::string & name, const Json & value);

  /** The script elements of a single page; empty otherwise. */
  std::string
  Inline() const;
  /** The blocks of a single page as one script, for a file that changes while the page is open. */
  std::string
  Script() const;

private:
  void
  PutBytes(const std::string & name, Json header, const std::string & bytes);
  void
  PutScript(const std::string & name, const std::string & script);

  std::string m_Folder;
  bool        m_IsSingle;
  OutputPath  m_OutputPath;

  std::vector<std::string> m_Scripts; // scripts of a single page
};
} // namespace shapeton

#endif
