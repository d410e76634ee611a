#ifndef shapetonScriptPage_h
#define shapetonScriptPage_h

#include "PageKitExport.h"
#include "shapetonPageBlocks.h"

#include <string>

namespace shapeton
{
/** \brief A page whose content is made by its script, from data blocks.
 *
 * It opens from a file, and a policy within it forbids all requests to a network.
 *
 * \ingroup PageKit */
struct ScriptPage
{
  std::string title;  // plain text
  std::string style;  // after the style that all pages share, see PageStyle()
  std::string script; // defines what `start` calls
  std::string start;  // a statement, run when all blocks of a single page are there
};

/** The page as HTML. `blocks` gives the blocks of a single page.
 * \ingroup PageKit */
PageKit_EXPORT std::string
               TextOf(const ScriptPage & page, const PageBlocks & blocks);
} // namespace shapeton

#endif
