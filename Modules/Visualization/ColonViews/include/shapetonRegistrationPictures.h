#ifndef shapetonRegistrationPictures_h
#define shapetonRegistrationPictures_h

#include "ColonViewsExport.h"

#include "shapetonPicture.h"
#include "shapetonRegistrationResults.h"

namespace shapeton
{
/** \defgroup RegistrationPictures Pictures of a colon in two positions
 * All are of files alone: of results that were just made, or read back by ReadRegistrationResults(). Equal parts give
 * equal bytes for any number of threads. Throw InputError where the results are of other examinations.
 * \ingroup ColonViews */
///@{

/** Nothing is owned. */
struct RegistrationParts
{
  const ColonPositionFiles *  supine{ nullptr };
  const ColonPositionFiles *  prone{ nullptr };
  const RegistrationResults * results{ nullptr };
};

/** How much is shown. */
struct AlignedColonsOptions
{
  /** Pixels around the tube. */
  int pixelsAround{ 150 };
  /** Pixels of the longest row. */
  int greatestColumns{ 1500 };
};

/** Both flat walls row under row: the supine one, and below it the prone one in the supine frame, so that what the map
 * takes for the same lies at the same place across. Matched folds have one colour in both and a line from strip to
 * strip (red where the map contradicts the pair, or points tell that it is wrong), folds that stay alone are black;
 * excluded stretches are hatched. */
ColonViews_EXPORT Picture::Pointer
                  DrawAlignedColons(const RegistrationParts & parts, const AlignedColonsOptions & options = {});

/** The curvature of both walls in the supine frame in alternating squares: folds go on from square to square where the
 * map is right. */
ColonViews_EXPORT Picture::Pointer
                  DrawCurvatureCheckerboard(const RegistrationParts & parts, const AlignedColonsOptions & options = {});

/** The confidence along the supine colon: mean and least value around the tube; excluded stretches are grey. */
ColonViews_EXPORT Picture::Pointer
                  DrawConfidenceChart(const RegistrationParts & parts);

/** The errors of the points along the supine colon, a dot for each that counts. Throws std::invalid_argument where
 * there are no points. */
ColonViews_EXPORT Picture::Pointer
                  DrawErrorChart(const RegistrationParts & parts);
///@}
} // namespace shapeton

#endif
