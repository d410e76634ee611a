#ifndef shapetonWarningKinds_h
#define shapetonWarningKinds_h

#include <string>
#include <vector>

namespace shapeton
{
/** Warnings that are the same but for their numbers and quoted names.
 * \ingroup Report */
struct WarningKind
{
  /** What the warnings have in common, with an ellipsis for each number or name that differs. */
  std::string              text;
  std::vector<std::string> warnings;
};

/** The kinds of a list, the worst first: what failed or is missing, what is doubtful, and the rest. Equally bad ones,
 * and the warnings of a kind, keep their order. \ingroup Report */
std::vector<WarningKind>
KindsOf(const std::vector<std::string> & warnings);
} // namespace shapeton

#endif
