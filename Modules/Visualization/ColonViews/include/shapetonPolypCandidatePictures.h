#ifndef shapetonPolypCandidatePictures_h
#define shapetonPolypCandidatePictures_h

#include "ShapetonColonViewsExport.h"

#include "shapetonPerspectiveRendering.h"
#include "shapetonPicture.h"
#include "shapetonPolypSearch.h"

#include <memory>

namespace shapeton
{
/** \class PolypCandidatePictures
 * \brief Close-ups of each candidate, as in Figures 3.10 and 5.6 of the dissertation, and the flat colon with
 * all candidates.
 *
 * The head is tinted in all pictures. Identical input yields identical bytes for any number of threads. The colon must
 * outlive the object; its wall and flat map are required, and the centerline for endoluminal views.
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

  /** Relief of the full-resolution wall around the candidate on the flat map, 60 mm wide, less where the map shrinks
   * the wall. A head that is too small to be seen, such as one on a stalk, is marked and shown magnified in the lower
   * right corner. 400 x 300 pixels. */
  Picture::Pointer
  DrawCloseUp(const PolypCandidate & candidate) const;

  /** Camera of the endoluminal view, which looks at the center of the head. Tries centerline points 15 to 60 mm away,
   * ordered by slant and distance (25 mm is best), then points 3 to 25 mm above the head. Uses the first point from
   * which 40 % of the head is visible, or otherwise the one from which most of it is visible. */
  PerspectiveCamera
  EndoluminalCamera(const PolypCandidate & candidate) const;

  /** Endoluminal view of the candidate, 400 x 300 pixels. */
  Picture::Pointer
  DrawFromWithin(const PolypCandidate & candidate) const;

  /** Crops of 60 mm or more of the CT and, where it differs, of the cleansed CT (rows) in the axial, coronal, sagittal
   * and an oblique plane (columns), each in a soft-tissue window (-160 to 240 HU) and a colon window (-950 to 550 HU);
   * marks at the borders point to the center of the head. Null without a CT. */
  Picture::Pointer
  DrawCrops(const PolypCandidate & candidate) const;

  /** The crops, and to their right the endoluminal view and the close-up. */
  Picture::Pointer
  DrawCard(const PolypCandidate & candidate) const;

private:
  struct Data;
  std::unique_ptr<const Data> m_Data;
};
} // namespace shapeton

#endif
