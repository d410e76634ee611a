#ifndef shapetonTerminalIleum_h
#define shapetonTerminalIleum_h

#include "shapetonIleocecalValve.h"

namespace shapeton
{
/** \class TerminalIleum
 * \brief The part of the lumen in the ileum, formed by gas or tagged fluid that passed back through the valve.
 * \ingroup ShapetonColonModel */
struct TerminalIleum
{
  /** On the grid of the labels, 1 inside. */
  LumenMask::Pointer mask;
  /** Center of the opening into the colon, LPS, mm. */
  Eigen::Vector3d mouth{ Eigen::Vector3d::Zero() };
  /** Length, mm: that of the line through the ileum, or the straight distance from the mouth to the farthest point if
   * the ileum is a side branch of the colon. */
  double length{ 0.0 };
  /** Volume, ml. */
  double volume{ 0.0 };
};

/** Finds the terminal ileum in a lumen: a connected region of lumen at least 4 mm away from the morphological opening
 * of the lumen by a ball with a radius of 8.5 mm. The region is attached to the colon only within 25 mm of the valve,
 * extends at least 30 mm, and does not contain any point of the centerline. These rules prevent the removal of colon:
 * corners of haustra are shallower, loops of colon are wider, and an appendix is attached elsewhere. If there
 * is none, the ileum may be distended: a part of the lumen behind a slit of at most 8 mm within 25 mm of the valve,
 * with an inscribed radius of at most 15 mm, and otherwise the same. Empty if not found.
 *
 * \param labels nonzero voxels are lumen.
 * \param centerline as for FindIleocecalValve(). The result does not depend on the number of threads.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::optional<TerminalIleum>
FindTerminalIleum(const LumenMask * labels, const CurveSet & centerline, const IleocecalValve & valve);

/** Finds an ileum that was filled by reflux through the valve and that contains the end of the line. The cecum is then
 * a pouch of lumen beside the line, at least 21 mm deep beyond the inscribed ball and at least 1 ml in volume. After
 * the pouch, the line continues for at least 40 mm, with an inscribed radius of at most 15 mm along three quarters of
 * its length. The median radii of this part and of its first 100 mm are at most 12.5 mm, and 3/4 of the median radius
 * of the 150 mm before it. The ileum is the lumen around the line after its narrowest place next to the pouch. Empty if
 * not found; fast if the line does not have a narrow end.
 *
 * \param labels nonzero voxels are lumen.
 * \param centerline LPS, mm, one curve with point arrays `arcLength`, `radius` and `gap`, from the rectum.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::optional<TerminalIleum>
                          FindRefluxedIleum(const LumenMask * labels, const CurveSet & centerline);

/** Finds an ileum at the end of the line if the valve is near the pole, so that the cecum forms no pouch beside the
 * line. The line passes a place with a radius of at most 4 mm, or a gap, within 15 mm of a valve that
 * FindIleocecalValve() finds with a confidence of at least .9 if the line ends there. Behind it, it continues for at
 * least 120 mm, longer than a cecum, and narrow as for FindRefluxedIleum(). Empty if not found; fast if the line does
 * not have a narrow end. \param ct HU, cleansed, or null; the other parameters are as for FindRefluxedIleum().
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::optional<TerminalIleum>
FindIleumBehindValve(const LumenMask * labels, const itk::Image<float, 3> * ct, const CurveSet & centerline);

/** Sets the voxels of an image inside the ileum to 0; the grids may differ. \ingroup ShapetonColonModel */
template <typename TImage>
void
TakeOut(const TerminalIleum & ileum, TImage * image);
extern template ShapetonColonModel_EXPORT void
TakeOut(const TerminalIleum &, LumenMask *);
extern template ShapetonColonModel_EXPORT void
TakeOut(const TerminalIleum &, itk::Image<float, 3> *);
} // namespace shapeton

#endif
