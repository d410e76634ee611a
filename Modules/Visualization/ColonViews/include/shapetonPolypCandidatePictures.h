#ifndef shapetonPolypCandidatePictures_h
#define shapetonPolypCandidatePictures_h

#include "ShapetonColonViewsExport.h"

#include "shapetonPicture.h"
#include "shapetonPolypSearch.h"

#include <memory>

namespace shapeton
{
/** \class PolypCandidatePictures
 * \brief Close-ups of each candidate, as in Figures 3.10 and 5.6 of the dissertation, and the flat colon with
 * all candidates.
 *
 * The head is tinted in all pictures. Equal input gives equal bytes for any number of threads. The colon must outlive
 * the object; its wall and flat map are required, and the centerline for endoluminal views.
 * \ingroup ShapetonColonViews */
class ShapetonColonViews_EXPORT PolypCandidatePictures
{
public:
  /** Throws InputError if the colon has no flat map, and the exceptions of FlatColonGrid. */
  PolypCandidatePictures(const PolypColon & colon, const std::vector<PolypCandidate> & candidates);
  ~PolypCandidatePictures();

  /** The flat colon in rows, with a numbered ring around each candidate. */
  Picture::Pointer
  DrawFlatColon() const;

  /** Relief of the full-resolution wall around the candidate on the flat map. Pixels are at most a quarter of the
   * pixels of DrawFlatColon(); at most 60 mm of wall are visible. 400 x 300 pixels. */
  Picture::Pointer
  DrawCloseUp(const PolypCandidate & candidate) const;

  /** Endoluminal view of the candidate from the centerline. Among the points of the centerline 15 to 60 mm away, picks
   * the one with the best view of the apex: not occluded, facing the eye, about 25 mm away. Without a centerline, or if
   * the candidate is occluded, the eye is above the head, 6 to 25 mm away. */
  Picture::Pointer
  DrawFromWithin(const PolypCandidate & candidate) const;

  /** Close-up and endoluminal view, side by side, with a title. */
  Picture::Pointer
  DrawCandidate(const PolypCandidate & candidate) const;

private:
  struct Data;
  std::unique_ptr<const Data> m_Data;
};
} // namespace shapeton

#endif
