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
  /** "sha256:..." of all files read, independent of their location. */
  std::string identity;
  /** Warnings about missing optional data. */
  Remarks warnings;
};

/** Reads a folder written by VirtualColonoscopy: segmentation/centerline.vtp, flattening/flat.vtp,
 * landmarks/landmarks.json, landmarks/taeniae.vtp (absent if none were found), landmarks/folds-surface.vtp (curvature)
 * and folds/folds.csv.
 * \param name for messages, "supine" or "prone".
 * Throws InputError with the name of the missing or malformed file and the tool that writes it.
 * \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT ColonPositionFiles
ReadColonPosition(const std::string & folder, const std::string & name);
} // namespace shapeton

#endif
