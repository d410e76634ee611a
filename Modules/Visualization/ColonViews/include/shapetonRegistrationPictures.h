#ifndef shapetonRegistrationPictures_h
#define shapetonRegistrationPictures_h

#include "ShapetonColonViewsExport.h"

#include "shapetonPicture.h"
#include "shapetonRegistrationResults.h"

namespace shapeton
{
/** \defgroup RegistrationPictures Pictures of a colon in two positions Results may be newly computed or read by
 * ReadRegistrationResults(). Identical parts yield identical bytes for any number of threads. All throw InputError if
 * the results belong to other examinations.
 * \ingroup ShapetonColonViews */
///@{

/** Inputs of the pictures. Not owned. */
struct RegistrationParts
{
  const ColonPositionFiles *  supine{ nullptr };
  const ColonPositionFiles *  prone{ nullptr };
  const RegistrationResults * results{ nullptr };
};

/** Resolution of the pictures. */
struct AlignedColonsOptions
{
  /** Pixels around the tube. */
  int pixelsAround{ 150 };
  /** Maximum length of a row, pixels. */
  int greatestColumns{ 1500 };
};

/** Both flat walls in paired rows: the supine one, and below it the prone one in the supine frame, so mapped points are
 * aligned. Matched folds share a color and are joined by a line (red if the map, or known points, contradict the
 * pair); unmatched folds are black; excluded sections are hatched. */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawAlignedColons(const RegistrationParts & parts, const AlignedColonsOptions & options = {});

/** Checkerboard of the curvature of both walls in the supine frame; folds continue from square to square where the map
 * is correct. */
ShapetonColonViews_EXPORT Picture::Pointer
DrawCurvatureCheckerboard(const RegistrationParts & parts, const AlignedColonsOptions & options = {});

/** Confidence along the supine colon: mean and minimum around the tube; excluded sections are gray. */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawConfidenceChart(const RegistrationParts & parts);

/** Errors of the points along the supine colon, one dot per counted point. Throws std::invalid_argument without
 * points. */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawErrorChart(const RegistrationParts & parts);
///@}
} // namespace shapeton

#endif
