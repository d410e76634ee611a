#ifndef shapetonColonoscopyLimitations_h
#define shapetonColonoscopyLimitations_h

#include "ShapetonColonToolsExport.h"
#include "shapetonColonoscopyQuality.h"

#include <optional>

namespace shapeton
{
/** Something that an examination does not show, or does not show reliably. */
struct Limitation
{
  /** Text for the reader, with segment, distance and slices. */
  std::string text;
  /** Where it is best seen; LPS, mm. */
  std::optional<Eigen::Vector3d> place;
};

/** Ordered by severity: an incomplete examination; stretches without visible wall, the longest first; polyps below the
 * resolution; wall that the flat map does not show; wall under fluid and residue; doubtful landmarks, registration and
 * loops. */
ShapetonColonTools_EXPORT std::vector<Limitation>
                          LimitationsOf(const ColonoscopyResults & results, const ColonoscopyQuality & quality);

/** The limitations as JSON: note, the sentence on category C0 or "", and limitations, their texts. */
ShapetonColonTools_EXPORT Json
LimitationsToJson(const ColonoscopyResults & results, const ColonoscopyQuality & quality);

/** The sentence of the first page on category C0; "" without a reason. */
std::string
NoteOfInadequate(const ColonoscopyResults & results, const ColonoscopyQuality & quality);

/** Why a reader should consider category C0 (inadequate) of C-RADS: parts of the colon are missing or segments are not
 * evaluable in any position; "" without a reason. */
ShapetonColonTools_EXPORT std::string
                          ReasonForInadequate(const ColonoscopyResults & results, const ColonoscopyQuality & quality);
} // namespace shapeton

#endif
