#ifndef shapetonPolypCandidatePictures_h
#define shapetonPolypCandidatePictures_h

#include "ColonViewsExport.h"

#include "shapetonPicture.h"
#include "shapetonPolypSearch.h"

#include <memory>

namespace shapeton
{
/** \class PolypCandidatePictures
 * \brief Each candidate close by, as Figures 3.10 and 5.6 of the dissertation show polyps, and all on the flat colon.
 *
 * The head is tinted in all pictures. Equal input gives equal bytes for any number of threads. The colon must outlive
 * the object; its wall and flat map are needed, and the centreline for views from within.
 * \ingroup ColonViews */
class ColonViews_EXPORT PolypCandidatePictures
{
public:
  /** Throws InputError where the colon has no flat map, and as FlatColonGrid does. */
  PolypCandidatePictures(const PolypColon & colon, const std::vector<PolypCandidate> & candidates);
  ~PolypCandidatePictures();

  /** The flat colon in rows, a ring with its number around each candidate. */
  Picture::Pointer
  DrawFlatColon() const;

  /** The relief of the wall of full resolution on the flat map around it, with pixels a quarter of those of
   * DrawFlatColon(), and enlarged further where the map is so small that more than 60 mm of wall would be seen. 400 x
   * 300 pixels. */
  Picture::Pointer
  DrawCloseUp(const PolypCandidate & candidate) const;

  /** What an endoscope on the centreline sees that looks at the candidate. Of the places of the centreline 15 to 60 mm
   * away the one is taken from which the apex is seen best: not hidden, facing the eye, about 25 mm away. Where the
   * centreline is not known, or the candidate is hidden from it, the eye is above the head, 6 to 25 mm away. */
  Picture::Pointer
  DrawFromWithin(const PolypCandidate & candidate) const;

  /** Close-up and view from within, side by side, with a title. */
  Picture::Pointer
  DrawCandidate(const PolypCandidate & candidate) const;

private:
  struct Data;
  std::unique_ptr<const Data> m_Data;
};
} // namespace shapeton

#endif
