#ifndef shapetonColonPositionFiles_h
#define shapetonColonPositionFiles_h

#include "shapetonRemarks.h"
#include "shapetonColonLandmarkDocument.h"
#include "shapetonColonPosition.h"

namespace shapeton
{
/** An examination of the colon in one position, read from its folder. \ingroup SupineProne */
struct ColonPositionFiles
{
  ColonPosition position;
  /** Those that are known. */
  std::vector<ColonSegmentExtent> segments;
  /** "sha256:..." of all that was read; equal for equal examinations wherever they lie. */
  std::string identity;
  /** What is missing that registration can do without. */
  Remarks warnings;
};

/** Reads what VirtualColonoscopy has written into a folder: segmentation/centreline.vtp, flattening/flat.vtp,
 * landmarks/landmarks.json, landmarks/taeniae.vtp (may be missing where none were found), landmarks/folds-surface.vtp
 * (curvature) and folds/folds.csv.
 * \param name for messages, "supine" or "prone".
 * Throws InputError that names the file that is missing or malformed, and the tool that writes it.
 * \ingroup SupineProne */
SupineProne_EXPORT ColonPositionFiles
ReadColonPosition(const std::string & folder, const std::string & name);
} // namespace shapeton

#endif
