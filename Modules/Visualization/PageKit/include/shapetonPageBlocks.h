#ifndef shapetonPageBlocks_h
#define shapetonPageBlocks_h

#include "PageKitExport.h"
#include "shapetonHtmlReport.h"
#include "shapetonJson.h"
#include "shapetonSurfaceMesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** JSON that may stand within a script element: no character of markup.
 * \ingroup PageKit */
PageKit_EXPORT std::string
               ScriptText(const Json & value);

/** \class PageBlocks
 * \brief Arrays as scripts that a page from file:// can load: block(name, {header}, "base64 of gzip").
 *
 * A page from file:// may load scripts beside it, but may not fetch files. Values are stored as differences to the
 * value `delta` places before, modulo 2^n, which compresses better. In a single page the scripts are part of it.
 *
 * \ingroup PageKit */
class PageKit_EXPORT PageBlocks
{
public:
  PageBlocks(std::string folder, bool isSingle, OutputPath outputPath);

  template <typename TValue>
  void
  Put(const std::string &         name,
      const std::vector<TValue> & values,
      std::size_t                 delta = 0,
      Json                        header = Json::object());
  /** Rows of reals as whole numbers of 16 or 32 bits between the least and the greatest of their column; values that
   * are not finite become the least. */
  template <typename TValue = std::uint16_t>
  void
  PutReals(const std::string & name, const SurfaceArray::ValueMatrix & rows);
  void
  PutJson(const std::string & name, const Json & value);

  /** The script elements of a single page; empty otherwise. */
  std::string
  Inline() const;
  /** The blocks of a single page as one script, for a file that is replaced while the page shows it. */
  std::string
  Script() const;

private:
  void
  PutBytes(const std::string & name, const Json & header, const std::string & bytes);
  void
  PutScript(const std::string & name, const std::string & script);

  std::string m_Folder;
  bool        m_IsSingle;
  OutputPath  m_OutputPath;

  std::vector<std::string> m_Scripts; // of a single page
};
} // namespace shapeton

#endif
