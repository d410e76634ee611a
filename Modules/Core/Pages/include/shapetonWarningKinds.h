#ifndef shapetonWarningKinds_h
#define shapetonWarningKinds_h

#include "ShapetonPagesExport.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Warnings that differ only in their numbers and quoted names. \ingroup ShapetonPages */
struct WarningKind
{
  /** The common text of the warnings, with an ellipsis for each number or name that differs. */
  std::string              text;
  std::vector<std::string> warnings;
};

/** The kinds of a list, the most severe first: failures and missing results, doubtful results, and the rest. Kinds
 * of equal severity, and the warnings of a kind, keep their order. \ingroup ShapetonPages */
ShapetonPages_EXPORT std::vector<WarningKind>
                     KindsOf(const std::vector<std::string> & warnings);
} // namespace shapeton

#endif
