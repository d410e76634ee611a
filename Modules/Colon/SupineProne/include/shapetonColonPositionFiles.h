#ifndef shapetonColonPositionFiles_h
#define shapetonColonPositionFiles_h

#include "shapetonRemarks.h"
#include "shapetonColonLandmarkDocument.h"
#include "shapetonColonPosition.h"

namespace shapeton
{
/** An examination of the colon in one position, read from its folder. \ingroup ShapetonSupineProne */
struct ColonPositionFiles
{
  ColonPosition position;
  /** The known segments. */
  std::vector<ColonSegmentExtent> segments;
  /** "sha256:..." of all files read, regardless of their location. */
  std::string identity;
  /** Warnings about missing optional data. */
  Remarks warnings;
};
} // namespace shapeton

#endif
