#ifndef RepositoryRules_h
#define RepositoryRules_h

#include "Fault.h"

#include <filesystem>

namespace rules
{
/** Every link of every Markdown file leads to a file, or a heading of one, inside the repository; addresses of the web
 * are not followed. */
Faults
CheckLinks(const std::filesystem::path & root);

/** Every module and every tool has a README.md to which Documentation/index.md has a link, and Data/README.md names
 * every file or folder beside it. */
Faults
CheckPages(const std::filesystem::path & root);

/** No file is larger than 1 MB. */
Faults
CheckSizes(const std::filesystem::path & root);

/** No text names a folder of somebody's machine; no source carries a licence or copyright of its own, which a copied
 * one would. */
Faults
CheckTexts(const std::filesystem::path & root);

/** No tool is longer than 150 lines: it parses, calls and writes, and what is more belongs in a module. */
Faults
CheckTools(const std::filesystem::path & root);
} // namespace rules

#endif
