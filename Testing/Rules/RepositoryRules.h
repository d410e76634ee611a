#ifndef RepositoryRules_h
#define RepositoryRules_h

#include "Fault.h"

#include <filesystem>

namespace rules
{
/** Checks that every link of every Markdown file points to an existing file or heading inside the repository; web
 * addresses are not checked. */
Faults
CheckLinks(const std::filesystem::path & root);

/** Checks that every module and tool has a README.md linked by Documentation/index.md, and that Data/README.md names
 * every file and folder next to it. */
Faults
CheckPages(const std::filesystem::path & root);

/** Checks that files are not larger than 1 MB. */
Faults
CheckSizes(const std::filesystem::path & root);

/** Checks that texts do not contain machine-specific paths, and that sources do not contain a license or copyright
 * notice, which would indicate copied code. */
Faults
CheckTexts(const std::filesystem::path & root);

/** Checks that tools have at most 150 lines: a tool parses options, calls modules and writes results. */
Faults
CheckTools(const std::filesystem::path & root);
} // namespace rules

#endif
